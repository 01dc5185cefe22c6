// shaders/lighting.glsl: key, fill and rim light and what comes from all around. In a studio they go around with the
// camera, so that every side is shown well; outdoors the sun stands still.

#ifdef CHOSEN_LOOK
// A preset's numbers: LightBlock in app/viewport/render/frame.h.
layout(std140, binding = 1) uniform Light {
  vec4 sky;
  vec4 floorBounce;
  vec4 keyColor;
  vec4 fillColor;
  vec4 rimColor;
  vec4 keyAim;  // w 0: along the camera's right, towards the eye, up. w 1: a world direction.
  vec4 clayKey;  // As seen: x right, y up, z to the eye.
  vec4 clayKeyColor;
  vec4 clayLow;
  vec4 clayHigh;
  vec4 clayFill;
  vec4 clayRimRight;
  vec4 clayRimLeft;
  vec4 lamp;  // How far the key light reaches round, how softly it ends, least roughness; w 1: shown as it is.
};
#define kSky sky.rgb
#define kFloorBounce floorBounce.rgb
#define kKeyColor keyColor.rgb
#define kFillColor fillColor.rgb
#define kRimColor rimColor.rgb
#define kClayKey clayKey.rgb
#define kClayKeyColor clayKeyColor.rgb
#define kClayLow clayLow.rgb
#define kClayHigh clayHigh.rgb
#define kClayFill clayFill.rgb
#define kClayRimRight clayRimRight.rgb
#define kClayRimLeft clayRimLeft.rgb
#define kWrap lamp.x
#define kSoftness lamp.y
#define kLeastRoughness lamp.z
#define kBare (lamp.w > 0.5)
#define kClayWarmth (vec3(0.083, 0.031, 0.011) * clayKeyColor.r)
#else
// The studio's, known to the compiler: what is drawn most is drawn fastest.
const vec3 kSky = vec3(0.315, 0.345, 0.395);
const vec3 kFloorBounce = vec3(0.150, 0.128, 0.110);
const vec3 kKeyColor = vec3(1.56, 1.45, 1.30);
const vec3 kFillColor = vec3(0.150, 0.170, 0.205);
const vec3 kRimColor = vec3(0.50, 0.58, 0.70);
const vec3 kClayKey = vec3(-0.52, 0.60, 0.608);
const vec3 kClayKeyColor = vec3(1.62, 1.49, 1.29);
const vec3 kClayLow = vec3(0.118, 0.088, 0.084);
const vec3 kClayHigh = vec3(0.230, 0.238, 0.262);
const vec3 kClayFill = vec3(0.115, 0.132, 0.172);
const vec3 kClayRimRight = vec3(0.58, 0.66, 0.78);
const vec3 kClayRimLeft = vec3(0.30, 0.25, 0.22);
const vec3 kClayWarmth = vec3(0.135, 0.050, 0.018);
const float kWrap = 0.24;
const float kSoftness = 0.70;
const float kLeastRoughness = 0.25;  // The lamp has a size, which polished things show.
const bool kBare = false;
#endif

vec3 hemisphere(float up) { return mix(kFloorBounce, kSky, 0.5 + up * (0.75 - 0.25 * up * up)); }

// What reaches a spot of the skin of all the light around it: `open` was baked for the body itself (occlusion.h), the
// floor is near whatever the pose. Light that is kept out is red light last: skin passes some on.
vec3 openness(float open, vec3 world, float up) {
  float above = max(world.y - picture.w, 0.0) / picture.z;
  float contact = 1.0 / (1.0 + 34.0 * above);
  float left_ = open * (1.0 - 0.62 * contact * contact * clamp(0.75 - up, 0.0, 1.0));
  float dark = 1.0 - left_;
  return vec3(left_) + vec3(0.16, 0.055, 0.03) * (dark * left_ * 2.0);
}

// GGX highlight of one light, Schlick's Fresnel, Hammon's visibility (GDC 2017).
float highlight(vec3 n, vec3 v, vec3 l, float roughness) {
  vec3 h = normalize(v + l);
  float alpha = roughness * roughness;
  float nh = max(dot(n, h), 0.0), nv = max(dot(n, v), 0.05), nl = max(dot(n, l), 0.0);
  float d = nh * nh * (alpha * alpha - 1.0) + 1.0;
  return nl * alpha * alpha / (3.14159 * d * d) * 0.5 / mix(2.0 * nl * nv, nl + nv, alpha);
}

// In a studio from above, left of the camera whichever way it looks.
vec3 studioKey() {
#ifdef CHOSEN_LOOK
  if (keyAim.w > 0.5) return keyAim.xyz;
#endif
  vec3 side = vec3(viewFromWorld[0][0], 0.0, viewFromWorld[2][0]);
  vec3 towards = vec3(-side.z, 0.0, side.x);  // Towards the eye, level.
#ifdef CHOSEN_LOOK
  return normalize(keyAim.x * side + keyAim.y * towards + vec3(0.0, keyAim.z, 0.0));
#else
  return normalize(-0.72 * side + 0.58 * towards + vec3(0.0, 0.90, 0.0));
#endif
}

// A metallic-roughness material. The key light is glTF's BRDF (brdf.glsl), of a lamp that reaches a little round the
// body; what comes from all around is an estimate of the same. cavity: what the material's occlusion leaves of the
// latter.
vec3 studio(vec3 albedo, float metallic, float roughness, vec3 n, vec3 v, vec3 right, vec3 up, vec3 open,
            float cavity) {
  vec3 l = studioKey();
  vec3 fill = 0.75 * right + 0.15 * up + 0.65 * v;
  vec3 back = 0.60 * right + 0.52 * up - 0.62 * v;
  vec3 backLeft = -0.80 * right + 0.20 * up - 0.56 * v;
  vec3 plain = albedo * (1.0 - metallic);
  vec3 f0 = mix(vec3(0.04), albedo, metallic);
  // Key light is kept out less than the sky's: it comes from one side, and its own shadow is on the floor.
  float nl = dot(n, l);
  float lit = max((nl + kWrap) / (1.0 + kWrap), 0.0);
  vec3 reached = kBare ? vec3(1.0) : 0.45 + 0.55 * open;
  Reflection key = reflection(f0, n, v, l, max(roughness, kLeastRoughness));
  vec3 arriving = kKeyColor * (lit * (1.0 - kSoftness + kSoftness * lit)) * reached;
  vec3 color = plain * key.entering * arriving * (kBare ? 1.0 : 0.90);
  color += key.specular * kKeyColor * (max(nl, 0.0) * (kBare ? vec3(1.0) : open));
  if (kBare) return color;

  vec3 left_ = open * cavity;
  float grazing = 1.0 - max(dot(n, v), 0.0);
  float grazing2 = grazing * grazing;
  vec3 fresnel = f0 + (max(vec3(1.0 - roughness), f0) - f0) * grazing2 * grazing2 * grazing;
  vec3 mirrored = hemisphere(clamp(reflect(-v, n).y * (1.6 - roughness), -1.0, 1.0));
  float behind = max(dot(n, back) + 0.30, 0.0) + 0.55 * max(dot(n, backLeft) + 0.10, 0.0);
  vec3 rim = kRimColor * (grazing2 * grazing * behind) * open;
  vec3 around = hemisphere(n.y) * left_ + kFillColor * max(dot(n, fill), 0.0) * open;
  color += plain * (around + rim) * 0.86;
  return color + fresnel * left_ * mirrored * (1.0 - 0.6 * roughness) + rim * mix(vec3(0.09), albedo, metallic);
}

// Light on a sculptor's clay, by where the normal points as seen: x right, y up, z to the eye. 1 = clay as it is.
// l: the key light's direction in the same terms.
vec3 clayLight(vec3 m, vec3 l, vec3 open) {
  float d = dot(m, l);
  float lit = smoothstep(-0.26, 1.06, d);
  float edge = 1.0 - clamp(m.z, 0.0, 1.0);
  vec3 around = mix(kClayLow, kClayHigh, smoothstep(-0.9, 0.9, m.y));
  around += kClayFill * max(dot(m, vec3(0.80, -0.12, 0.59)), 0.0);  // Fill, from the right.
  vec3 light = around * open + kClayKeyColor * (lit * lit) * (0.40 + 0.60 * open);
  float terminator = smoothstep(-0.42, 0.02, d) * (1.0 - smoothstep(0.02, 0.60, d));
  light += kClayWarmth * terminator;  // Warm, as if light went in.
  light *= 1.0 - 0.42 * edge * edge;                                                        // Forms turn away darker,
  float right = smoothstep(0.0, 0.85, 0.72 * m.x + 0.45 * m.y);
  float left_ = smoothstep(0.15, 0.95, -0.90 * m.x - 0.10 * m.y);
  vec3 rim = kClayRimRight * right + kClayRimLeft * left_;
  return light + rim * (edge * edge * edge) * open;                                         // then are rimmed.
}

vec3 clayGloss(vec3 m, vec3 l) {
#ifdef CHOSEN_LOOK
  vec3 h = normalize(l + vec3(0.0, 0.0, 1.0));
  float strength = min(0.62 * clayKeyColor.r, 1.0);
#else
  const vec3 h = vec3(-0.290, 0.3345, 0.8966);
  const float strength = 1.0;
#endif
  float s = max(dot(m, h), 0.0);
  float s2 = s * s, s4 = s2 * s2, s8 = s4 * s4, s16 = s8 * s8;
  return (vec3(0.075, 0.072, 0.068) * (s16 * s4) + vec3(0.060) * (s16 * s16 * s16 * s16)) * strength;
}
