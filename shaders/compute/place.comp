#version 450 core
// shaders/compute/place.comp: from a root to the raised vertex: limits of the height, and the field's normal. As
// core/surface/projection/swell.cpp.
#include "compute/items.glsl"
#include "compute/field.glsl"
#include "compute/numbers.glsl"
#include "core/geometry/formulas/potential.h"
#include "core/geometry/formulas/shape.h"
#include "core/geometry/formulas/rise.h"
#include "compute/shape.glsl"
#include "compute/potential.glsl"

const float kSettled = 1e-6;
#include "compute/blend.glsl"
#include "core/geometry/formulas/blend.h"
#include "compute/point.glsl"

struct Vertex {
  vec4 position;  // World; w: the height.
  vec4 normal;
};
struct Line {
  vec4 from;
  vec4 along;
};
layout(std430, binding = 4) readonly buffer Lines { Line lines[]; };
layout(std430, binding = 5) readonly buffer Roots { Root roots[]; };
layout(std430, binding = 6) buffer Surface { Vertex surface[]; };  // Holds the patch.

const float kLeastAlong = 0.2;

void main() {
  int v = item();
  if (v >= refinedVertices) return;
  int at = body() * refinedVertices + v;
  Root root = roots[at];
  if (root.state == kUntouched || root.way == 0.0) return;
  see(v, body());
  float s = root.way;
  vec3 n = surface[at].normal.xyz;
  vec3 d = lines[at].along.xyz;
  vec3 p = lines[at].from.xyz;
  float sense = s > 0.0 ? 1.0 : -1.0;
  SkinRay skin = SkinRay(sense, (1.0 - isoRadius) / root.blendWidth, isoRadius, isoRoot, s > 0.0 ? isoRoot : 1e30);
  float slope = -4.0 * skinSlope(skin, abs(s)) / max(dotOf(n, d), kLeastAlong);
  float touch = inverseTouchLimit(root.onSkin, iso, isoRoot, isoRadius, skin.inverseWidth);
  float below = abs(root.height);
  float height = s > 0.0 ? limitedRise(below, max(refined[v].weights.w, touch)) : -limitedRise(below, touch);
  vec3 ofField = normalizeOr(-(slope * n + fieldAt(p + s * d).yzw), n);
  precise vec3 position = p + height * d;
  vec3 normal = height == s ? ofField : normalizeOr(n + (height / s) * (ofField - n), n);
  surface[at] = Vertex(vec4(position, height), vec4(normal, 0.0));
}
