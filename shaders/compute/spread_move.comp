#version 450 core
// shaders/compute/spread_move.comp: each corner follows the mean of what its triangles ask. As
// core/surface/finish/fold_spread.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"
#include "compute/numbers.glsl"
#include "core/geometry/formulas/finish.h"

layout(std430, binding = 0) readonly buffer Rings { Ring rings[]; };
layout(std430, binding = 1) readonly buffer Corners { int corners[]; };
layout(std430, binding = 2) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 3) readonly buffer Surface { Vertex surface[]; };
layout(std430, binding = 4) buffer Folded { vec4 folded[]; };
layout(std430, binding = 5) readonly buffer Asks { float asks[]; };  // Weights.
layout(std430, binding = 6) readonly buffer Ways { vec4 ways[]; };
#define ROUNDS 7
#include "compute/rounds.glsl"

// As near to where muscles have put it as they have moved it (core/surface/finish/fold_spread.h).
vec3 keptNear(vec3 to, vec3 from, vec3 patchPlace) {
  vec3 way = to - from;
  float most = distance(from, patchPlace), far = length(way);
  return from + (far > most ? most / far : 1.0) * way;
}

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  vec3 from = surface[at].position.xyz, patchPlace = patches[at].position.xyz;
  if (from == patchPlace) return;
  vec4 sum = vec4(0.0);
  for (int i = rings[v].cornersBegin; i < rings[v].cornersEnd && rings[v].isBorder == 0; ++i) {
    int corner = 3 * body() * refinedTriangles + corners[i];
    if (asks[corner / 3] > 0.0) sum += ways[corner];
  }
  vec3 own = folded[at].xyz;
  if (sum.w == 0.0 || own == patchPlace) {
    folded[at].w = 0.0;
    return;
  }
  folded[at] = vec4(keptNear(own + foldRelaxation(sum.w) * sum.xyz, from, patchPlace), 1.0);
  askForNext();
}
