// shaders/compute/field.glsl: the muscles that a refined vertex sees.
struct Refined {
  ivec4 place;   // Carrier, then the control vertices at its corners.
  vec4 weights;  // Barycentric, then 1/L of the rise.
};
struct Candidate {
  int primitive;
  uint slot;  // Of its group.
  float w0, w1, w2;
};
struct Primitive {
  // Columns of the map to the unit ball; w: strength, width over which it blends, 1 / radius of a sphere or 0.
  vec4 toUnit[3];
  vec4 center;     // World; w: radius of a ball that holds the influence.
  // Of a muscle that is no ellipsoid, in its unit space (UnitShape of the processor):
  vec4 bendCurve;  // The axis is at bend + curve y^2.
  vec4 section;    // nu S(y) = x + y y; z: half the core; w: 1 / the end's length.
  vec4 low;        // A box around the influence; w: 1: it is no ellipsoid.
  vec4 high;       // w: mean radius, of an ellipsoid too.
  vec4 groove;     // kappa; y: 1: some muscle of the body has one.
};
struct Root {
  float way;         // Signed, along the line, before any limit; `replace`: unused.
  float onSkin;      // F there.
  float blendWidth;  // h there.
  int state;         // As below.
  float height;      // way, or less below what hangs over the skin; of kUnsure the muscles' mean radius.
};
const int kUntouched = 0, kFound = 1, kUnsure = 2, kUnsureShaped = 3;

layout(std430, binding = 0) readonly buffer RefinedVertices { Refined refined[]; };
// By carrier: first candidate, set of cliques; by set: first level; by level: first clique and weight; cliques.
layout(std430, binding = 1) readonly buffer Seen { int seen[]; };
layout(std430, binding = 2) readonly buffer Candidates { Candidate candidates[]; };
layout(std430, binding = 3) readonly buffer Primitives { Primitive primitives[]; };  // [bodies * primitives]

const int kMostCliques = 64;
const uint kEverySum = 0xffffffffu;  // In place of a slot: counts in every clique.

int firstCandidate, endCandidate;
int firstLevel, levelsSeen;    // Several where groups are linked in part: F is the weighted mean.
int firstClique, cliquesSeen;  // Of all levels, one after another.
vec3 corners;        // Weights of the carrier's corners.
int firstPrimitive;  // Of the body.
// Cliques share F, instead of the highest having it. Without SOFT the compiler leaves out what that takes.
#ifdef SOFT
bool softGrooves;
#else
const bool softGrooves = false;
#endif

int levelEnd(int level) { return seen[firstLevel + 2 * level + 2] - seen[firstLevel]; }  // Among all cliques.
float levelWeight(int level) { return intBitsToFloat(seen[firstLevel + 2 * level + 1]); }

void see(int vertex, int ofBody) {
  int carrier = refined[vertex].place.x;
  corners = refined[vertex].weights.xyz;
  firstCandidate = seen[carrier];
  endCandidate = seen[carrier + 1];
  int sets = 2 * carriers + 1, levels = sets + cliqueSets + 1;
  int set = seen[carriers + 1 + carrier];
  levelsSeen = seen[sets + set + 1] - seen[sets + set];
  firstLevel = levels + 2 * seen[sets + set];
  firstClique = levels + 2 * (seen[sets + cliqueSets] + 1) + 2 * seen[firstLevel];
  cliquesSeen = levelEnd(levelsSeen - 1);
  firstPrimitive = ofBody * primitiveCount;
#ifdef SOFT
  bool blends = cliquesSeen > 1 && firstCandidate < endCandidate;
  softGrooves = blends && primitives[firstPrimitive].groove.y > 0.0;
#endif
}

// A bit a slot.
uvec2 cliqueAt(int k) { return uvec2(seen[firstClique + 2 * k], seen[firstClique + 2 * k + 1]); }
bool holds(uvec2 clique, uint slot) {
  return ((slot < 32u ? clique.x >> slot : clique.y >> (slot - 32u)) & 1u) != 0u;
}

float weightOf(Candidate c) {
  precise float weight = c.w0 * corners.x + c.w1 * corners.y + c.w2 * corners.z;
  return weight;
}

float scaleOf(Primitive p) { return p.toUnit[2].w > 0.0 ? p.toUnit[2].w * p.toUnit[2].w : 1.0; }
bool isShaped(Primitive p) { return p.low.w != 0.0; }
float strengthOf(Primitive p) { return p.toUnit[0].w; }
float blendWidthOf(Primitive p) { return p.toUnit[1].w; }
float meanRadiusOf(Primitive p) { return p.high.w; }
float grooveOf(Primitive p) { return p.groove.x; }
