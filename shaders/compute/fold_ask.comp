#version 450 core
// shaders/compute/fold_ask.comp: how much each triangle asks to be relaxed, and the most it has lacked so far. As
// core/smoothing/finish/fold_relaxation.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"

layout(std430, binding = 0) readonly buffer Triangles { Triangle triangles[]; };
layout(std430, binding = 1) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 2) readonly buffer Marks { Mark marks[]; };
layout(std430, binding = 3) readonly buffer Folded { vec4 folded[]; };
layout(std430, binding = 4) buffer Asks { vec2 asks[]; };  // Weight, lack.
#include "compute/front.glsl"
#include "compute/fold.glsl"
uniform int isFirst;

const float kWholeArea = 0.4;

bool hasMoved(Triangle t) {
  return max(max(folded[firstVertex() + t.a].w, folded[firstVertex() + t.b].w), folded[firstVertex() + t.c].w) > 0.0;
}

float lackOf(Triangle t, Fold fold) {
  vec3 a = folded[firstVertex() + t.a].xyz;
  vec3 ab = folded[firstVertex() + t.b].xyz - a, ac = folded[firstVertex() + t.c].xyz - a;
  float edges = dot(ab, ab) + dot(ac, ac) + dot(ac - ab, ac - ab);
  float area = sqrt(fold.whole);
  return fold.weight * (kWholeArea - fold.area) * area / sqrt(max(edges, area));
}

void main() {
  int i = item();
  if (i >= refinedTriangles) return;
  Triangle t = triangles[i];
  int at = body() * refinedTriangles + i;
  if (isFirst == 0 && !hasMoved(t)) return;
  vec2 ask = vec2(0.0, isFirst == 0 ? asks[at].y : 0.0);
  if (isNear(t)) {
    Fold fold = foldOf(t, kWholeArea);
    ask.x = fold.weight * (1.0 - smoothstep(0.0, kWholeArea, fold.area));
    if (ask.x > 0.0) ask.y = max(ask.y, lackOf(t, fold));
  }
  asks[at] = ask;
}
