#version 450 core
// shaders/compute/lower.comp: vertices whose heights have been lowered: skin that stands lower is flatter.
#include "compute/items.glsl"
#include "compute/mesh.glsl"

layout(std430, binding = 0) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 1) buffer Surface { Vertex surface[]; };
layout(std430, binding = 2) readonly buffer Marks { Mark marks[]; };
layout(std430, binding = 3) readonly buffer Heights { uint heights[]; };

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  float raw = surface[at].position.w;
  float height = uintBitsToFloat(heights[at]);
  if (marks[at].moved != kMoved || raw == 0.0 || height == abs(raw)) return;
  float share = height / abs(raw);
  vec3 patchPlace = patches[at].position.xyz, n = patches[at].normal.xyz;
  precise vec3 position = patchPlace + share * (surface[at].position.xyz - patchPlace);
  vec3 normal = normalizeOr(n + share * (surface[at].normal.xyz - n), n);
  surface[at] = Vertex(vec4(position, raw < 0.0 ? -height : height), vec4(normal, 0.0));
}
