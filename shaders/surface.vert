#version 450 core
// shaders/surface.vert: the smoothed surface, streamed in world space.
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float displacement;
layout(location = 3) in vec2 uv;
layout(location = 4) in vec2 skin;
#ifdef COLORED
layout(location = 5) in vec4 color;
#endif

out Surface {
  vec3 world;
  vec3 normal;
  vec2 uv;
  float displacement;
  vec2 skin;  // How open to the sky, territory: 0..1.
#ifdef COLORED
  vec4 color;  // Linear.
#endif
} vertex;

void main() {
  vertex.world = position;
  vertex.normal = normal;
  vertex.uv = uv;
  vertex.displacement = displacement;
  vertex.skin = skin;
#ifdef COLORED
  vertex.color = color;
#endif
  gl_Position = clipFromWorld * vec4(position, 1.0);
}
