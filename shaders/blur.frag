#version 450 core
// shaders/blur.frag: one direction of a Gaussian; x (shadow) and y (contact) have their own widths.
in vec2 at;
uniform sampler2D source;
uniform vec2 sigmaX;  // Standard deviation as a step between texture coordinates, of x ...
uniform vec2 sigmaY;  // ... and of y.
layout(location = 0) out vec2 blurred;

// On each side. Few are enough where they lie about a texel apart.
#ifdef FEW_TAPS
const int kTapsX = 3, kTapsY = 2;
#else
const int kTapsX = 4, kTapsY = 4;
#endif
const float kReach = 2.22;  // Standard deviations up to the last tap.

float mean(int channel, int taps, vec2 sigma) {
  float sum = 0.0, total = 0.0;
  for (int i = -taps; i <= taps; ++i) {
    float away = float(i) / float(taps) * kReach;
    float w = exp(-0.5 * away * away);
    sum += w * texture(source, at + away * sigma)[channel];
    total += w;
  }
  return sum / total;
}

void main() { blurred = vec2(mean(0, kTapsX, sigmaX), mean(1, kTapsY, sigmaY)); }
