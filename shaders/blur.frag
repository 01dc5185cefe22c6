#version 450 core
// shaders/blur.frag: one direction of a Gaussian; x (shadow) and y (contact) have their own widths.
in vec2 at;
uniform sampler2D source;
uniform vec2 stepX;  // Texture coordinates between taps, for x ...
uniform vec2 stepY;  // ... and for y.
layout(location = 0) out vec2 blurred;

void main() {
  vec2 sum = vec2(0.0);
  float total = 0.0;
  for (int i = -4; i <= 4; ++i) {
    float w = exp(-0.5 * float(i * i) / 3.24);
    sum += w * vec2(texture(source, at + float(i) * stepX).x, texture(source, at + float(i) * stepY).y);
    total += w;
  }
  blurred = sum / total;
}
