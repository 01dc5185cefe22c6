#version 450 core
// shaders/compute/fold_height.comp: vertices that folds have moved take their places, and heights follow.
#include "compute/items.glsl"
#include "compute/mesh.glsl"

layout(std430, binding = 0) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 1) buffer Surface { Vertex surface[]; };
layout(std430, binding = 2) readonly buffer Folded { vec4 folded[]; };

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  vec4 from = surface[at].position;
  vec3 to = folded[at].xyz;
  if (to == from.xyz) return;
  vec3 patchPlace = patches[at].position.xyz;
  vec3 lift = from.xyz - patchPlace;
  surface[at].position = vec4(to, from.w * dot(to - patchPlace, lift) / dot(lift, lift));
}
