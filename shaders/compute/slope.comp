#version 450 core
// shaders/compute/slope.comp: one round of the bound on slopes: a height is at most what each vertex a step away
// leaves it.
// Where the rounds come to rest is one set of heights, in whatever order they ran. As
// core/surface/finish/lifted_heights.h.
#include "compute/items.glsl"
#include "compute/mesh.glsl"
#include "compute/numbers.glsl"
#include "core/geometry/formulas/finish.h"

layout(std430, binding = 0) readonly buffer Rings { Ring rings[]; };
layout(std430, binding = 1) readonly buffer Neighbors { int neighbors[]; };
layout(std430, binding = 2) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 3) readonly buffer Surface { Vertex surface[]; };
layout(std430, binding = 4) readonly buffer Marks { Mark marks[]; };
layout(std430, binding = 5) coherent buffer Heights { uint heights[]; };  // Bits of |height|.
#define ROUNDS 6
#include "compute/rounds.glsl"

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  float own = uintBitsToFloat(heights[at]);
  if (marks[at].moved != kMoved || own == 0.0) return;
  bool rises = surface[at].position.w > 0.0;
  vec3 p = patches[at].position.xyz;
  float least = own;
  int count = rings[v].end - rings[v].begin;
  int steps = count + rings[v].acrossEnd - rings[v].acrossBegin;
  for (int i = 0; i < steps; ++i) {
    int place = i < count ? rings[v].begin + i : rings[v].acrossBegin + i - count;
    int other = firstVertex() + neighbors[place];
    vec3 step = patches[other].position.xyz - p;
    bool along = (surface[other].position.w > 0.0) == rises;
    float left = along ? uintBitsToFloat(heights[other]) : 0.0;
    precise float offer = left + kMostSlope * sqrt(dotOf(step, step));
    least = min(least, offer);
  }
  if (!(least < own)) return;
  atomicMin(heights[at], floatBitsToUint(least));
  askForNext();
}
