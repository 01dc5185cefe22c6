#version 450 core
// shaders/compute/swell.comp: the first root of f_skin + F - T along the rise direction, where single precision can vouch
// for it; the other vertices are listed for swell_exact.comp. As core/smoothing/projection/swell_kernel.cpp.
#include "compute/items.glsl"
#include "compute/field.glsl"
#include "compute/ray.glsl"

struct Line {
  vec4 from;
  vec4 along;
};
layout(std430, binding = 4) readonly buffer Lines { Line lines[]; };
#include "compute/unsure.glsl"
layout(std430, binding = 6) writeonly buffer Roots { Root roots[]; };

// F on the skin and the blend width there.
vec2 skinAt(vec3 p) {
  float carved = 0.0, shares = 0.0, widths = 0.0;
  float sums[kMostCliques];
  for (int k = 0; k < cliqueCount; ++k) sums[k] = 0.0;
  for (int i = firstCandidate; i < endCandidate; ++i) {
    Candidate c = candidates[i];
    Primitive muscle = primitives[firstPrimitive + c.primitive];
    if (muscle.center.w == 0.0) continue;
    precise float w = 1.0 - rSquaredAt(muscle, p - muscle.center.xyz);
    if (!(w > 0.0)) continue;
    precise float value = strengthOf(muscle) * weightOf(c) * w * w;
    shares += abs(value);
    widths += abs(value) * blendWidthOf(muscle);
    if (strengthOf(muscle) < 0.0) {
      carved += value;
      continue;
    }
    for (int k = 0; k < cliqueCount; ++k) {
      if ((cliqueAt(k) & c.bit) != 0u) sums[k] += value;
    }
  }
  float together = 0.0;
  for (int k = 0; k < cliqueCount; ++k) together = max(together, sums[k]);
  return vec2(together + carved, widths / shares);
}

// Where terms may rise, from and to, and the end of the search.
vec3 riseOf(float width) {
  bool outward = sense > 0.0;
  vec3 rise = vec3(kFar, 0.0, outward ? width : isoRadius / inverseWidth);
  for (int i = 0; i < termCount; ++i) {
    float middle = terms[i].middle;
    float extent = sqrt(max(0.0, terms[i].peak) / terms[i].a);
    bool adds = terms[i].factor > 0.0;
    vec2 rising = adds ? vec2(middle - extent, middle) : vec2(middle, middle + extent);
    if (outward) rise.z = max(rise.z, middle + extent);
    if (!(rising.y > 0.0)) continue;
    rise.x = min(rise.x, max(0.0, rising.x));
    rise.y = max(rise.y, rising.y);
  }
  return rise;
}

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = body() * refinedVertices + v;
  roots[at] = Root(0.0, 0.0, 0.0, kUntouched);
  see(v, body());
  if (firstCandidate == endCandidate) return;
  vec3 p = lines[at].from.xyz;
  vec2 skin = skinAt(p);
  if (skin.x == 0.0) return;
  skinFalls = true;
  sense = skin.x > 0.0 ? 1.0 : -1.0;
  inverseWidth = (1.0 - isoRadius) / skin.y;
  maxFall = sense > 0.0 ? isoRoot : kFar;
  bool known = fillTerms(p, sense * lines[at].along.xyz);
  float way = 0.0;
  if (known) {
    vec3 rise = riseOf(skin.y);
    Search search = bracketFromSkin(rise);
    if (search.rootless) way = rise.z;
    else known = search.bracketed && newton(search, way);
  }
  roots[at] = Root(sense * way, skin.x, skin.y, known ? kFound : kUnsure);
  if (!known) leaveUnsure(uint(at));
}
