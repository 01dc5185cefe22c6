#version 450 core
// shaders/compute/weigh.comp: a vertex's weight in the filter is its own or what a neighbor passes on. As
// core/surface/finish/lifted_heights.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"

layout(std430, binding = 0) readonly buffer Rings { Ring rings[]; };
layout(std430, binding = 1) readonly buffer Neighbors { int neighbors[]; };
layout(std430, binding = 2) buffer Marks { Mark marks[]; };
layout(std430, binding = 3) readonly buffer Bends { vec2 bends[]; };

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  float weight = bends[firstVertex() + v].x;
  for (int i = rings[v].begin; i < rings[v].end; ++i) weight = max(weight, bends[firstVertex() + neighbors[i]].y);
  marks[firstVertex() + v].filtered = weight;
}
