#version 450 core
// shaders/occlusion_blur.frag: takes the noise out, without mixing what lies at different depths.
uniform sampler2D surface;
uniform sampler2D source;
uniform int width;    // Pixels to each side.
uniform float range;  // Distance along the view at which a neighbor counts no more.
layout(location = 0) out float open;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(source, 0) - 1;
  vec4 here = texelFetch(surface, at, 0);
  open = 1.0;
  if (here.w == 0.0) return;
  float sum = 0.0, total = 0.0;
  for (int y = -width; y <= width; ++y) {
    for (int x = -width; x <= width; ++x) {
      ivec2 there = clamp(at + ivec2(x, y), ivec2(0), last);
      vec4 seen = texelFetch(surface, there, 0);
      float weight = max(1.0 - abs(seen.w - here.w) / range, 0.0) * max(dot(seen.xyz, here.xyz), 0.0);
      sum += weight * texelFetch(source, there, 0).r;
      total += weight;
    }
  }
  if (total > 0.0) open = sum / total;
}
