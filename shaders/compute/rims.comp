#version 450 core
// shaders/compute/rims.comp: with adaptive detail, how the turns that the field gives to the patch's normals differ
// around a vertex. As core/smoothing/finish/normals_kernel.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"

layout(std430, binding = 0) readonly buffer Rings { Ring rings[]; };
layout(std430, binding = 1) readonly buffer Neighbors { int neighbors[]; };
layout(std430, binding = 2) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 3) readonly buffer Surface { Vertex surface[]; };
layout(std430, binding = 4) readonly buffer Marks { Mark marks[]; };
// The first difference from the ring's mean; w: the largest difference from a neighbor.
layout(std430, binding = 5) writeonly buffer Rims { vec4 rims[]; };

vec3 turnAt(int at) { return surface[at].normal.xyz - patches[at].normal.xyz; }

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  rims[at] = vec4(0.0);
  if (marks[at].moved == 0u) return;
  vec3 own = turnAt(at), sum = vec3(0.0);
  float most = 0.0;
  for (int i = rings[v].begin; i < rings[v].end; ++i) {
    vec3 apart = turnAt(firstVertex() + neighbors[i]) - own;
    sum += apart;
    most = max(most, dotOf(apart, apart));
  }
  rims[at] = vec4(rings[v].share * sum, sqrt(most));
}
