#version 450 core
// shaders/compute/skin.comp: control vertices, their normals and rise directions follow the bones.
#include "compute/items.glsl"

struct Control {
  vec4 position;
  vec4 normal;
  vec4 rise;
};
struct Influence {
  int binding;
  float weight;
};
layout(std430, binding = 0) readonly buffer InfluenceBegin { int influenceBegin[]; };
layout(std430, binding = 1) readonly buffer Influences { Influence influences[]; };
layout(std430, binding = 2) readonly buffer BindControls { Control inBind[]; };
layout(std430, binding = 3) readonly buffer Matrices { mat4 matrices[]; };  // [bodies * bindings]
layout(std430, binding = 4) writeonly buffer Controls { Control inWorld[]; };

// By the cofactors: as normalMatrix of the processor.
vec3 carry(vec3 direction, vec3 c0, vec3 c1, vec3 c2) {
  precise vec3 sum = c0 * direction.x + c1 * direction.y + c2 * direction.z;
  return normalizeOr(sum, direction);
}

void main() {
  int v = item();
  if (v >= controlVertices) return;
  precise mat4 m = mat4(0.0);
  for (int i = influenceBegin[v]; i < influenceBegin[v + 1]; ++i) {
    m += matrices[body() * bindingCount + influences[i].binding] * influences[i].weight;
  }
  vec3 x = m[0].xyz, y = m[1].xyz, z = m[2].xyz;
  vec3 c0 = crossOf(y, z), c1 = crossOf(z, x), c2 = crossOf(x, y);
  float sign = dotOf(x, c0) < 0.0 ? -1.0 : 1.0;
  c0 *= sign;
  c1 *= sign;
  c2 *= sign;
  vec3 p = inBind[v].position.xyz;
  precise vec3 moved = (x * p.x + y * p.y) + (z * p.z + m[3].xyz);
  int at = body() * controlVertices + v;
  inWorld[at].position = vec4(moved, 1.0);
  inWorld[at].normal = vec4(carry(inBind[v].normal.xyz, c0, c1, c2), 0.0);
  inWorld[at].rise = vec4(carry(inBind[v].rise.xyz, c0, c1, c2), 0.0);
}
