#version 450 core
// shaders/compute/crease.comp: heights are lowered where the pose folds the skin itself. As
// core/smoothing/finish/crease_lift.h.
#include "compute/items.glsl"
#include "compute/mesh.glsl"

layout(std430, binding = 0) readonly buffer Rings { Ring rings[]; };
layout(std430, binding = 1) readonly buffer Corners { int corners[]; };
layout(std430, binding = 2) readonly buffer Triangles { Triangle triangles[]; };
layout(std430, binding = 3) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 4) readonly buffer Surface { Vertex surface[]; };
layout(std430, binding = 5) readonly buffer Marks { Mark marks[]; };
layout(std430, binding = 6) writeonly buffer Heights { uint heights[]; };  // Bits of |height|.
#include "compute/front.glsl"

const float kFolded = -0.3, kLevel = 0.4, kLeft = 0.4, kLeastFront = 0.05;

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  float height = marks[at].moved == kMoved ? abs(surface[at].position.w) : 0.0;
  float least = kLevel;
  for (int i = rings[v].cornersBegin; i < rings[v].cornersEnd && height > 0.0; ++i) {
    Triangle t = triangles[corners[i] / 3];
    if (!(t.bindFront > kLeastFront)) continue;
    vec2 front = frontOf(t);
    if (front.x < kLevel * t.bindFront * front.y) least = min(least, front.x / (t.bindFront * front.y));
  }
  if (least < kLevel) height *= kLeft + (1.0 - kLeft) * smoothstep(kFolded, kLevel, least);
  heights[at] = floatBitsToUint(height);
}
