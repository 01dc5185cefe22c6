#version 450 core
// shaders/compute/place.comp: from a root to the raised vertex: limits of the height, and the field's normal. As
// core/surface/projection/swell.cpp.
#include "compute/items.glsl"
#include "compute/field.glsl"

#define Real float
#define Real2 vec2
#define Real3 vec3
#include "compute/shape.glsl"
#include "compute/potential.glsl"

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

float limitedRise(float s, float inverseLimit) {
  if (!(s * inverseLimit > 0.5)) return s;
  float limit = 1.0 / inverseLimit;
  return limit - 0.25 * limit * limit / s;
}

float inverseTouchLimit(float onSkin, float width) {
  if (!(onSkin < iso)) return 0.0;
  float left = sqrt(min(1.0, iso - onSkin));
  float further = abs(onSkin) / ((isoRoot + left) * (sqrt(1.0 - left) + isoRadius));
  return (1.0 - smoothstep(0.5 * iso, iso, onSkin)) / (2.0 * width * further);
}

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
  float width = root.blendWidth / (1.0 - isoRadius);
  float r = max(0.0, s / width + isoRadius);
  float slope = 2.0 * r * -2.0 * max(0.0, 1.0 - r * r) / width / max(dotOf(n, d), kLeastAlong);
  float touch = inverseTouchLimit(root.onSkin, width);
  float below = abs(root.height);
  float height = s > 0.0 ? limitedRise(below, max(refined[v].weights.w, touch)) : -limitedRise(below, touch);
  vec3 ofField = normalizeOr(-(slope * n + fieldAt(p + s * d).yzw), n);
  precise vec3 position = p + height * d;
  vec3 normal = height == s ? ofField : normalizeOr(n + (height / s) * (ofField - n), n);
  surface[at] = Vertex(vec4(position, height), vec4(normal, 0.0));
}
