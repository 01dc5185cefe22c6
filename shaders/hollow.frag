#version 450 core
// shaders/hollow.frag: what a carve takes away: a dark hollow with a rim, seen through. Premultiplied.
#include "frame.glsl"
in vec3 world;
in vec3 shapeNormal;
in vec3 around;
in vec3 inMuscle;
flat in vec4 fibres;
flat in float glow;
uniform float inner;  // 1: the far wall, seen from inside.
layout(location = 0) out vec4 outColor;

void main() {
  float facing = abs(dot(normalize(shapeNormal), toEye(world)));
  float away = 1.0 - facing;
  float rim = away * away * away;
  float alpha = mix(0.10 + 0.50 * rim, 0.34 + 0.20 * facing, inner);
  vec3 shown = mix(vec3(0.030, 0.022, 0.030), vec3(0.20, 0.17, 0.20), rim * (1.0 - inner)) + 0.05 * glow;
  outColor = vec4(shown * alpha, alpha);
}
