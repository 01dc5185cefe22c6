#version 450 core
// shaders/compute/soften.comp: normals of the field less what alternates along muscles' rims. As
// core/surface/finish/normals_kernel.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"
#include "compute/numbers.glsl"
#include "core/geometry/formulas/finish.h"

layout(std430, binding = 0) readonly buffer Rings { Ring rings[]; };
layout(std430, binding = 1) readonly buffer Neighbors { int neighbors[]; };
layout(std430, binding = 2) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 3) buffer Surface { Vertex surface[]; };
layout(std430, binding = 4) readonly buffer Rims { vec4 rims[]; };
layout(std430, binding = 5) readonly buffer Means { vec4 means[]; };

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  vec4 own = rims[at], mean = means[at];
  if (!(own.w > kRimFrom || mean.w > 0.0)) return;
  vec3 sum = vec3(0.0);
  for (int i = rings[v].begin; i < rings[v].end; ++i) sum += rims[firstVertex() + neighbors[i]].xyz - own.xyz;
  float second = rimWeight(own.w, mean.w);
  vec3 patchNormal = patches[at].normal.xyz;
  vec3 delta = surface[at].normal.xyz - patchNormal;
  vec3 normal = patchNormal + ((delta - second * rings[v].share * sum) + mean.xyz);
  float squared = dotOf(normal, normal);
  if (squared > 1e-12) surface[at].normal = vec4((1.0 / sqrt(squared)) * normal, 0.0);
}
