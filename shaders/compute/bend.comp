#version 450 core
// shaders/compute/bend.comp: where heights bend more than edges can follow: weights of the filter, and what of them
// a vertex passes on. As core/surface/finish/lifted_heights.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"
#include "compute/numbers.glsl"
#include "core/geometry/formulas/finish.h"

layout(std430, binding = 0) readonly buffer Rings { Ring rings[]; };
layout(std430, binding = 1) readonly buffer Neighbors { int neighbors[]; };
layout(std430, binding = 2) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 3) readonly buffer Surface { Vertex surface[]; };
layout(std430, binding = 4) readonly buffer Marks { Mark marks[]; };
layout(std430, binding = 5) writeonly buffer Filtered { float filtered[]; };
layout(std430, binding = 6) writeonly buffer Bends { vec2 bends[]; };  // Own weight, and what neighbors get.
#include "compute/lift.glsl"
float heightOf(int at) { return surface[at].position.w; }
LIFT_SUMS(heightOf)

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  float height = surface[at].position.w;
  vec2 bend = vec2(0.0);
  if (marks[at].moved == kMoved && height != 0.0) {
    vec2 sums = liftSums(v, height);
    float bent = abs(sums.x) * rings[v].share;
    float weight = bentWeight(bent);
    bend = vec2(weight, passedWeight(weight, abs(height) * sums.y * rings[v].share));
  }
  filtered[at] = height;
  bends[at] = bend;
}
