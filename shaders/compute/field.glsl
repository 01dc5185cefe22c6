// shaders/compute/field.glsl: the muscles that a refined vertex sees, and their field at a point. As core/blending/field.cpp.
struct Refined {
  ivec4 place;   // Carrier, then the control vertices at its corners.
  vec4 weights;  // Barycentric, then 1/L of the rise.
};
struct Candidate {
  int primitive;
  uint bit;  // Of its group's slot; cliques are sums of bits.
  float w0, w1, w2;
};
struct Primitive {
  vec4 toUnit[3];  // Columns of the map to the unit ball; w: strength, width over which it blends, 1 / radius of a sphere or 0.
  vec4 center;     // World; w: radius of a ball that holds the influence.
};
struct Root {
  float way;         // Signed, along the line, before any limit; `replace`: unused.
  float onSkin;      // F there.
  float blendWidth;  // h there.
  int state;         // As below.
};
const int kUntouched = 0, kFound = 1, kUnsure = 2;

layout(std430, binding = 0) readonly buffer RefinedVertices { Refined refined[]; };
layout(std430, binding = 1) readonly buffer Seen { int seen[]; };  // By carrier: first candidate, set of cliques; cliques.
layout(std430, binding = 2) readonly buffer Candidates { Candidate candidates[]; };
layout(std430, binding = 3) readonly buffer Primitives { Primitive primitives[]; };  // [bodies * primitives]

const int kMostCliques = 16;
const uint kEverySum = 0xffffffffu;

int firstCandidate, endCandidate, firstClique, cliqueCount;
vec3 corners;        // Weights of the carrier's corners.
int firstPrimitive;  // Of the body.

void see(int vertex, int ofBody) {
  int carrier = refined[vertex].place.x;
  corners = refined[vertex].weights.xyz;
  firstCandidate = seen[carrier];
  endCandidate = seen[carrier + 1];
  int sets = 2 * carriers + 1;
  int set = seen[carriers + 1 + carrier];
  firstClique = sets + cliqueSets + 1 + seen[sets + set];
  cliqueCount = seen[sets + set + 1] - seen[sets + set];
  firstPrimitive = ofBody * primitiveCount;
}

uint cliqueAt(int k) { return uint(seen[firstClique + k]); }

float weightOf(Candidate c) {
  precise float weight = c.w0 * corners.x + c.w1 * corners.y + c.w2 * corners.z;
  return weight;
}

vec3 inUnit(Primitive p, vec3 d) {
  if (p.toUnit[2].w > 0.0) return d;
  precise vec3 y = d.x * p.toUnit[0].xyz + d.y * p.toUnit[1].xyz + d.z * p.toUnit[2].xyz;
  return y;
}
float scaleOf(Primitive p) { return p.toUnit[2].w > 0.0 ? p.toUnit[2].w * p.toUnit[2].w : 1.0; }
float strengthOf(Primitive p) { return p.toUnit[0].w; }
float blendWidthOf(Primitive p) { return p.toUnit[1].w; }

float rSquaredAt(Primitive p, vec3 fromCenter) {
  vec3 y = inUnit(p, fromCenter);
  return scaleOf(p) * dotOf(y, y);
}

// Half of d(r^2)/dx.
vec3 halfSlopeAt(Primitive p, vec3 fromCenter) {
  if (p.toUnit[2].w > 0.0) return scaleOf(p) * fromCenter;
  vec3 y = inUnit(p, fromCenter);
  return vec3(dotOf(p.toUnit[0].xyz, y), dotOf(p.toUnit[1].xyz, y), dotOf(p.toUnit[2].xyz, y));
}

// F and its gradient.
vec4 fieldAt(vec3 x) {
  vec4 carved = vec4(0.0);
  vec4 sums[kMostCliques];
  for (int k = 0; k < cliqueCount; ++k) sums[k] = vec4(0.0);
  for (int i = firstCandidate; i < endCandidate; ++i) {
    Candidate c = candidates[i];
    Primitive p = primitives[firstPrimitive + c.primitive];
    float weight = weightOf(c);
    float w = 1.0 - rSquaredAt(p, x - p.center.xyz);
    if (!(weight > 0.0) || !(w > 0.0) || p.center.w == 0.0) continue;
    float factor = strengthOf(p) * weight;
    vec4 part = factor * vec4(w * w, -4.0 * w * halfSlopeAt(p, x - p.center.xyz));
    if (factor < 0.0) {
      carved += part;
      continue;
    }
    for (int k = 0; k < cliqueCount; ++k) {
      if ((cliqueAt(k) & c.bit) != 0u) sums[k] += part;
    }
  }
  vec4 best = vec4(0.0);
  for (int k = 0; k < cliqueCount; ++k) {
    if (sums[k].x > best.x) best = sums[k];
  }
  return best + carved;
}
