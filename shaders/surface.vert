#version 450 core
// shaders/surface.vert: the smoothed surface, streamed in world space.
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float displacement;
layout(location = 3) in vec2 uv;

out Surface {
  vec3 world;
  vec3 normal;
  vec2 uv;
  float displacement;
} vertex;

void main() {
  vertex.world = position;
  vertex.normal = normal;
  vertex.uv = uv;
  vertex.displacement = displacement;
  gl_Position = clipFromWorld * vec4(position, 1.0);
}
