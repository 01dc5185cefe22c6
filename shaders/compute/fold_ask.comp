#version 450 core
// shaders/compute/fold_ask.comp: how much each triangle asks to be relaxed. As
// core/smoothing/finish/fold_relaxation.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"

layout(std430, binding = 0) readonly buffer Triangles { Triangle triangles[]; };
layout(std430, binding = 1) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 2) readonly buffer Marks { Mark marks[]; };
layout(std430, binding = 3) readonly buffer Folded { vec4 folded[]; };
layout(std430, binding = 4) writeonly buffer Asks { float asks[]; };
#include "compute/front.glsl"
#include "compute/fold.glsl"
uniform int isFirst;

const float kWholeArea = 0.4;

bool hasMoved(Triangle t) {
  return max(max(folded[firstVertex() + t.a].w, folded[firstVertex() + t.b].w), folded[firstVertex() + t.c].w) > 0.0;
}

void main() {
  int i = item();
  if (i >= refinedTriangles) return;
  Triangle t = triangles[i];
  int at = body() * refinedTriangles + i;
  if (isFirst == 0 && !hasMoved(t)) return;
  float ask = 0.0;
  if (isNear(t)) {
    Fold fold = foldOf(t, kWholeArea);
    ask = fold.weight * (1.0 - smoothstep(0.0, kWholeArea, fold.area));
  }
  asks[at] = ask;
}
