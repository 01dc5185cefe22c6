#version 450 core
// shaders/background.frag: what stands behind the character.
in vec2 at;
uniform float aspect;
#ifdef CHOSEN_LOOK
uniform int kind;      // 0: a wall that is lighter behind the character, 1: from bottom to top, 2: a checkerboard.
uniform vec3 low;      // sRGB.
uniform vec3 high;
uniform float square;  // Side of a checkerboard's square, pixels.
#else
const int kind = 0;
const vec3 low = vec3(0.128, 0.133, 0.142);
const vec3 high = vec3(0.300, 0.309, 0.325);
const float square = 1.0;
#endif
layout(location = 0) out vec4 outColor;

void main() {
  vec2 from = (at - vec2(0.5, 0.54)) * vec2(min(aspect, 1.6), 1.0);
  float glow = max(1.0 - 0.95 * dot(from, from), 0.0);
  float share = glow * glow;
  if (kind == 1) share = smoothstep(0.0, 1.0, at.y);
  if (kind == 2) share = mod(floor(gl_FragCoord.x / square) + floor(gl_FragCoord.y / square), 2.0);
  vec3 srgb = mix(low, high, share);
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  srgb += noise / 255.0;
#ifdef CHOSEN_LOOK
  outColor = vec4(pow((srgb + 0.055) / 1.055, vec3(2.4)), 1.0);  // Nothing is below 0.04045.
#else
  // sRGB to linear, a cubic that is right to 1/1000 in this range: every pixel of every picture pays for it.
  outColor = vec4(srgb * (srgb * (srgb * 0.305306 + 0.682171) + 0.0125229), 1.0);
#endif
}
