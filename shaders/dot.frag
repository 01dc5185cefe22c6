#version 450 core
// shaders/dot.frag: a smooth-edged disc with a dark border. Premultiplied.
flat in vec4 color;
flat in float radius;
in vec2 fromCenter;
uniform float opacity;
layout(location = 0) out vec4 outColor;

void main() {
  float away = length(fromCenter);
  float alpha = clamp(radius + 0.5 - away, 0.0, 1.0) * color.a * opacity;
  float face = clamp(0.68 * radius + 0.5 - away, 0.0, 1.0);
  outColor = vec4(mix(vec3(0.012), color.rgb, face) * alpha, alpha);
}
