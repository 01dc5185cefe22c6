#version 450 core
// shaders/ellipsoid.frag: a glass shell: clear where it faces the eye, thick towards its rim, hatched where it carves,
// lined where it meets what is drawn already. Premultiplied.
#include "frame.glsl"
in vec3 world;
in vec3 shapeNormal;
flat in vec4 color;
flat in vec4 look;  // Selected, hovered, carving.
uniform float opacity;
uniform float inner;       // 1: the far wall, seen from inside.
uniform float meets;       // 1: with a line where the shell meets the skin.
uniform float lineScale;
uniform vec4 depthScale;   // Elements (2, 2) and (3, 2) of the projection.
layout(binding = 0) uniform sampler2D drawnDepth;
layout(location = 0) out vec4 outColor;

// Along the view, character units.
float distanceOf(float depth) {
  float clip = 2.0 * depth - 1.0;
  return eye.w > 0.5 ? (depthScale.y - clip) / depthScale.x : depthScale.y / (clip + depthScale.x);
}

void main() {
  vec3 n = normalize(shapeNormal);
  vec3 v = toEye(world);
  float facing = abs(dot(n, v));
  float away = 1.0 - facing;
  float rim = away * away * mix(away, 1.0, 0.4);
  float light = 0.60 + 0.34 * dot(n, key.xyz) + 0.24 * max(n.y, 0.0);
  vec3 h = normalize(v + key.xyz);
  float shine = max(dot(n, h), 0.0);
  shine *= shine; shine *= shine; shine *= shine; shine *= shine; shine *= shine;
  float glow = 0.35 * look.x + 0.55 * look.y;
  float stripe = fract((gl_FragCoord.x + gl_FragCoord.y) / (9.0 * lineScale));
  float hatch = mix(1.0, stripe < 0.5 ? 1.7 : 0.35, look.z);
  float alpha = color.a * (0.95 + 0.30 * glow + 2.4 * rim) * hatch * (1.0 - 0.68 * inner);
  vec3 shown = color.rgb * (0.9 * light + 0.35 * glow) + 0.9 * mix(color.rgb, vec3(1.0), 0.12) * rim;
  shown *= 1.0 - 0.35 * inner;

  // How far it stands out of what was drawn before; under it the shell fades with depth.
  float own = distanceOf(gl_FragCoord.z);
  float drawn = distanceOf(texelFetch(drawnDepth, ivec2(gl_FragCoord.xy), 0).r);
  float out_ = drawn - own;
  float slope = fwidth(out_);
  float shownHere = out_ < 0.0 ? mix(0.30, 1.0, exp(16.0 * out_ / picture.z)) : 1.0;
  alpha = clamp(alpha, 0.0, 1.0) * opacity * shownHere;
  float glint = 0.22 * shine * (1.0 - inner) * opacity * shownHere * min(3.0 * color.a, 1.0);
  vec4 sum = vec4(shown * alpha + glint, min(alpha + 0.5 * glint, 1.0));

  // Where the drawn surface jumps, as at the body's own outline, they do not meet; where it lies along the shell, as
  // skin that a muscle holds up, no line would be steady.
  vec3 there = eye.w > 0.5 ? world + out_ * forward.xyz : mix(eye.xyz, world, drawn / own);
  vec3 across = cross(dFdx(there), dFdy(there));
  float along = abs(dot(n, across)) * inversesqrt(max(dot(across, across), 1e-30));
  float near = meets * (1.0 - inner) * step(abs(out_), 0.02 * picture.z) * step(slope, 0.03 * picture.z);
  near *= 1.0 - smoothstep(0.75, 0.90, along);
  float pixels = abs(out_) / max(slope, 1e-7 * picture.z) / lineScale;
  float pale = near * (1.0 - smoothstep(1.5, 2.5, pixels)) * 0.85;
  float dark = near * (1.0 - smoothstep(0.4, 1.2, pixels)) * 0.80;
  vec3 paleColor = mix(color.rgb, vec3(1.0), 0.45);
  sum = vec4(paleColor * pale, pale) + (1.0 - pale) * sum;
  sum = vec4(vec3(0.012) * dark, dark) + (1.0 - dark) * sum;
  outColor = sum;
}
