#version 450 core
// shaders/muscle.frag: flesh in strands along the muscle, which end in a pale tendon. The strands are the muscle's own:
// they move and stretch with it; finer ones than a pixel shows fade into their mean.
#include "frame.glsl"
#include "color.glsl"
#include "brdf.glsl"
#include "lighting.glsl"
in vec3 world;
in vec3 shapeNormal;
in vec3 around;
in vec3 inMuscle;
flat in vec4 fibres;
flat in float glow;
layout(binding = 5) uniform sampler2D occlusion;
uniform vec3 loose;   // Flesh that is not flexed, and flexed fully. Linear.
uniform vec3 flexed;
uniform vec2 middle;  // How far the character's middle is along the view, and how deep the character is.
layout(location = 0) out vec4 outColor;

const vec3 kTendon = vec3(0.590, 0.545, 0.480);
const vec3 kBone = vec3(0.480, 0.385, 0.255);
const vec3 kDepths = vec3(0.050, 0.040, 0.042);  // What far things fade towards, as light.
const float kFine = 3.0;  // Fibres a strand.

float hash(float n) { return fract(sin(n * 12.9898 + 4.1414) * 43758.5453); }

// Strands side by side: x how far up the round of its strand a place lies, 0..1 (0.75 on average); y its slope sideways,
// -1..1; z a number of the strand's own.
vec3 strand(float at, float count) {
  float own = mod(floor(at), count);
  float aside = 2.0 * fract(at) - 1.0;
  return vec3(1.0 - abs(aside * aside * aside), aside * abs(aside), hash(own + 37.0 * fibres.w));
}

// Albedo, and the normal of the strands' relief.
vec3 pigment(vec3 smooth_, out vec3 n, out float roughness) {
#ifdef BONE
  n = smooth_;
  roughness = 0.5;
  return kBone;
#else
  vec2 direction = inMuscle.xz * inversesqrt(max(dot(inMuscle.xz, inMuscle.xz), 1e-12));
  float turn = atan(direction.x, direction.y), y = inMuscle.y, count = fibres.y, oval = fibres.z;
  // About the length of the arc: as many strands on a narrow side as on a broad one, for its length.
  float arc = (turn + 0.5 * oval * sin(2.0 * turn)) / 6.2831853;
  float sharp = occluded.y > 0.5 ? 1.0 : 1.5;  // A picture alone has one color a pixel, which thin strands make ragged.
  float width = sharp * count / 6.2831853 * length(fwidth(direction)) * (1.0 + oval * cos(2.0 * turn));
  float own = 6.2831853 * fibres.w;  // Each muscle's own.
  // Strands wind a little, and are not all as wide.
  float winding = 0.42 * sin(3.0 * turn + 2.3 * y + own) + 0.34 * sin(7.0 * turn - 2.6 * y + 2.0 * own) +
                  0.20 * sin(13.0 * turn + 4.7 * y + 3.0 * own);
  float at = count * arc + winding;
  float coarse = 1.0 - smoothstep(0.22, 0.62, width), fine = 1.0 - smoothstep(0.22, 0.62, kFine * width);
  vec3 bundle = strand(at, count);
  vec3 thread = strand(kFine * at + 0.7 * sin(2.0 * y + 9.0 * bundle.z), kFine * count);

  // Each strand ends in the tendon at its own place.
  float end = 0.90 + 0.16 * (bundle.z - 0.5) * coarse + 0.10 * (thread.z - 0.5) * fine;
  float tendon = smoothstep(end - 0.10, end + 0.08, abs(y));
  float tone = 1.0 + coarse * (0.26 * (bundle.z - 0.5)) + fine * 0.14 * (thread.z - 0.5);
  float deep = 0.35 + 0.65 * bundle.z;
  float groove = 1.0 + coarse * 0.46 * deep * (bundle.x - 0.75) + fine * 0.24 * (thread.x - 0.75);
  vec3 flesh = mix(loose, flexed, fibres.x) * tone * groove * groove;
  flesh += vec3(0.10, 0.075, 0.055) * fine * smoothstep(0.86, 1.0, thread.z) * (1.0 - fibres.x);  // Fat between fibres.
  vec3 cord = kTendon * (1.0 + 0.5 * (groove - 1.0)) * (1.0 + 0.3 * (tone - 1.0));
  vec3 side = normalize(around + 1e-20);
  float relief = mix(1.0, 0.35, tendon);
  n = normalize(smooth_ + side * relief * (0.40 * coarse * bundle.y + 0.28 * fine * thread.y));
  roughness = mix(mix(0.50, 0.40, fibres.x), 0.44, tendon);
  return mix(flesh, cord, tendon);
#endif
}

void main() {
  vec3 v = toEye(world), smooth_ = normalize(shapeNormal), n;
  float roughness;
  vec3 albedo = pigment(smooth_, n, roughness);
  float grazing = 1.0 - max(dot(smooth_, v), 0.0);
  albedo *= 1.0 - 0.55 * grazing * grazing;
  vec3 cameraUp = vec3(viewFromWorld[0][1], viewFromWorld[1][1], viewFromWorld[2][1]);
  vec3 right = normalize(cross(cameraUp, v));
  vec3 up = cross(v, right);
  float near = occluded.x > 0.5 ? texelFetch(occlusion, ivec2(gl_FragCoord.xy), 0).r : 1.0;
  vec3 open = openness(near, world, n.y);
  vec3 lit = studio(albedo, 0.0, roughness, n, v, right, up, open, 1.0);
  lit *= mix(0.35, 1.0, near);  // The key light is kept out as well: muscles lie close together.
  lit += glow * (0.10 * albedo + 0.02);
  float far = smoothstep(-0.30, 0.75, (dot(world - eye.xyz, forward.xyz) - middle.x) / middle.y);
  lit = mix(lit, kDepths + 0.25 * lit, 0.70 * far * (1.0 - glow));
  outColor = vec4(dithered(toneMapped(lit)), 1.0);
}
