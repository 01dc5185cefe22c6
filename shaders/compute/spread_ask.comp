#version 450 core
// shaders/compute/spread_ask.comp: the moves along the patch that would give a folded triangle area again. As
// core/surface/finish/fold_spread.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"

layout(std430, binding = 0) readonly buffer Triangles { Triangle triangles[]; };
layout(std430, binding = 1) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 2) readonly buffer Marks { Mark marks[]; };
layout(std430, binding = 3) readonly buffer Folded { vec4 folded[]; };
layout(std430, binding = 4) writeonly buffer Asks { float asks[]; };  // Weights.
layout(std430, binding = 5) writeonly buffer Ways { vec4 ways[]; };  // By corner; w: the weight.
#include "compute/front.glsl"
#include "compute/fold.glsl"
uniform int isFirst;

const float kLeastArea = 0.3, kWholeLack = 0.1, kWholeStep = 0.01;

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
  float step = (kLeastArea - fold.area) * area / max(squared, area);
  float weight = fold.weight * min(1.0, min((kLeastArea - fold.area) / kWholeLack, step / kWholeStep));
  for (int k = 0; k < 3; ++k) ways[3 * at + k] = vec4(weight * step * gradients[k], weight);
}
