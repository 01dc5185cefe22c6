#version 450 core
// shaders/compute/near.comp: which vertices muscles have moved, and their neighbors.
#include "compute/items.glsl"
#include "compute/mesh.glsl"

layout(std430, binding = 0) readonly buffer Rings { Ring rings[]; };
layout(std430, binding = 1) readonly buffer Neighbors { int neighbors[]; };
layout(std430, binding = 2) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 3) readonly buffer Surface { Vertex surface[]; };
layout(std430, binding = 4) writeonly buffer Marks { Mark marks[]; };

bool hasMoved(int at) { return surface[at].position.xyz != patches[at].position.xyz; }

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  uint moved = hasMoved(firstVertex() + v) ? kMoved : 0u;
  for (int i = rings[v].begin; i < rings[v].end && moved == 0u; ++i) {
    if (hasMoved(firstVertex() + neighbors[i])) moved = kNear;
  }
  marks[firstVertex() + v] = Mark(moved, 0.0);
}
