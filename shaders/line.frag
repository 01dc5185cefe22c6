#version 450 core
// shaders/line.frag: a smooth-edged strip, broken into dashes where asked. Premultiplied.
in float acrossPixels;
flat in float halfWidth;
flat in vec4 color;
in float dash;
uniform float opacity;
layout(location = 0) out vec4 outColor;

void main() {
  float alpha = clamp(halfWidth + 0.5 - abs(acrossPixels), 0.0, 1.0) * color.a * opacity;
  float soft = fwidth(dash);
  if (soft > 0.0) alpha *= smoothstep(0.0, soft, 0.30 - abs(fract(dash) - 0.5));
  outColor = vec4(color.rgb * alpha, alpha);
}
