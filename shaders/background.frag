#version 450 core
// shaders/background.frag: a dark studio wall, a little lighter behind the character.
in vec2 at;
uniform float aspect;
layout(location = 0) out vec4 outColor;

void main() {
  vec2 from = (at - vec2(0.5, 0.54)) * vec2(min(aspect, 1.6), 1.0);
  float glow = max(1.0 - 0.95 * dot(from, from), 0.0);
  vec3 srgb = mix(vec3(0.128, 0.133, 0.142), vec3(0.300, 0.309, 0.325), glow * glow);
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  srgb += noise / 255.0;
  // sRGB to linear, a cubic that is right to 1/1000 in this range: every pixel of every picture pays for it.
  outColor = vec4(srgb * (srgb * (srgb * 0.305306 + 0.682171) + 0.0125229), 1.0);
}
