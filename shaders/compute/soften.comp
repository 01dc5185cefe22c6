#version 450 core
// shaders/compute/soften.comp: with adaptive detail, normals that differ much from a neighbor's, drawn towards the ring's
// mean; the others as they are. As core/smoothing/finish/normals_kernel.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"

layout(std430, binding = 0) readonly buffer Rings { Ring rings[]; };
layout(std430, binding = 1) readonly buffer Neighbors { int neighbors[]; };
layout(std430, binding = 2) readonly buffer Surface { Vertex surface[]; };
layout(std430, binding = 3) readonly buffer Marks { Mark marks[]; };
layout(std430, binding = 4) writeonly buffer Softened { vec4 softened[]; };

const float kSoftening = 0.8, kRimFrom = 0.2, kRimWhole = 0.45;

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  vec3 own = surface[at].normal.xyz;
  softened[at] = vec4(own, 0.0);
  if (marks[at].moved == 0u) return;
  vec3 sum = vec3(0.0);
  float most = 0.0;
  for (int i = rings[v].begin; i < rings[v].end; ++i) {
    vec3 apart = surface[firstVertex() + neighbors[i]].normal.xyz - own;
    sum += apart;
    most = max(most, dotOf(apart, apart));
  }
  if (!(most > kRimFrom * kRimFrom)) return;
  float share = kSoftening * smoothstep(kRimFrom, kRimWhole, sqrt(most));
  softened[at] = vec4(normalizeOr(own + share * rings[v].share * sum, own), 0.0);
}
