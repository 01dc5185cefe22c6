#version 450 core
// shaders/compute/rims.comp: with adaptive detail, how normals, and the turns that the field gives to the patch's, differ
// around a vertex. As core/surface/finish/normals_kernel.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"
#include "compute/numbers.glsl"
#include "core/geometry/formulas/finish.h"

layout(std430, binding = 0) readonly buffer Rings { Ring rings[]; };
layout(std430, binding = 1) readonly buffer Neighbors { int neighbors[]; };
layout(std430, binding = 2) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 3) readonly buffer Surface { Vertex surface[]; };
layout(std430, binding = 4) readonly buffer Marks { Mark marks[]; };
// The turn's first difference from the ring's mean; w: its largest difference from a neighbor's.
layout(std430, binding = 5) writeonly buffer Rims { vec4 rims[]; };
// What the ring's mean adds to the normal; w: how far it takes the place of the second step.
layout(std430, binding = 6) writeonly buffer Means { vec4 means[]; };

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  rims[at] = means[at] = vec4(0.0);
  if (marks[at].moved == 0u) return;
  vec3 own = surface[at].normal.xyz, ownTurn = own - patches[at].normal.xyz;
  vec3 sum = vec3(0.0), sumOfTurns = vec3(0.0);
  float most = 0.0, mostOfTurns = 0.0;
  for (int i = rings[v].begin; i < rings[v].end; ++i) {
    int other = firstVertex() + neighbors[i];
    vec3 apart = surface[other].normal.xyz - own;
    vec3 turn = (surface[other].normal.xyz - patches[other].normal.xyz) - ownTurn;
    sum += apart;
    sumOfTurns += turn;
    most = max(most, dotOf(apart, apart));
    mostOfTurns = max(mostOfTurns, dotOf(turn, turn));
  }
  float mean = meanShare(sqrt(most));
  rims[at] = vec4(rings[v].share * sumOfTurns, sqrt(mostOfTurns));
  means[at] = vec4(kSoftening * mean * rings[v].share * sum, mean);
}
