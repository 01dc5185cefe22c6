#version 450 core
// shaders/occlusion.frag: how much of its surroundings a place of the surface sees, from what the picture shows of them.
// Source: McGuire et al., "Scalable ambient obscurance", HPG 2012, equation 3; taps on a spiral.
#include "frame.glsl"
uniform sampler2D surface;  // As depth.frag writes it.
// A pixel of the picture as a direction of which 1 goes along the view; without perspective, as a place at distance 0.
uniform vec3 corner;
uniform vec3 stepX;
uniform vec3 stepY;
uniform vec4 reach;  // World radius, pixels of that radius at distance 1, turn and shift of the spiral in this sample.
uniform int taps;
layout(location = 0) out float open;

// World position, from the eye, of a pixel at a distance along the view.
vec3 placeAt(vec2 pixel, float away) {
  vec3 at = corner + stepX * pixel.x + stepY * pixel.y;
  return eye.w > 0.5 ? at + forward.xyz * away : at * away;
}

const float kStrength = 6.0;

// Interleaved gradient noise: neighbors differ as much as they can.
float noise(vec2 at) { return fract(52.9829189 * fract(dot(at, vec2(0.06711056, 0.00583715)))); }

void main() {
  vec4 here = texelFetch(surface, ivec2(gl_FragCoord.xy), 0);
  open = 1.0;
  if (here.w == 0.0) return;
  vec3 place = placeAt(gl_FragCoord.xy, here.w);
  float pixels = clamp(reach.y / (eye.w > 0.5 ? 1.0 : here.w), 2.0, 0.3 * picture.y);
  float start = 6.2831853 * fract(noise(gl_FragCoord.xy) + reach.z);
  float shift = fract(noise(gl_FragCoord.yx + vec2(31.0, 17.0)) + reach.w);
  float limit = reach.x * reach.x, bias = 0.025 * reach.x, sum = 0.0;
  for (int i = 0; i < taps; ++i) {
    float share = (float(i) + shift) / float(taps);
    float angle = start + 2.3999632 * float(i);
    vec2 pixel = floor(gl_FragCoord.xy + vec2(cos(angle), sin(angle)) * max(share * pixels, 1.0)) + 0.5;
    if (any(lessThan(pixel, vec2(0.0))) || any(greaterThan(pixel, picture.xy))) continue;
    vec4 there = texelFetch(surface, ivec2(pixel), 0);
    if (there.w == 0.0) continue;
    vec3 towards = placeAt(pixel, there.w) - place;
    float square = dot(towards, towards);
    float fall = max(limit - square, 0.0) / limit;
    sum += fall * fall * max(dot(towards, here.xyz) - bias, 0.0) / (square + 0.01 * limit) * reach.x;
  }
  open = 1.0 / (1.0 + kStrength * sum / float(taps));
}
