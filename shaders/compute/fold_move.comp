#version 450 core
// shaders/compute/fold_move.comp: vertices go where fold_mean.comp wants them.
#include "compute/items.glsl"
#include "compute/mesh.glsl"
#include "compute/fold_move.glsl"

layout(std430, binding = 0) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 1) readonly buffer Surface { Vertex surface[]; };
layout(std430, binding = 2) readonly buffer Marks { Mark marks[]; };
layout(std430, binding = 3) writeonly buffer Folded { vec4 folded[]; };
layout(std430, binding = 4) readonly buffer Wanted { vec4 wanted[]; };

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  if (marks[at].moved != kMoved) return;
  vec4 to = wanted[at];
  if (to.w > 0.0) folded[at] = vec4(keptNear(to.xyz, surface[at].position.xyz, patches[at].position.xyz), to.w);
  else folded[at].w = 0.0;
}
