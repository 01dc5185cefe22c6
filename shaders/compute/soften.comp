#version 450 core
// shaders/compute/soften.comp: normals of the field less what alternates along muscles' rims. As
// core/smoothing/finish/normals_kernel.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"

layout(std430, binding = 0) readonly buffer Rings { Ring rings[]; };
layout(std430, binding = 1) readonly buffer Neighbors { int neighbors[]; };
layout(std430, binding = 2) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 3) buffer Surface { Vertex surface[]; };
layout(std430, binding = 4) readonly buffer Rims { vec4 rims[]; };

const float kRimFrom = 0.05, kRimWhole = 0.2, kRimMean = 0.45, kRimSecond = 0.44, kSoftening = 0.8;

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  vec4 own = rims[at];
  if (!(own.w > kRimFrom)) return;
  vec3 sum = vec3(0.0);
  for (int i = rings[v].begin; i < rings[v].end; ++i) sum += rims[firstVertex() + neighbors[i]].xyz - own.xyz;
  float mean = smoothstep(kRimWhole, kRimMean, own.w);
  float second = kRimSecond * smoothstep(kRimFrom, kRimWhole, own.w) * (1.0 - mean);
  vec3 patchNormal = patches[at].normal.xyz;
  vec3 delta = surface[at].normal.xyz - patchNormal;
  vec3 normal = patchNormal + ((delta - second * rings[v].share * sum) + kSoftening * mean * own.xyz);
  float squared = dotOf(normal, normal);
  if (squared > 1e-12) surface[at].normal = vec4((1.0 / sqrt(squared)) * normal, 0.0);
}
