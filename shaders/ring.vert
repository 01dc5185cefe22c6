#version 450 core
// shaders/ring.vert: three great circles of every primitive, 64 segments each; the far half fainter.
#include "form.glsl"
#include "frame.glsl"
#include "line.glsl"
layout(location = 2) in vec4 placeX;
layout(location = 3) in vec4 placeY;
layout(location = 4) in vec4 placeZ;
layout(location = 5) in vec4 placeAt;
layout(location = 6) in vec4 tint;
layout(location = 7) in vec4 style;  // w > 0: shaped by `form`, to that scale.
layout(location = 8) in vec4 form[FORM_VECTORS];
uniform float width;
uniform float dashes;  // Per circle; 0: unbroken.
flat out vec4 color;
out float dash;

vec3 onRing(int ring, float turn) {
  vec2 p = vec2(cos(turn), sin(turn));
  return ring == 0 ? vec3(0.0, p) : ring == 1 ? vec3(p.y, 0.0, p.x) : vec3(p, 0.0);
}

void main() {
  const int segments = 64;
  int segment = gl_VertexID / 6, corner = gl_VertexID % 6;
  int ring = segment / segments;
  float step_ = 6.2831853 / float(segments);
  float first = float(segment % segments) * step_;
  vec3 a = onRing(ring, first), b = onRing(ring, first + step_);
  mat3 linear = mat3(placeX.xyz, placeY.xyz, placeZ.xyz);
  mat3 cofactors = mat3(cross(linear[1], linear[2]), cross(linear[2], linear[0]), cross(linear[0], linear[1]));
  vec3 middle = normalize(a + b);
  vec3 own = middle;
  if (style.w > 0.0) {
    Form shaped = formOf(form);
    a = onForm(shaped, style.w, a);
    b = onForm(shaped, style.w, b);
    middle = onForm(shaped, style.w, middle);
    own = formSlope(shaped, middle);
  }
  vec3 n = normalize(cofactors * own);
  if (dot(cofactors[0], linear[0]) < 0.0) n = -n;
  float facing = dot(n, toEye(linear * middle + placeAt.xyz));
  float near = smoothstep(-0.15, 0.15, facing);
  color = vec4(mix(tint.rgb, vec3(1.0), 0.18 + 0.22 * style.y), mix(0.20, 0.80 + 0.20 * style.x, near));
  dash = (first + (corner == 0 || corner == 1 || corner == 3 ? 0.0 : step_)) / 6.2831853 * dashes;
  placeCorner(lifted(linear * a + placeAt.xyz), lifted(linear * b + placeAt.xyz), width + 0.5 * style.x, corner);
}
