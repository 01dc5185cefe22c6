#version 450 core
// shaders/compute/even.comp: normals less what alternates. As core/surface/finish/normals_kernel.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"

layout(std430, binding = 0) readonly buffer Rings { Ring rings[]; };
layout(std430, binding = 1) readonly buffer Neighbors { int neighbors[]; };
layout(std430, binding = 2) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 3) buffer Surface { Vertex surface[]; };
layout(std430, binding = 4) readonly buffer Turns { vec4 turns[]; };
layout(std430, binding = 5) readonly buffer Teeth { vec4 teeth[]; };

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  vec4 own = teeth[at];
  if (own.w == 0.0) return;
  vec3 sum = vec3(0.0);
  for (int i = rings[v].begin; i < rings[v].end; ++i) sum += teeth[firstVertex() + neighbors[i]].xyz - own.xyz;
  vec3 normal = patches[at].normal.xyz + (turns[at].xyz - own.w * rings[v].share * sum);
  float squared = dotOf(normal, normal);
  if (squared > 1e-12) surface[at].normal = vec4((1.0 / sqrt(squared)) * normal, 0.0);
}
