#version 450 core
// shaders/ground_shadow.vert: the part of the floor that the shadow's texture covers.
#include "frame.glsl"
uniform vec4 area;  // As in shadow.vert.
out vec2 at;

void main() {
  at = vec2(gl_VertexID & 1, (gl_VertexID & 2) / 2);
  vec2 floor_ = area.xy + at / area.zw;
  gl_Position = clipFromWorld * vec4(floor_.x, picture.w, floor_.y, 1.0);
}
