#version 450 core
// shaders/compute/swell_exact.comp: the listed vertices' roots in double precision. As
// core/surface/projection/swell.cpp.
#include "compute/items.glsl"
#include "compute/field.glsl"
#include "compute/exact.glsl"

#define Real double
#define Real3 dvec3
#include "compute/numbers.glsl"
#include "core/geometry/formulas/potential.h"
#define Rays double  // 1: outwards, -1: inwards.
Sample psiAt(Rays sense, double t) {
  dvec2 phi = sampleExact(t);
  return Sample(sense * phi.x, sense * phi.y);
}
#include "core/geometry/formulas/overhang.h"

struct Line {
  vec4 from;
  vec4 along;
};
layout(std430, binding = 4) readonly buffer Lines { Line lines[]; };
#include "compute/unsure.glsl"
layout(std430, binding = 6) buffer Roots { Root roots[]; };

void find(int at) {
  see(at % refinedVertices, at / refinedVertices);
  Root root = roots[at];
  if (root.state != kUnsure) return;
  bool outward = root.onSkin > 0.0;
  // h / (1 - r_T) and r_T as the processor has them.
  double radius = sqrt(1.0lf - potentialInverse(double(iso)));
  double h = double(root.blendWidth), width = h / (1.0lf - radius);
  exactCount = 0;
  exact[exactCount++] = ExactTerm(1.0lf / (width * width), (outward ? radius : -radius) / width, radius * radius, 1.0lf,
                                  outward ? -radius * width : -h, outward ? h : radius * width, kEverySum);
  gatherTerms(lines[at].from.xyz, outward ? lines[at].along.xyz : -lines[at].along.xyz);
  double end = outward ? 0.0lf : radius * width;
  for (int i = 0; outward && i < exactCount; ++i) end = max(end, exact[i].leave);
  double t = firstChange(0.0lf, end, outward);
  if (t == kNone) t = end;
  double sense = outward ? 1.0lf : -1.0lf;
  SkinRay skin = SkinRay(sense, 1.0lf / width, radius, isoRoot, outward ? double(isoRoot) : 1e30lf);
  double sigma = overhangSlope(skin, h, double(root.height));
  roots[at].way = float(sense * t);
  roots[at].height = float(sense * heightBelowOverhangs(sense, t, sigma, h, true));
  roots[at].state = kFound;
}

void main() {
  uint together = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
  for (uint i = gl_GlobalInvocationID.x; i < groups.w; i += together) find(int(unsure[i]));
}
