#version 450 core
// shaders/depth.vert: the smoothed surface where only its shape counts.
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 3) in vec2 uv;
layout(location = 5) in vec4 color;  // Without colors its alpha is 1, OpenGL's default.
out vec3 world;
out vec3 shapeNormal;
out vec2 mapAt;
out float vertexAlpha;
invariant gl_Position;  // As in surface.vert: what is drawn over the surface lies at its depth.

void main() {
  world = position;
  shapeNormal = normal;
  mapAt = uv;
  vertexAlpha = color.a;
  gl_Position = clipFromWorld * vec4(position, 1.0);
}
