// shaders/compute/items.glsl: which item of which body an invocation works on, and the numbers that all stages read.
layout(local_size_x = 64) in;

layout(std140, binding = 2) uniform Making {
  int controlVertices;
  int controlEdges;
  int refinedVertices;
  int refinedTriangles;
  int drawnVertices;
  int primitiveCount;
  int bindingCount;
  int patchKind;   // As PatchKind.
  int carriers;    // Control vertices, edges and triangles.
  int cliqueSets;
  int wraps;       // `replace`: muscles wrap the body.
  int boneCount;
  float iso;
  float isoRoot;
  float isoRadius;
  float tolerance;     // Of roots, world.
  float searchLength;  // `replace`, world.
  int toAnchors;       // `replace`: rays go to the anchors, else along the normals.
  uvec4 vertexGroups;    // Of a dispatch over the refined vertices of all bodies,
  uvec4 triangleGroups;  // and over their triangles.
};

// In two dimensions, since some cards allow no more than 65,535 groups along one.
int item() {
  uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  return int(group * gl_WorkGroupSize.x + gl_LocalInvocationID.x);
}
int body() { return int(gl_WorkGroupID.z); }

// Sums in the processor's order: `precise` keeps a compiler from fusing or reordering them.
float dotOf(vec3 a, vec3 b) {
  precise float sum = a.x * b.x + a.y * b.y + a.z * b.z;
  return sum;
}

vec3 crossOf(vec3 a, vec3 b) {
  precise vec3 product = vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
  return product;
}

// v / |v|, or the fallback where v has no direction.
vec3 normalizeOr(vec3 v, vec3 fallback) {
  float squared = dotOf(v, v);
  if (squared > 1e-20 && squared < 1e20) {
    precise vec3 unit = v / sqrt(squared);
    return unit;
  }
  float largest = max(abs(v.x), max(abs(v.y), abs(v.z)));
  if (!(largest > 1.2e-38) || isinf(largest)) return fallback;
  vec3 scaled = v / largest;
  return scaled / sqrt(dotOf(scaled, scaled));
}
