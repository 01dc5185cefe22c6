#version 450 core
// shaders/part.frag: one part of the mesh as a flat tint over the picture. Premultiplied.

in vec2 mapAt;
in float vertexAlpha;
layout(location = 0) out vec4 outColor;

uniform sampler2D baseMap;
uniform vec4 baseColor;
uniform vec4 finish;        // As in surface.frag.
uniform vec4 tint;          // Linear; w: opacity.
uniform int part;
uniform int firstTriangle;  // Of this draw.
layout(std430, binding = 0) readonly buffer Parts { int partOf[]; };        // By control triangle.
layout(std430, binding = 1) readonly buffer Controls { int controlOf[]; };  // By drawn triangle.

void main() {
  if (partOf[controlOf[firstTriangle + gl_PrimitiveID]] != part) discard;
  float alpha = baseColor.a * texture(baseMap, mapAt).a * vertexAlpha;
  if (finish.z >= 0.0 && alpha < finish.z - 1e-5) discard;
  float strength = tint.w * (finish.w > 0.5 ? min(alpha, 1.0) : 1.0);
  outColor = vec4(tint.rgb * strength, strength);
}
