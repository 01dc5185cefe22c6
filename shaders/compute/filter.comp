#version 450 core
// shaders/compute/filter.comp: one round of the heights' filter; the last one moves the vertices. As
// core/surface/finish/lifted_heights.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"
#include "compute/numbers.glsl"
#include "core/geometry/formulas/finish.h"

layout(std430, binding = 0) readonly buffer Rings { Ring rings[]; };
layout(std430, binding = 1) readonly buffer Neighbors { int neighbors[]; };
layout(std430, binding = 2) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 3) buffer Surface { Vertex surface[]; };
layout(std430, binding = 4) readonly buffer Marks { Mark marks[]; };
layout(std430, binding = 5) readonly buffer Before { float before[]; };
layout(std430, binding = 6) writeonly buffer After { float after[]; };
#include "compute/lift.glsl"
float heightOf(int at) { return before[at]; }
LIFT_SUMS(heightOf)
uniform int isLast;

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  float own = before[at];
  float height = surface[at].position.w;
  float weight = marks[at].filtered;
  after[at] = own;
  if (marks[at].moved != kMoved || !(weight > 0.0) || height == 0.0) return;
  vec2 sums = liftSums(v, own);
  if (!(sums.y > 0.0)) return;
  float next = filteredHeight(own, weight, sums.x, sums.y, height);
  after[at] = next;
  if (isLast == 0) return;
  vec3 patchPlace = patches[at].position.xyz;
  precise vec3 position = patchPlace + (next / height) * (surface[at].position.xyz - patchPlace);
  surface[at].position = vec4(position, next);
}
