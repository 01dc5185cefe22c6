#version 450 core
// shaders/compute/swell_exact.comp: the listed vertices' roots in double precision. As
// core/surface/projection/swell.cpp.
#include "compute/items.glsl"
#include "compute/field.glsl"
#include "compute/exact.glsl"

#define Real double
#define Real2 dvec2
double sense;  // 1: outwards.
dvec2 psiAt(double t) { return sense * sampleExact(t); }
#include "compute/overhang.glsl"

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
  double radius = sqrt(1.0lf - sqrt(double(iso)));
  double h = double(root.blendWidth), width = h / (1.0lf - radius);
  exactCount = 0;
  exact[exactCount++] = ExactTerm(1.0lf / (width * width), (outward ? radius : -radius) / width, radius * radius, 1.0lf,
                                  outward ? -radius * width : -h, outward ? h : radius * width, kEverySum);
  gatherTerms(lines[at].from.xyz, outward ? lines[at].along.xyz : -lines[at].along.xyz);
  double end = outward ? 0.0lf : radius * width;
  for (int i = 0; outward && i < exactCount; ++i) end = max(end, exact[i].leave);
  double t = firstChange(0.0lf, end, outward);
  if (t == kNone) t = end;
  sense = outward ? 1.0lf : -1.0lf;
  roots[at].way = float(sense * t);
  roots[at].height = float(sense * belowOverhangs(t, overhangSlope(double(root.height)), h));
  roots[at].state = kFound;
}

void main() {
  uint together = gl_NumWorkGroups.x * gl_WorkGroupSize.x;
  for (uint i = gl_GlobalInvocationID.x; i < groups.w; i += together) find(int(unsure[i]));
}
