#version 450 core
// shaders/glass.frag: the skin as glass over the muscles: clear where it faces the eye, lit and in its own color
// towards its rim. With WIRE edges or without. Premultiplied. With DEPTH_ALONE it only says where glass is.
#include "frame.glsl"
#include "color.glsl"
#include "brdf.glsl"
#include "lighting.glsl"

in Surface {
  vec3 world;
  vec3 normal;
  vec2 uv;
  float displacement;
  vec2 skin;
  vec4 color;
} fragment;
#ifdef WIRE
noperspective in vec3 edgePixels;
flat in vec3 altitudes;
#endif
layout(location = 0) out vec4 outColor;

uniform sampler2D baseMap;
uniform vec4 baseColor;
uniform vec4 finish;  // As in surface.frag.
uniform int plain;    // 1: clay instead of the material.
uniform float clear;  // 0: the skin as it is; 1: all but its rim is clear.
uniform float lineScale;
uniform vec3 contourColor;

void main() {
  if (!gl_FrontFacing) discard;
  vec4 base = baseColor * texture(baseMap, fragment.uv) * clamp(fragment.color, 0.0, 1.0);
  if (base.a < finish.z - 1e-5) discard;
#ifndef DEPTH_ALONE
  vec4 surface = plain != 0 ? vec4(0.360, 0.356, 0.350, 0.0) : vec4(base.rgb, finish.x);
  vec3 v = toEye(fragment.world);
  vec3 n = normalize(fragment.normal);
  vec3 cameraUp = vec3(viewFromWorld[0][1], viewFromWorld[1][1], viewFromWorld[2][1]);
  vec3 right = normalize(cross(cameraUp, v));
  vec3 up = cross(v, right);
  vec3 open = openness(fragment.skin.x, fragment.world, n.y);
  vec3 lit = studio(surface.rgb, surface.a, plain != 0 ? 0.6 : finish.y, n, v, right, up, open, 1.0);
  float facing = abs(dot(n, v)), away = 1.0 - facing;
  float body = (1.0 - clear) * (1.0 - clear);
  float rim = mix(1.0, 0.72, clear) * pow(away, mix(1.2, 2.8, clear));
  float alpha = body + (1.0 - body) * rim;
  // A fine outline, so that thin limbs are seen as well.
  float contour = 1.0 - smoothstep(0.4 * lineScale, 1.9 * lineScale, facing / max(fwidth(facing), 1e-4));
  contour *= clear;
  alpha = max(alpha, 0.56 * contour);
  // Glass has a light of its own at its rim, and mirrors the lamp.
  vec3 own = 0.30 * lit + 0.85 * hemisphere(n.y) + 0.10 * kKeyColor * max(dot(n, studioKey()), 0.0);
  vec3 shown = toneMapped(mix(lit, own, clear * (0.35 + 0.65 * away)));
  shown = mix(shown, contourColor, 0.8 * contour);
  float glint = clear * 0.035 * min(highlight(n, v, studioKey(), 0.30), 4.0);
#ifdef WIRE
  float nearest = min(edgePixels.x, min(edgePixels.y, edgePixels.z));
  float thin = min(altitudes.x, min(altitudes.y, altitudes.z));
  float line = (1.0 - smoothstep(0.5 * lineScale - 0.35, 0.5 * lineScale + 0.75, nearest)) *
               mix(0.10, 0.62, smoothstep(2.0, 10.0, thin / lineScale));
  shown = mix(shown, mix(vec3(0.016, 0.014, 0.016), vec3(0.30), clear), line);
  alpha = max(alpha, mix(1.0, 0.45, clear) * line);
#endif
  glint = min(glint, 1.0);
  outColor = vec4(dithered(shown * alpha + glint), min(alpha + 0.5 * glint, 1.0));
#endif
}
