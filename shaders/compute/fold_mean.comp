#version 450 core
// shaders/compute/fold_mean.comp: where the corners of folding triangles are to go: towards the mean of their
// neighbors. As core/smoothing/finish/fold_relaxation.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"

layout(std430, binding = 0) readonly buffer Rings { Ring rings[]; };
layout(std430, binding = 1) readonly buffer Neighbors { int neighbors[]; };
layout(std430, binding = 2) readonly buffer Corners { int corners[]; };
layout(std430, binding = 3) readonly buffer Marks { Mark marks[]; };
layout(std430, binding = 4) readonly buffer Folded { vec4 folded[]; };
layout(std430, binding = 5) readonly buffer Asks { vec2 asks[]; };  // Weight, lack.
layout(std430, binding = 6) writeonly buffer Wanted { vec4 wanted[]; };
#define ROUNDS 7
#include "compute/rounds.glsl"

const float kRelaxStep = 0.2, kMostOfLack = 2.0, kFade = 0.25;

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  if (marks[at].moved != kMoved) return;
  vec2 asked = vec2(0.0);
  for (int i = rings[v].cornersBegin; i < rings[v].cornersEnd && rings[v].isBorder == 0; ++i) {
    asked = max(asked, asks[body() * refinedTriangles + corners[i] / 3]);
  }
  vec3 own = folded[at].xyz;
  float weight = max(folded[at].w - kFade, asked.x);
  wanted[at].w = max(weight, 0.0);
  if (!(weight > 0.0)) return;
  vec3 sum = vec3(0.0);
  for (int i = rings[v].begin; i < rings[v].end; ++i) sum += folded[firstVertex() + neighbors[i]].xyz - own;
  vec3 way = weight * rings[v].share * sum;
  float far = length(way), most = kMostOfLack * asked.y;
  wanted[at] = vec4(own + (far > most ? kRelaxStep * most / far : kRelaxStep) * way, weight);
  askForNext();
}
