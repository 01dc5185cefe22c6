#version 450 core
// shaders/bone.frag: bones and joints, lit from the eye, paler the further off. Premultiplied.
#include "frame.glsl"
in vec3 world;
in vec3 shapeNormal;
flat in vec4 color;
flat in vec4 look;
uniform vec2 depthRange;  // Along the view: nearest and furthest of all joints.
uniform float contour;    // 1: the dark edge around bones.
layout(location = 0) out vec4 outColor;

void main() {
  vec3 n = normalize(shapeNormal);
  vec3 v = toEye(world);
  vec3 right = vec3(viewFromWorld[0][0], viewFromWorld[1][0], viewFromWorld[2][0]);
  vec3 up = vec3(viewFromWorld[0][1], viewFromWorld[1][1], viewFromWorld[2][1]);
  float lit = 0.5 + 0.5 * dot(n, normalize(0.55 * v + 0.75 * up - 0.65 * right));
  float away = 1.0 - max(dot(n, v), 0.0);
  float far = smoothstep(0.0, 1.0, (dot(world, forward.xyz) - depthRange.x) / depthRange.y) * (1.0 - look.y);
  vec3 shown = color.rgb * (0.09 + 0.98 * lit * lit + 0.28 * look.y) + 0.10 * away * away * color.rgb;
  shown *= 1.0 - 0.42 * far;
  float alpha = color.a * (1.0 - 0.50 * far);
  shown = mix(shown, vec3(0.010, 0.011, 0.014), contour);
  alpha *= mix(1.0, 0.72, contour);
  outColor = vec4(shown * alpha, alpha);
}
