#version 450 core
// shaders/ivory.vert: a bone as a shaft with knobs at both ends, from the origin to y = 1 of its own space.
#include "frame.glsl"
layout(location = 0) in vec3 position;  // Of the unit ball.
layout(location = 2) in vec4 placeX;
layout(location = 3) in vec4 placeY;
layout(location = 4) in vec4 placeZ;
layout(location = 5) in vec4 placeAt;
layout(location = 7) in vec4 style;  // Glow 0..1; y: length of the bone in widths.
#include "muscle.glsl"

// Distance from the axis at a height of 0..1, in widths.
float radiusAt(float height) {
  float knob = 0.9 / style.y;
  float low = height / knob, high = (1.0 - height) / knob;
  float end = clamp(min(low, high), 0.0, 1.0);
  return (0.50 + 0.42 * (exp(-low * low) + exp(-high * high))) * sqrt(1.0 - (1.0 - end) * (1.0 - end));
}

void main() {
  float height = clamp(0.5 + 0.5 * position.y, 0.0, 1.0);
  vec2 out_ = position.xz * inversesqrt(max(dot(position.xz, position.xz), 1e-12));
  float radius = radiusAt(height);
  float slope = (radiusAt(min(height + 0.002, 1.0)) - radiusAt(max(height - 0.002, 0.0))) / 0.004;
  mat3 linear = mat3(placeX.xyz, placeY.xyz, placeZ.xyz);
  world = linear * vec3(out_.x * radius, height, out_.y * radius) + placeAt.xyz;
  vec3 own = radius > 1e-4 ? vec3(out_.x, -slope, out_.y) : vec3(0.0, position.y, 0.0);
  shapeNormal = mat3(cross(linear[1], linear[2]), cross(linear[2], linear[0]), cross(linear[0], linear[1])) * own;
  around = linear[0];
  inMuscle = position;
  fibres = vec4(0.0);
  glow = style.x;
  gl_Position = clipFromWorld * vec4(world, 1.0);
}
