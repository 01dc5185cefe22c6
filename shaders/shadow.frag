#version 450 core
// shaders/shadow.frag: x: shadow, weaker the higher it is cast from; y: contact, only of what nearly touches the floor.
// With ALPHA, both as far as the surface is seen: what the cutoff takes away casts none, what is half seen casts half.
#include "frame.glsl"
in float above;
layout(location = 0) out vec2 shade;
#ifdef ALPHA
in vec2 atMap;
in float vertexAlpha;
uniform sampler2D baseMap;
uniform vec2 alpha;  // Base color's, cutoff (below 0: it blends).
#endif

void main() {
  float h = above / picture.z;
  shade = vec2(exp(-0.9 * h), exp(-22.0 * h));
#ifdef ALPHA
  float seen = alpha.x * texture(baseMap, atMap).a * vertexAlpha;
  if (alpha.y < 0.0) shade *= clamp(seen, 0.0, 1.0);
  else if (seen < alpha.y - 1e-5) discard;  // The interpolated 1 of a vertex may be a little less.
#endif
}
