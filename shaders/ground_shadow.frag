#version 450 core
// shaders/ground_shadow.frag: the character's shadow and contact on the floor. Premultiplied.
#include "frame.glsl"
in vec2 at;
uniform sampler2D shadow;
layout(location = 0) out vec4 outColor;

void main() {
  vec2 shade = texture(shadow, at).xy;
  float soft = shade.x * (0.55 + 0.45 * shade.x);  // Edges run out instead of ending.
  float dark = 1.0 - (1.0 - 0.66 * soft) * (1.0 - 0.74 * shade.y);
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  dark = max(dark + noise * min(dark, 1.0 / 128.0), 0.0);
  outColor = vec4(0.0, 0.0, 0.0, eye.w > 0.5 || eye.y > picture.w ? dark : 0.35 * dark);
}
