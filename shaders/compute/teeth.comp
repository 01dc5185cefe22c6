#version 450 core
// shaders/compute/teeth.comp: where normals alternate from vertex to vertex: the first difference of their turns
// from the ring's mean, and the weight with which it counts. As core/surface/finish/normals_kernel.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"
#include "compute/numbers.glsl"
#include "core/geometry/formulas/finish.h"

layout(std430, binding = 0) readonly buffer Rings { Ring rings[]; };
layout(std430, binding = 1) readonly buffer Neighbors { int neighbors[]; };
layout(std430, binding = 2) readonly buffer Marks { Mark marks[]; };
layout(std430, binding = 3) readonly buffer Turns { vec4 turns[]; };
layout(std430, binding = 4) writeonly buffer Teeth { vec4 teeth[]; };  // w: the weight.

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  vec4 own = turns[at];
  vec3 sum = vec3(0.0);
  float most = 0.0;
  for (int i = rings[v].begin; i < rings[v].end; ++i) {
    vec3 apart = turns[firstVertex() + neighbors[i]].xyz - own.xyz;
    sum += apart;
    most = max(most, dotOf(apart, apart));
  }
  float weight = teethWeight(sqrt(most), marks[at].filtered, sqrt(own.w));
  teeth[at] = vec4(rings[v].share * sum, weight);
}
