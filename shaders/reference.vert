#version 450 core
// shaders/reference.vert: a square that shows a picture to work after.
#include "frame.glsl"
uniform mat4 squareInWorld;
out vec2 at;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, (gl_VertexID & 2) / 2);
  at = vec2(corner.x, 1.0 - corner.y);
  gl_Position = clipFromWorld * (squareInWorld * vec4(corner - 0.5, 0.0, 1.0));
}
