#version 450 core
// shaders/dot.vert: round dots at both ends of free segments, one instance a segment, 12 vertices; the second smaller.
#include "frame.glsl"
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 tint;
uniform vec2 radii;  // Pixels, at `from` and at `to`.
flat out vec4 color;
flat out float radius;
out vec2 fromCenter;  // Pixels.

void main() {
  int corner = gl_VertexID % 6;
  bool atFrom = gl_VertexID < 6;
  color = tint;
  radius = atFrom ? radii.x : radii.y;
  vec2 side = vec2(corner == 1 || corner == 2 || corner == 4 ? 1.0 : -1.0,
                   corner == 2 || corner == 4 || corner == 5 ? 1.0 : -1.0);
  fromCenter = side * (radius + 1.0);
  vec3 at = atFrom ? from : to;
  gl_Position = clipFromWorld * vec4(at + toEye(at) * 0.002 * picture.z, 1.0);
  gl_Position.xy += fromCenter * 2.0 / picture.xy * gl_Position.w;
}
