#version 450 core
// shaders/compute/crease.comp: heights are lowered where the pose folds the skin itself. As
// core/surface/finish/crease_lift.h.
#include "compute/items.glsl"
#include "compute/mesh.glsl"
#include "compute/numbers.glsl"
#include "core/geometry/formulas/finish.h"

struct Control {
  vec4 position;  // World; w: rho.
  vec4 normal;
  vec4 rise;
};
struct Refined {
  ivec4 place;   // Carrier, then the control vertices at its corners.
  vec4 weights;  // Barycentric, then 1/L of the rise.
};
layout(std430, binding = 0) readonly buffer RefinedVertices { Refined refined[]; };
layout(std430, binding = 1) readonly buffer Controls { Control controls[]; };
layout(std430, binding = 2) readonly buffer Surface { Vertex surface[]; };
layout(std430, binding = 3) readonly buffer Marks { Mark marks[]; };
layout(std430, binding = 4) writeonly buffer Heights { uint heights[]; };  // Bits of |height|.

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  float height = marks[at].moved == kMoved ? abs(surface[at].position.w) : 0.0;
  if (height > 0.0) {
    float rho = 0.0;
    for (int i = 0; i < 3; ++i) {
      rho += refined[v].weights[i] * controls[body() * controlVertices + refined[v].place[i + 1]].position.w;
    }
    height *= leftOfHeight(rho);
  }
  heights[at] = floatBitsToUint(height);
}
