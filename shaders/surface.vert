#version 450 core
// shaders/surface.vert: the smoothed surface, streamed in world space. As GLASS it lies nearer by what is under glass too.
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float displacement;
layout(location = 3) in vec2 uv;
layout(location = 4) in vec2 skin;
#ifdef COLORED
layout(location = 5) in vec4 color;
#endif

out Surface {
  vec3 world;
  vec3 normal;
  vec2 uv;
  float displacement;
  vec2 skin;  // How open to the sky, territory: 0..1.
#ifdef COLORED
  vec4 color;  // Linear.
#endif
} vertex;

#ifdef GLASS
uniform vec2 depthScale;  // Elements (2, 2) and (3, 2) of the projection.
const float kOverMuscles = 0.015;  // Of the height: muscles that stand out of the skin by less are under glass too.

// Depth, -1..1, of what is that much nearer. Per vertex: a depth of each fragment's own would keep hidden glass from
// being left out before it is shaded.
float nearerDepth() {
  float far = (viewFromWorld * vec4(position, 1.0)).z + kOverMuscles * picture.z;
  float depth = depthScale.x * far + depthScale.y;
  return eye.w > 0.5 ? depth : depth / max(-far, 1e-6);
}
#endif

invariant gl_Position;  // As in depth.vert; and glass is drawn twice, by two programs, at the same depth.

void main() {
  vertex.world = position;
  vertex.normal = normal;
  vertex.uv = uv;
  vertex.displacement = displacement;
  vertex.skin = skin;
#ifdef COLORED
  vertex.color = color;
#endif
  gl_Position = clipFromWorld * vec4(position, 1.0);
#ifdef GLASS
  float nearest = -gl_Position.w;  // What the near plane cuts off stays cut off; nothing else is.
  if (gl_Position.z > nearest) gl_Position.z = max(nearerDepth() * gl_Position.w, nearest);
#endif
}
