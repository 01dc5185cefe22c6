#version 450 core
// shaders/compute/rims.comp: with adaptive detail, what the ring's mean adds to the field's normals along rims.
// As core/surface/finish/normals_kernel.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"
#include "compute/numbers.glsl"
#include "core/geometry/formulas/finish.h"

layout(std430, binding = 0) readonly buffer Rings { Ring rings[]; };
layout(std430, binding = 1) readonly buffer Neighbors { int neighbors[]; };
layout(std430, binding = 2) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 3) readonly buffer Surface { Vertex surface[]; };
layout(std430, binding = 4) readonly buffer Marks { Mark marks[]; };
layout(std430, binding = 5) writeonly buffer Rims { vec4 rims[]; };  // 0: the normal stays.

vec3 deltaAt(int i) { return surface[i].normal.xyz - patches[i].normal.xyz; }

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  rims[at] = vec4(0.0);
  if (marks[at].moved == 0u) return;
  vec3 own = deltaAt(at);
  vec3 sum = vec3(0.0);
  float most = 0.0;
  for (int i = rings[v].begin; i < rings[v].end; ++i) {
    vec3 apart = deltaAt(firstVertex() + neighbors[i]) - own;
    sum += apart;
    most = max(most, dotOf(apart, apart));
  }
  rims[at] = vec4(rimWeight(sqrt(most)) * rings[v].share * sum, 0.0);
}
