// shaders/compute/front.glsl: how much a triangle of the patch faces along its normals. As
// core/surface/finish/fold.h.
vec3 patchFace(Triangle t) {
  vec3 a = patches[firstVertex() + t.a].position.xyz;
  return crossOf(patches[firstVertex() + t.b].position.xyz - a, patches[firstVertex() + t.c].position.xyz - a);
}

// Twice the area along the sum of the normals, and three times the sum of the squared edges.
vec2 frontOf(Triangle t) {
  vec3 a = patches[firstVertex() + t.a].position.xyz;
  vec3 u = patches[firstVertex() + t.b].position.xyz - a, v = patches[firstVertex() + t.c].position.xyz - a;
  vec3 normals = patches[firstVertex() + t.a].normal.xyz + patches[firstVertex() + t.b].normal.xyz +
                 patches[firstVertex() + t.c].normal.xyz;
  return vec2(dotOf(crossOf(u, v), normals), 3.0 * (dotOf(u, u) + dotOf(v, v) + dotOf(v - u, v - u)));
}
