#version 450 core
// shaders/ellipsoid.frag: a glass shell: clear where it faces the eye, thick towards its rim. Premultiplied.
#include "frame.glsl"
in vec3 world;
in vec3 shapeNormal;
flat in vec4 color;
flat in vec4 look;
uniform float opacity;
uniform float inner;  // 1: the far wall, seen from inside.
layout(location = 0) out vec4 outColor;

void main() {
  vec3 n = normalize(shapeNormal);
  vec3 v = toEye(world);
  float facing = abs(dot(n, v));
  float away = 1.0 - facing;
  float rim = away * away * mix(away, 1.0, 0.4);
  float light = 0.60 + 0.34 * dot(n, key.xyz) + 0.24 * max(n.y, 0.0);
  vec3 h = normalize(v + key.xyz);
  float shine = max(dot(n, h), 0.0);
  shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine;
  float glow = 0.35 * look.x + 0.55 * look.y;
  float alpha = color.a * (0.95 + 0.30 * glow + 2.4 * rim) * (1.0 - 0.68 * inner);
  vec3 shown = color.rgb * (0.9 * light + 0.35 * glow) + 0.9 * mix(color.rgb, vec3(1.0), 0.12) * rim;
  alpha = clamp(alpha, 0.0, 1.0) * opacity;
  float glint = 0.22 * shine * (1.0 - inner) * opacity * min(3.0 * color.a, 1.0);
  outColor = vec4(shown * alpha + glint, min(alpha + 0.5 * glint, 1.0));
}
