#version 450 core
// shaders/shape.vert: a small mesh, once per instance: primitives, bones, joints.
#include "frame.glsl"
#include "form.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 placeX;  // Columns of shape -> world.
layout(location = 3) in vec4 placeY;
layout(location = 4) in vec4 placeZ;
layout(location = 5) in vec4 placeAt;
layout(location = 6) in vec4 tint;   // Linear color and opacity.
layout(location = 7) in vec4 style;  // Outline 0..1, glow 0..1; w > 0: shaped by `form`, to that scale.
layout(location = 8) in vec4 form[FORM_VECTORS];
uniform vec4 swell;  // Pixels by which the shape grows away from a point in it (w), and that point.
out vec3 world;
out vec3 shapeNormal;
flat out vec4 color;
flat out vec4 look;

void main() {
  mat3 linear = mat3(placeX.xyz, placeY.xyz, placeZ.xyz);
  vec3 at = style.w > 0.0 ? onForm(formOf(form), style.w, position) : position;
  vec3 own = style.w > 0.0 ? formSlope(formOf(form), at) : normal;
  world = linear * at + placeAt.xyz;
  // Cofactors carry normals, also through flattened shapes.
  shapeNormal = mat3(cross(linear[1], linear[2]), cross(linear[2], linear[0]), cross(linear[0], linear[1])) * own;
  if (dot(cross(linear[0], linear[1]), linear[2]) < 0.0) shapeNormal = -shapeNormal;
  color = tint;
  look = style;
  gl_Position = clipFromWorld * vec4(world, 1.0);
  if (swell.w > 0.0) {
    vec3 outwards = position - swell.xyz;
    vec3 squares = vec3(dot(linear[0], linear[0]), dot(linear[1], linear[1]), dot(linear[2], linear[2]));
    vec3 unit = inversesqrt(max(squares, vec3(1e-30)));
    vec2 onScreen = (mat3(clipFromWorld) * (linear * (outwards * unit))).xy * picture.xy;
    gl_Position.xy += normalize(onScreen + vec2(1e-12, 0.0)) * swell.w * 2.0 / picture.xy * gl_Position.w;
  }
}
