#version 450 core
// shaders/muscle.vert: the belly of a muscle, once per instance; y runs along its fibres.
#include "frame.glsl"
#include "form.glsl"
layout(location = 0) in vec3 position;
layout(location = 2) in vec4 placeX;  // Columns of unit ball -> world.
layout(location = 3) in vec4 placeY;
layout(location = 4) in vec4 placeZ;
layout(location = 5) in vec4 placeAt;
layout(location = 6) in vec4 tint;   // As muscle.glsl has it.
layout(location = 7) in vec4 style;  // Glow 0..1; w > 0: shaped by `form`, to that scale.
layout(location = 8) in vec4 form[FORM_VECTORS];
#include "muscle.glsl"

void main() {
  mat3 linear = mat3(placeX.xyz, placeY.xyz, placeZ.xyz);
  vec3 at = style.w > 0.0 ? onForm(formOf(form), style.w, position) : position;
  vec3 own = style.w > 0.0 ? formSlope(formOf(form), at) : position;
  world = linear * at + placeAt.xyz;
  shapeNormal = mat3(cross(linear[1], linear[2]), cross(linear[2], linear[0]), cross(linear[0], linear[1])) * own;
  if (dot(cross(linear[0], linear[1]), linear[2]) < 0.0) shapeNormal = -shapeNormal;
  around = linear * vec3(position.z, 0.0, -position.x);
  inMuscle = vec3(position.x, at.y, position.z);
  fibres = tint;
  glow = style.x;
  gl_Position = clipFromWorld * vec4(world, 1.0);
}
