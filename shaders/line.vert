#version 450 core
// shaders/line.vert: free segments, one instance each.
#include "frame.glsl"
#include "line.glsl"
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 tint;
uniform float width;
flat out vec4 color;
out float dash;

void main() {
  color = tint;
  dash = 0.0;
  placeCorner(lifted(from), lifted(to), width, gl_VertexID);
}
