#version 450 core
// shaders/surface.frag: one of four shadings, SHADING_TEXTURED / _CLAY / _CLASSES / _HEAT, with WIRE edges or without.
#include "frame.glsl"
#include "color.glsl"
#include "lighting.glsl"

in Surface {
  vec3 world;
  vec3 normal;
  vec2 uv;
  float displacement;
} fragment;
#ifdef WIRE
noperspective in vec3 edgePixels;
flat in vec3 altitudes;
#endif
layout(location = 0) out vec4 outColor;  // Linear; the framebuffer encodes.

uniform sampler2D baseMap;
uniform vec4 baseColor;
uniform vec4 finish;     // Metallic, roughness, alpha cutoff (below 0: none), 1 where the alpha blends.
uniform vec3 emissive;
uniform int unlit;
uniform float wireScale;
uniform vec4 heatStops[9];  // sRGB.
uniform float heatRange;    // Character units.
uniform ivec2 classLookup;  // First triangle of this draw, refined triangles per control triangle.
layout(std430, binding = 0) readonly buffer Classes { uint classOf[]; };

vec3 decoded(vec3 srgb) { return mix(srgb / 12.92, pow((srgb + 0.055) / 1.055, vec3(2.4)), step(0.04045, srgb)); }

#ifdef SHADING_HEAT
vec3 heatColor(float x) {
  float at = (clamp(x, -1.0, 1.0) * 0.5 + 0.5) * 8.0;
  int low = min(int(at), 7);
  return decoded(mix(heatStops[low].rgb, heatStops[low + 1].rgb, at - float(low)));
}
#endif

vec3 pigment() {
#if defined(SHADING_HEAT)
  return heatColor(fragment.displacement / heatRange);
#elif defined(SHADING_CLASSES)
  uint kind = classOf[(classLookup.x + gl_PrimitiveID) / classLookup.y];
  return kind == 2u ? vec3(0.72, 0.20, 0.10) : kind == 1u ? vec3(0.80, 0.48, 0.09) : vec3(0.17, 0.27, 0.40);
#else
  return vec3(0.455, 0.420, 0.385);
#endif
}

void main() {
  vec3 v = toEye(fragment.world);
  vec3 n = normalize(fragment.normal) * (gl_FrontFacing ? 1.0 : -1.0);
  vec3 cameraUp = vec3(viewFromWorld[0][1], viewFromWorld[1][1], viewFromWorld[2][1]);
  vec3 right = normalize(cross(cameraUp, v));
  vec3 up = cross(v, right);
  float alpha = 1.0;
#ifdef SHADING_TEXTURED
  vec4 base = baseColor * texture(baseMap, fragment.uv);
  if (base.a < finish.z) discard;
  if (finish.w > 0.5) alpha = base.a;
  vec3 color = unlit != 0 ? base.rgb
                          : dithered(toneMapped(studio(base.rgb, finish.x, finish.y, n, v, right, up) + emissive));
#else
  vec3 m = vec3(dot(n, right), dot(n, up), dot(n, v));
  vec3 color = dithered(toneMapped(pigment() * clayLight(m) + clayGloss(m)));
#endif
#ifdef WIRE
  float nearest = min(edgePixels.x, min(edgePixels.y, edgePixels.z));
  float thin = min(altitudes.x, min(altitudes.y, altitudes.z));
  float line = (1.0 - smoothstep(0.5 * wireScale - 0.25, 0.5 * wireScale + 0.75, nearest)) * mix(0.18, 0.62, smoothstep(2.0, 9.0, thin / wireScale));
  color = mix(color, vec3(0.012, 0.013, 0.016), line);
#endif
  outColor = vec4(color * alpha, alpha);
}
