#version 450 core
// shaders/compute/drawn.comp: refined vertices become drawn ones, in the layout of shaders/surface.vert.
#include "compute/items.glsl"
#include "compute/mesh.glsl"

layout(std430, binding = 0) readonly buffer DrawVertices { int drawVertices[]; };
layout(std430, binding = 1) readonly buffer Surface { Vertex surface[]; };
layout(std430, binding = 2) writeonly buffer Drawn { float drawn[]; };

void main() {
  int d = item();
  if (d >= drawnVertices) return;
  Vertex vertex = surface[firstVertex() + drawVertices[d]];
  int at = 7 * (body() * drawnVertices + d);
  for (int i = 0; i < 3; ++i) {
    drawn[at + i] = vertex.position[i];
    drawn[at + 3 + i] = vertex.normal[i];
  }
  drawn[at + 6] = vertex.position.w;
}
