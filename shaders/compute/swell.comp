#version 450 core
// shaders/compute/swell.comp: the first root of f_skin + F - T along the rise direction, where single precision can
// vouch for it; the other vertices are listed for swell_exact.comp and swell_shaped.comp. As
// core/surface/projection/swell_kernel.cpp.
#include "compute/items.glsl"
#include "compute/field.glsl"
#include "compute/numbers.glsl"
#include "core/geometry/formulas/potential.h"
#include "core/geometry/formulas/shape.h"
#include "core/geometry/formulas/bounds.h"
#include "compute/shape.glsl"
#include "compute/potential.glsl"

const float kSettled = 1e-6;
#include "compute/blend.glsl"
#include "core/geometry/formulas/blend.h"

const int kMostTerms = 24, kMostShapes = 8;  // More along one ray: it has no certificate.
const float kValueRounding = 1e-5, kSlopeRounding = 1e-3, kLeastStretch = 0.0;
const int kMostMarches = 20, kMostSteps = 24;
#include "compute/ray.glsl"

#define Rays int
Sample psiAt(Rays rays, float t) { return sampleRay(t); }
#include "core/geometry/formulas/overhang.h"

struct Line {
  vec4 from;
  vec4 along;
};
layout(std430, binding = 4) readonly buffer Lines { Line lines[]; };
#include "compute/unsure.glsl"
layout(std430, binding = 6) writeonly buffer Roots { Root roots[]; };

// F on the skin, the blend width and the muscles' mean radius there.
vec3 skinAt(vec3 p) {
  float carved = 0.0, shares = 0.0, widths = 0.0, radii = 0.0;
  float sums[kMostCliques];
  for (int k = 0; k < cliquesSeen; ++k) sums[k] = 0.0;
  if (softGrooves) clearGroups();
  for (int i = firstCandidate; i < endCandidate; ++i) {
    Candidate c = candidates[i];
    Primitive muscle = primitives[firstPrimitive + c.primitive];
    if (muscle.center.w == 0.0) continue;
    precise float w = 1.0 - rSquaredAt(muscle, p - muscle.center.xyz);
    if (!(w > 0.0)) continue;
    float value = potential(strengthOf(muscle) * weightOf(c), w);
    shares += abs(value);
    widths += abs(value) * blendWidthOf(muscle);
    radii += abs(value) * meanRadiusOf(muscle);
    if (strengthOf(muscle) < 0.0) {
      carved += value;
      continue;
    }
    if (softGrooves) {
      addToGroup(c.slot, value, grooveOf(muscle));
      continue;
    }
    for (int k = 0; k < cliquesSeen; ++k) {
      if (holds(cliqueAt(k), c.slot)) sums[k] += value;
    }
  }
  float together = 0.0;
  for (int level = 0, k = 0; level < levelsSeen; ++level) {
    float best = 0.0;
    for (; k < levelEnd(level); ++k) best = max(best, sums[k]);
    together += levelWeight(level) * best;
  }
  if (softGrooves) {
    blendAmong(groupSlots);
    together = settleGroups();
  }
  return vec3(together + carved, widths / shares, radii / shares);
}

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = body() * refinedVertices + v;
  roots[at] = Root(0.0, 0.0, 0.0, kUntouched, 0.0);
  see(v, body());
  if (firstCandidate == endCandidate) return;
  vec3 p = lines[at].from.xyz;
  vec3 here = skinAt(p);
  if (here.x == 0.0) return;
  float sense = here.x > 0.0 ? 1.0 : -1.0;
  skin = SkinRay(sense, (1.0 - isoRadius) / here.y, isoRadius, isoRoot, sense > 0.0 ? isoRoot : kFar);
  bool known = fillTerms(p, sense * lines[at].along.xyz);
  float way = 0.0, height = here.z;
  if (known) {
    vec3 rise = riseOf(here.y);
    Search search = bracketFromSkin(rise);
    if (search.rootless) way = rise.z;
    else known = search.bracketed && newton(search, way);
    float sigma = overhangSlope(skin, here.y, here.z);
    float steep = sense > 0.0 ? min(0.5 * here.y, rise.x) : 0.0;
    bool slowly = known && steep < way && boundsOf(steep, way).maxSlope > -sigma;
    if (known) height = sense * (slowly ? heightBelowOverhangs(0, way, sigma, here.y, true) : way);
  }
  // Bounds serve soft grooves, links in part and any shape; swell_exact.comp knows maxima of quartics only.
  int unsureState = meetsShape || softGrooves || levelsSeen > 1 ? kUnsureShaped : kUnsure;
  roots[at] = Root(sense * way, here.x, here.y, known ? kFound : unsureState, height);
  if (!known) leaveUnsure(uint(at));
}
