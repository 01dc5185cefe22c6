#version 450 core
// shaders/surface_wire.geom: gives every fragment its distance in pixels to the triangle's edges.
// Source: Baerentzen et al., "Single-pass wireframe rendering", SIGGRAPH sketches 2006.
#include "frame.glsl"
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

in Surface {
  vec3 world;
  vec3 normal;
  vec2 uv;
  float displacement;
  vec2 skin;  // How open to the sky, territory: 0..1.
#ifdef COLORED
  vec4 color;  // Linear.
#endif
} corner[];

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
noperspective out vec3 edgePixels;
flat out vec3 altitudes;

void main() {
  vec3 heights = vec3(1e6);
  if (min(gl_in[0].gl_Position.w, min(gl_in[1].gl_Position.w, gl_in[2].gl_Position.w)) > 0.0) {
    vec2 half_ = 0.5 * picture.xy;
    vec2 a = half_ * gl_in[0].gl_Position.xy / gl_in[0].gl_Position.w;
    vec2 b = half_ * gl_in[1].gl_Position.xy / gl_in[1].gl_Position.w;
    vec2 c = half_ * gl_in[2].gl_Position.xy / gl_in[2].gl_Position.w;
    float area = abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    heights = area / max(vec3(distance(b, c), distance(c, a), distance(a, b)), vec3(1e-4));
  }
  for (int i = 0; i < 3; ++i) {
    vertex.world = corner[i].world;
    vertex.normal = corner[i].normal;
    vertex.uv = corner[i].uv;
    vertex.displacement = corner[i].displacement;
    vertex.skin = corner[i].skin;
#ifdef COLORED
    vertex.color = corner[i].color;
#endif
    edgePixels = vec3(0.0);
    edgePixels[i] = heights[i];
    if (heights.x > 9e5) edgePixels = vec3(1e6);
    altitudes = heights;
    gl_PrimitiveID = gl_PrimitiveIDIn;
    gl_Position = gl_in[i].gl_Position;
    EmitVertex();
  }
  EndPrimitive();
}
