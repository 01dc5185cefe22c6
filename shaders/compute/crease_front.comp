#version 450 core
// shaders/compute/crease_front.comp: how much the skin around each control vertex still faces outwards: rho of
// core/surface/finish/crease_lift.h.
#include "compute/items.glsl"
#include "compute/numbers.glsl"
#define dot(a, b) dotOf(a, b)
#define cross(a, b) crossOf(a, b)
#include "core/geometry/formulas/finish.h"

struct Control {
  vec4 position;  // World; w: out: rho.
  vec4 normal;
  vec4 rise;
};
struct ControlTriangle {
  int a, b, c;
  float perBindFront;  // 1 / the front in the bind pose; 0: has no say.
};
layout(std430, binding = 0) readonly buffer Fans { int fans[]; };  // Where each vertex's begins, then triangles.
layout(std430, binding = 1) readonly buffer ControlTriangles { ControlTriangle triangles[]; };
layout(std430, binding = 2) buffer Controls { Control controls[]; };

vec3 positionOf(int v) { return controls[body() * controlVertices + v].position.xyz; }
vec3 normalOf(int v) { return controls[body() * controlVertices + v].normal.xyz; }

float frontOf(ControlTriangle t) {
  vec3 a = positionOf(t.a);
  vec3 u = positionOf(t.b) - a, v = positionOf(t.c) - a;
  return frontOf(crossOf(u, v), normalOf(t.a) + normalOf(t.b) + normalOf(t.c), u, v);
}

void main() {
  int v = item();
  if (v >= controlVertices) return;
  float rho = 1.0;
  for (int i = fans[v]; i < fans[v + 1]; ++i) {
    ControlTriangle t = triangles[fans[i]];
    if (t.perBindFront > 0.0) rho = min(rho, max(-1.0, t.perBindFront * frontOf(t)));
  }
  controls[body() * controlVertices + v].position.w = rho;
}
