// shaders/color.glsl: from light to what a screen shows.

// One step of an 8-bit sRGB picture, spread over +-1/2 by an ordered-looking noise: smooth shades do not band.
vec3 dithered(vec3 linear) {
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  vec3 slope = 2.2 * sqrt(max(linear, vec3(1e-4)));  // About d linear / d sRGB.
  return max(linear + noise * slope / 255.0, vec3(0.0));
}

// Khronos "PBR neutral": colors below 0.8 stay what they are, brighter ones roll off and pale. khronos.org, 2024.
vec3 toneMapped(vec3 color) {
  const float start = 0.76, desaturation = 0.15;
  float low = min(color.r, min(color.g, color.b));
  color -= low < 0.08 ? low - 6.25 * low * low : 0.04;
  float peak = max(color.r, max(color.g, color.b));
  if (peak < start) return color;
  float room = 1.0 - start;
  float shown = 1.0 - room * room / (peak + room - start);
  return mix(color * (shown / peak), vec3(shown), 1.0 - 1.0 / (desaturation * (peak - shown) + 1.0));
}
