#version 450 core
// shaders/bone.frag: bones and joints, lit from the eye. Premultiplied.
#include "frame.glsl"
in vec3 world;
in vec3 shapeNormal;
flat in vec4 color;
flat in vec4 look;
layout(location = 0) out vec4 outColor;

void main() {
  vec3 n = normalize(shapeNormal);
  vec3 v = toEye(world);
  vec3 right = vec3(viewFromWorld[0][0], viewFromWorld[1][0], viewFromWorld[2][0]);
  vec3 up = vec3(viewFromWorld[0][1], viewFromWorld[1][1], viewFromWorld[2][1]);
  float lit = 0.5 + 0.5 * dot(n, normalize(0.55 * v + 0.75 * up - 0.65 * right));
  vec3 shown = color.rgb * (0.10 + 0.95 * lit * lit + 0.25 * look.y);
  outColor = vec4(shown * color.a, color.a);
}
