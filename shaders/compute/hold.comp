#version 450 core
// shaders/compute/hold.comp: normals are held to what the faces around a vertex can show. As
// core/surface/finish/normals_kernel.cpp.
#include "compute/items.glsl"
#include "compute/mesh.glsl"
#include "compute/numbers.glsl"
#include "core/geometry/formulas/finish.h"

layout(std430, binding = 0) readonly buffer Rings { Ring rings[]; };
layout(std430, binding = 1) readonly buffer Corners { int corners[]; };
layout(std430, binding = 2) readonly buffer Triangles { Triangle triangles[]; };
layout(std430, binding = 3) readonly buffer Patches { Vertex patches[]; };
layout(std430, binding = 4) buffer Surface { Vertex surface[]; };
layout(std430, binding = 5) readonly buffer Marks { Mark marks[]; };
// What muscles turn normals by; w: how far, squared.
layout(std430, binding = 6) writeonly buffer Turns { vec4 turns[]; };

// An angle from twice its cosine (Abramowitz & Stegun 4.4.45).
float roughAngle(float x) {
  float positive = min(0.5 * abs(x), 1.0);
  float polynomial = 1.5707288 + positive * (-0.2121144 + positive * (0.0742610 - positive * 0.0187293));
  float angle = sqrt(1.0 - positive) * polynomial;
  return x < 0.0 ? 3.14159265 - angle : angle;
}

// The unit normal of a triangle times its angle at `a`.
vec3 cornerNormal(vec3 a, vec3 b, vec3 c) {
  vec3 ab = b - a, bc = c - b, ca = a - c;
  vec3 face = crossOf(ab, bc);
  float one = dotOf(ab, ab), other = dotOf(ca, ca), squares = one * other, whole = dotOf(face, face);
  float cosine = squares > 0.0 ? ((one - dotOf(bc, bc)) + other) / sqrt(squares) : 0.0;
  float perLength = whole > 0.0 ? 1.0 / sqrt(whole) : 0.0;
  return roughAngle(cosine) * perLength * face;
}

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = firstVertex() + v;
  turns[at] = vec4(0.0);
  if (marks[at].moved == 0u) return;
  vec3 patchSum = vec3(0.0), sum = vec3(0.0);
  for (int i = rings[v].cornersBegin; i < rings[v].cornersEnd; ++i) {
    Triangle t = triangles[corners[i] / 3];
    int which = corners[i] % 3;
    int a = firstVertex() + v;
    int b = firstVertex() + (which == 0 ? t.b : which == 1 ? t.c : t.a);
    int c = firstVertex() + (which == 0 ? t.c : which == 1 ? t.a : t.b);
    patchSum += cornerNormal(patches[a].position.xyz, patches[b].position.xyz, patches[c].position.xyz);
    sum += cornerNormal(surface[a].position.xyz, surface[b].position.xyz, surface[c].position.xyz);
  }
  vec3 own = patches[at].normal.xyz, normal = surface[at].normal.xyz;
  vec3 ofField = normal - own;
  vec3 shown = turnOf(own, unitOfSum(patchSum, own), unitOfSum(sum, own));
  float turn = max(dotOf(ofField, ofField), dotOf(shown, shown));
  Held held = heldDelta(ofField, shown, marks[at].filtered);
  if (held.isHeld) normal = unitOfSum(own + held.delta, normal);
  surface[at].normal = vec4(normal, 0.0);
  turns[at] = vec4(held.delta, turn);
}
