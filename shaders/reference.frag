#version 450 core
// shaders/reference.frag: a picture to work after. Premultiplied.
in vec2 at;
uniform sampler2D pixels;
uniform float opacity;
layout(location = 0) out vec4 outColor;

void main() {
  vec4 color = texture(pixels, at);
  outColor = vec4(color.rgb * color.a, color.a) * opacity;
}
