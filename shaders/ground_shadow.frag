#version 450 core
// shaders/ground_shadow.frag: the character's shadow and contact on the floor. Premultiplied.
#include "frame.glsl"
in vec2 at;
uniform sampler2D shadow;
layout(location = 0) out vec4 outColor;

void main() {
  vec2 shade = texture(shadow, at).xy;
  float dark = 1.0 - (1.0 - 0.70 * shade.x) * (1.0 - 0.55 * shade.y);
  outColor = vec4(0.0, 0.0, 0.0, eye.w > 0.5 || eye.y > picture.w ? dark : 0.35 * dark);
}
