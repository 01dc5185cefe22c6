#version 450 core
// shaders/shadow.vert: the surface as it falls on the floor along the main light, seen from above.
#include "frame.glsl"
layout(location = 0) in vec3 position;
uniform vec4 area;  // x and z of the low corner, 1 / extent on each.
out float above;
#ifdef ALPHA
layout(location = 3) in vec2 uv;
layout(location = 5) in vec4 color;
out vec2 atMap;
out float vertexAlpha;
#endif

void main() {
#ifdef ALPHA
  atMap = uv;
  vertexAlpha = color.a;
#endif
  above = max(position.y - picture.w, 0.0);
  vec2 fallen = position.xz - key.xz / key.y * above;
  gl_Position = vec4((fallen - area.xy) * area.zw * 2.0 - 1.0, 0.0, 1.0);
}
