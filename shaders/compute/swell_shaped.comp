#version 450 core
// shaders/compute/swell_shaped.comp: the listed vertices whose rays may meet a muscle that is no ellipsoid, or with
// soft grooves or links in part: the bounds of swell.comp in double precision, halved until they tell.
#include "compute/items.glsl"
#include "compute/field.glsl"

#define Real double
#define Real3 dvec3
#include "compute/numbers.glsl"
#include "core/geometry/formulas/potential.h"
#include "core/geometry/formulas/shape.h"
#include "core/geometry/formulas/bounds.h"
#include "compute/shape.glsl"

const double kSettled = 1e-7lf;  // F errs by its square.
#include "compute/blend.glsl"
#include "core/geometry/formulas/blend.h"

const int kMostTerms = 96, kMostShapes = 96;  // No place of the skin sees more, or the surface is the processor's.
const double kValueRounding = 1e-13lf, kSlopeRounding = 1e-11lf;
#define kLeastStretch (0.001lf * double(tolerance))
const int kMostMarches = 400, kMostSteps = 60;
#include "compute/ray.glsl"

#define Rays int
Sample psiAt(Rays rays, double t) { return sampleRay(t); }
#include "core/geometry/formulas/overhang.h"

struct Line {
  vec4 from;
  vec4 along;
};
layout(std430, binding = 4) readonly buffer Lines { Line lines[]; };
#include "compute/unsure.glsl"
layout(std430, binding = 6) buffer Roots { Root roots[]; };

void find(int at) {
  Root root = roots[at];
  if (root.state != kUnsureShaped) return;
  see(at % refinedVertices, at / refinedVertices);
  double sense = root.onSkin > 0.0 ? 1.0lf : -1.0lf, h = double(root.blendWidth);
  skin = SkinRay(sense, (1.0lf - isoRadius) / h, isoRadius, isoRoot, sense > 0.0lf ? double(isoRoot) : double(kFar));
  fillTerms(lines[at].from.xyz, float(sense) * lines[at].along.xyz);
  dvec3 rise = riseOf(h);
  Search search = bracketFromSkin(rise);
  double way = search.rootless ? rise.z : search.low;
  if (search.bracketed) newton(search, way);
  roots[at].way = float(sense * way);
  double sigma = overhangSlope(skin, h, double(root.height));
  roots[at].height = float(sense * heightBelowOverhangs(0, way, sigma, h, true));
  roots[at].state = kFound;
}

void main() {
  uint together = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
  for (uint i = gl_GlobalInvocationID.x; i < groups.w; i += together) find(int(unsure[i]));
}
