#version 450 core
// shaders/compute/spread_ask.comp: the moves along the patch that would give a folded triangle area again. As
// core/surface/finish/fold_spread.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"
#include "compute/numbers.glsl"
#include "core/geometry/formulas/finish.h"

layout(std430, binding = 0) readonly buffer Triangles { Triangle triangles[]; };
layout(std430, binding = 1) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 2) readonly buffer Marks { Mark marks[]; };
layout(std430, binding = 3) readonly buffer Folded { vec4 folded[]; };
layout(std430, binding = 4) writeonly buffer Asks { float asks[]; };  // Weights.
layout(std430, binding = 5) writeonly buffer Ways { vec4 ways[]; };  // By corner; w: the weight.
uniform int isFirst;

vec3 patchFace(Triangle t) {
  vec3 a = patches[firstVertex() + t.a].position.xyz;
  return crossOf(patches[firstVertex() + t.b].position.xyz - a, patches[firstVertex() + t.c].position.xyz - a);
}

float frontOf(Triangle t, vec3 face) {
  vec3 a = patches[firstVertex() + t.a].position.xyz;
  vec3 normals = patches[firstVertex() + t.a].normal.xyz + patches[firstVertex() + t.b].normal.xyz +
                 patches[firstVertex() + t.c].normal.xyz;
  return frontOf(face, normals, patches[firstVertex() + t.b].position.xyz - a,
                 patches[firstVertex() + t.c].position.xyz - a);
}

struct Fold {
  float area;    // q: its area over the patch's, signed along the patch's face.
  float weight;  // 0..1, how far q can be trusted.
  vec3 face;     // Of the patch.
  float whole;   // Its squared length.
};

bool isNear(Triangle t) {
  return (marks[firstVertex() + t.a].moved | marks[firstVertex() + t.b].moved | marks[firstVertex() + t.c].moved) != 0u;
}

// @param least  q from which on it counts as level.
Fold foldOf(Triangle t, float least) {
  Fold fold = Fold(1.0, 0.0, patchFace(t), 0.0);
  fold.whole = dotOf(fold.face, fold.face);
  vec3 a = folded[firstVertex() + t.a].xyz;
  vec3 lifted = crossOf(folded[firstVertex() + t.b].xyz - a, folded[firstVertex() + t.c].xyz - a);
  float left = dotOf(lifted, fold.face);
  if (!(left < least * fold.whole)) return fold;
  fold.area = left / fold.whole;
  fold.weight = t.bindFront > 0.0 ? foldTrust(frontOf(t, fold.face) / t.bindFront) : 0.0;
  return fold;
}

bool hasMoved(Triangle t) {
  return max(max(folded[firstVertex() + t.a].w, folded[firstVertex() + t.b].w), folded[firstVertex() + t.c].w) > 0.0;
}

void main() {
  int i = item();
  if (i >= refinedTriangles) return;
  Triangle t = triangles[i];
  int at = body() * refinedTriangles + i;
  if (isFirst != 0 ? !isNear(t) : !hasMoved(t)) return;
  Fold fold = foldOf(t, kLeastArea);
  asks[at] = fold.weight;
  if (fold.weight == 0.0) return;
  float area = sqrt(fold.whole);
  vec3 normal = fold.face / area;
  vec3 a = folded[firstVertex() + t.a].xyz, b = folded[firstVertex() + t.b].xyz, c = folded[firstVertex() + t.c].xyz;
  vec3 gradients[3] = vec3[3](cross(normal, c - b), cross(normal, a - c), cross(normal, b - a));
  float squared = dot(gradients[0], gradients[0]) + dot(gradients[1], gradients[1]) + dot(gradients[2], gradients[2]);
  float step = foldStep(fold.area, area, squared);
  float weight = foldWeight(fold.weight, fold.area, step);
  for (int k = 0; k < 3; ++k) ways[3 * at + k] = vec4(weight * step * gradients[k], weight);
}
