#version 450 core
// shaders/surface.frag: one of four shadings, SHADING_TEXTURED / _CLAY / _CLASSES / _HEAT, with WIRE edges or without,
// with MARKED territory and bulges of the selected muscles or without, COLORED by the vertices or not, with each of the
// material's maps or without: NORMAL_MAP, ROUGHNESS_MAP, OCCLUSION_MAP (SHARED_MAP: it is the roughness map),
// EMISSIVE_MAP.
#include "frame.glsl"
#include "color.glsl"
#include "brdf.glsl"
#include "lighting.glsl"

in Surface {
  vec3 world;
  vec3 normal;
  vec2 uv;
  float displacement;
  vec2 skin;  // How open to the sky, territory: 0..1.
#ifdef COLORED
  vec4 color;  // Linear.
#endif
} fragment;
#ifdef WIRE
noperspective in vec3 edgePixels;
flat in vec3 altitudes;
#endif
layout(location = 0) out vec4 outColor;  // Linear; the framebuffer encodes.

uniform sampler2D baseMap;
layout(binding = 1) uniform sampler2D normalMap;
layout(binding = 2) uniform sampler2D roughnessMap;  // Green: roughness, blue: metallic.
layout(binding = 3) uniform sampler2D occlusionMap;  // Red.
layout(binding = 4) uniform sampler2D emissiveMap;
layout(binding = 5) uniform sampler2D occlusion;  // How much light near surfaces leave, per pixel.
uniform vec4 baseColor;
uniform vec4 finish;     // Metallic, roughness, alpha cutoff (below 0: none), 1 where the alpha blends.
uniform vec3 emissive;
uniform vec4 mapPlaces[8];  // Two rows for each map in the order above: uv and 1 -> where it is read.
uniform vec2 mapStrengths;  // Scale of the normal map; strength of the occlusion.
uniform int unlit;
uniform float lineScale;
uniform vec4 heatStops[9];     // Linear.
uniform float heatRange;       // Character units.
uniform vec4 zoneColors[5];    // Linear; by class, then cloth and rigid.
uniform int firstTriangle;     // Of this draw.
layout(std430, binding = 0) readonly buffer Classes { uint classOf[]; };       // By control triangle: zone + 8 level.
layout(std430, binding = 1) readonly buffer Controls { int controlOf[]; };     // By drawn triangle.

#ifdef SHADING_HEAT
vec3 heatColor(float x) {
  float at = (clamp(x, -1.0, 1.0) * 0.5 + 0.5) * 8.0;
  int low = min(int(at), 7);
  return mix(heatStops[low].rgb, heatStops[low + 1].rgb, at - float(low));
}
#endif

vec2 mapAt(int map) {
  vec3 uv = vec3(fragment.uv, 1.0);
  return vec2(dot(mapPlaces[2 * map].xyz, uv), dot(mapPlaces[2 * map + 1].xyz, uv));
}

#ifdef NORMAL_MAP
#include "relief.glsl"
#endif

vec3 pigment() {
#if defined(SHADING_HEAT)
  return heatColor(fragment.displacement / heatRange);
#elif defined(SHADING_CLASSES)
  uint found = classOf[controlOf[firstTriangle + gl_PrimitiveID]];
  vec3 color = zoneColors[found & 7u].rgb;
  uint level = found >> 3;  // 0: the same everywhere.
  return level == 0u ? color : color * mix(1.3, 0.22, log2(float(level)) / 4.0);
#else
  return vec3(0.360, 0.356, 0.350);  // Neutral: the red of the muscles stands out.
#endif
}

#ifdef MARKED
#include "form.glsl"
uniform vec4 territoryTint;   // Linear; w: strength.
uniform int markCount;        // 0..4 muscles whose influence is outlined on the skin.
uniform vec4 markRows[12];    // Three rows each: world -> the ball of influence, radius 1; of a shape, its own space.
uniform vec4 markForms[4 * FORM_VECTORS];
uniform vec4 markReaches[4];  // x: reach of a shape, or 0.
uniform vec4 markColors[4];   // Linear; w: opacity of the line.

Form markForm(int mark) {
  vec4 numbers[FORM_VECTORS];
  for (int i = 0; i < FORM_VECTORS; ++i) numbers[i] = markForms[mark * FORM_VECTORS + i];
  return formOf(numbers);
}

vec3 marked(vec3 color) {
  float light = dot(color, vec3(0.2126, 0.7152, 0.0722));
  float own = fragment.skin.y;
  color = mix(color, territoryTint.rgb * (0.10 + 1.35 * light), territoryTint.w * own);
  for (int i = 0; i < markCount; ++i) {
    vec4 at = vec4(fragment.world, 1.0);
    vec3 inBall = vec3(dot(markRows[3 * i], at), dot(markRows[3 * i + 1], at), dot(markRows[3 * i + 2], at));
    float reach = markReaches[i].x;
    float outwards = (reach > 0.0 ? sqrt(formSquared(markForm(i), inBall)) / reach : length(inBall)) - 1.0;
    float pixels = outwards / max(fwidth(outwards), 1e-6);
    float line = clamp(0.5 + 0.75 * lineScale - abs(pixels), 0.0, 1.0) * markColors[i].w;
    color = mix(color, markColors[i].rgb, line);
  }
  return color;
}
#endif

void main() {
  vec3 v = toEye(fragment.world);
  vec3 smooth_ = normalize(fragment.normal);
#ifdef SHADING_TEXTURED
  // A highlight smaller than a pixel would flicker: what the normal turns within one widens it instead.
  vec3 turn = max(abs(dFdx(smooth_)), abs(dFdy(smooth_)));
  float turned = max(turn.x, max(turn.y, turn.z));
#endif
  vec3 n = smooth_;
#ifdef NORMAL_MAP
  vec3 texel = texture(normalMap, mapAt(0)).xyz * 2.0 - 1.0;
  n = embossed(n, fragment.world, mapAt(0), texel * vec3(mapStrengths.xx, 1.0));
#endif
  if (!gl_FrontFacing) {
    smooth_ = -smooth_;
    n = -n;
  }
  vec3 cameraUp = vec3(viewFromWorld[0][1], viewFromWorld[1][1], viewFromWorld[2][1]);
  vec3 right = normalize(cross(cameraUp, v));
  vec3 up = cross(v, right);
#ifdef CHOSEN_LOOK
  float near = occluded.x > 0.5 ? texelFetch(occlusion, ivec2(gl_FragCoord.xy), 0).r : 1.0;
  vec3 open = openness(fragment.skin.x * near, fragment.world, smooth_.y);
#else
  vec3 open = openness(fragment.skin.x, fragment.world, smooth_.y);
#endif
  float alpha = 1.0;
#ifdef SHADING_TEXTURED
  vec4 base = baseColor * texture(baseMap, fragment.uv);
  vec2 metal = finish.xy;
  float cavity = 1.0;
  vec3 glow = emissive;
#ifdef ROUGHNESS_MAP
  vec3 measured = texture(roughnessMap, mapAt(1)).rgb;
  metal *= measured.bg;
#ifdef SHARED_MAP
  cavity = 1.0 + mapStrengths.y * (measured.r - 1.0);
#endif
#endif
  metal.y = min(metal.y + turned, 1.0);
#ifdef OCCLUSION_MAP
  cavity = 1.0 + mapStrengths.y * (texture(occlusionMap, mapAt(2)).r - 1.0);
#endif
#ifdef EMISSIVE_MAP
  glow *= texture(emissiveMap, mapAt(3)).rgb;
#endif
  float cutoff = finish.z;
#ifdef COLORED
  base *= clamp(fragment.color, 0.0, 1.0);
  cutoff -= 1e-5;  // The interpolated 1 of a vertex may be a little less.
#endif
  if (base.a < cutoff) discard;
  if (finish.w > 0.5) alpha = base.a;
  vec3 lit = studio(base.rgb, metal.x, metal.y, n, v, right, up, open, cavity) + glow;
  vec3 color = unlit != 0 ? base.rgb : kBare ? lit : dithered(toneMapped(lit));
#else
  vec3 m = vec3(dot(n, right), dot(n, up), dot(n, v));
  vec3 l = kClayKey;
#ifdef CHOSEN_LOOK
  if (keyAim.w > 0.5) l = vec3(dot(keyAim.xyz, right), dot(keyAim.xyz, up), dot(keyAim.xyz, v));
#endif
  vec3 color = dithered(toneMapped(pigment() * clayLight(m, l, open) + clayGloss(m, l) * open));
#endif
#ifdef MARKED
  color = marked(color);
#endif
#ifdef WIRE
  float nearest = min(edgePixels.x, min(edgePixels.y, edgePixels.z));
  float thin = min(altitudes.x, min(altitudes.y, altitudes.z));
  float line = (1.0 - smoothstep(0.5 * lineScale - 0.35, 0.5 * lineScale + 0.75, nearest)) *
               mix(0.10, 0.62, smoothstep(2.0, 10.0, thin / lineScale));
  color = mix(color, vec3(0.016, 0.014, 0.016), line);
#endif
  outColor = vec4(color * alpha, alpha);
}
