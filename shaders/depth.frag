#version 450 core
// shaders/depth.frag: what occlusion.frag needs of the surface: its normal and how far off it is.
#include "frame.glsl"

in vec3 world;
in vec3 shapeNormal;
#ifndef SOLID
in vec2 mapAt;
in float vertexAlpha;
#endif
layout(location = 0) out vec4 seen;  // World normal, towards the eye; distance along the view, 0: nothing.

#ifndef SOLID
uniform sampler2D baseMap;
uniform vec4 baseColor;
uniform vec4 finish;
#endif

void main() {
#ifndef SOLID
  if (finish.z >= 0.0 && baseColor.a * texture(baseMap, mapAt).a * vertexAlpha < finish.z - 1e-5) discard;
#endif
  vec3 n = normalize(shapeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
  seen = vec4(n, dot(world - eye.xyz, forward.xyz));
}
