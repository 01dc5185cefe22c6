#version 450 core
// shaders/compute/fold_start.comp: where vertices stand before folds are taken out.
#include "compute/items.glsl"
#include "compute/mesh.glsl"

layout(std430, binding = 0) readonly buffer Surface { Vertex surface[]; };
layout(std430, binding = 1) writeonly buffer Folded { vec4 folded[]; };  // w: 1 where the last round has moved it.

void main() {
  int v = item();
  if (v < refinedVertices) folded[firstVertex() + v] = vec4(surface[firstVertex() + v].position.xyz, 0.0);
}
