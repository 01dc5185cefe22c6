#version 450 core
// shaders/compute/soften.comp: adds to normals what rims.comp has found. As core/surface/finish/normals_kernel.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"
#include "compute/numbers.glsl"

layout(std430, binding = 0) buffer Surface { Vertex surface[]; };
layout(std430, binding = 1) readonly buffer Rims { vec4 rims[]; };

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  if (rims[at].xyz == vec3(0.0)) return;
  vec3 normal = surface[at].normal.xyz + rims[at].xyz;
  float squared = dotOf(normal, normal);
  if (squared > 1e-12) surface[at].normal = vec4((1.0 / sqrt(squared)) * normal, 0.0);
}
