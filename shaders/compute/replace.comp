#version 450 core
// shaders/compute/replace.comp: vertices go to the muscles' own surface, all in double precision. As
// core/surface/projection/replace.cpp.
#include "compute/items.glsl"
#include "compute/field.glsl"
#include "compute/numbers.glsl"
#include "core/geometry/formulas/potential.h"
#include "core/geometry/formulas/shape.h"
#include "core/geometry/formulas/rise.h"
#include "compute/shape.glsl"
#include "compute/potential.glsl"

const float kSettled = 1e-6;
#include "compute/blend.glsl"
#include "core/geometry/formulas/blend.h"
#include "compute/point.glsl"
#include "compute/exact.glsl"

struct Vertex {
  vec4 position;  // World; w: the height.
  vec4 normal;
};
struct Line {
  vec4 from;
  vec4 along;
};
layout(std430, binding = 4) readonly buffer Lines { Line lines[]; };
layout(std430, binding = 5) readonly buffer Anchors { vec4 anchors[]; };  // World.
layout(std430, binding = 6) readonly buffer Omegas { float omegas[]; };
layout(std430, binding = 7) buffer Surface { Vertex surface[]; };  // Holds the patch.

const float kFadeBegin = 0.8, kFullProminence = 0.25;
const int kProminenceSamples[9] = int[9](5, 3, 7, 2, 8, 4, 6, 1, 9);  // Tenths of a stretch.
const int kMostStretches = 8;

// Roots laid over each other, front to back.
vec3 sumPosition, sumNormal;
float sumWeight;
bool anyFound;

// Largest phi over a stretch, by samples, or as much as counts whole.
double prominence(double begin, double end) {
  double whole = double(kFullProminence * iso), largest = 0.0lf;
  for (int i = 0; i < 9 && largest < whole; ++i) {
    largest = max(largest, sampleExact(begin + (end - begin) * double(kProminenceSamples[i]) / 10.0lf).x);
  }
  return largest;
}

void addRoot(vec3 position, double distance, double prominent, vec3 n) {
  double far = (distance / double(searchLength) - double(kFadeBegin)) / (1.0lf - double(kFadeBegin));
  double share = prominent / double(kFullProminence * iso);
  float own = smoothstep(0.0, 1.0, float(share)) * (1.0 - smoothstep(0.0, 1.0, float(far)));
  float left = 1.0 - sumWeight;
  float weight = own == 1.0 ? left : own * left;
  anyFound = true;
  if (weight <= 0.0) return;
  sumPosition += weight * position;
  sumNormal += weight * normalizeOr(-fieldAt(position).yzw, n);
  sumWeight = own == 1.0 ? 1.0 : sumWeight + weight;
}

void gatherAlong(vec3 p, vec3 direction) {
  exactCount = 0;
  gatherTerms(p, direction);
}

// What is looked for along a line: from inside first outwards, then where p's own stretch ends inwards; then, stretch
// after stretch, where the next one begins and ends.
const int kOut = 0, kOwnEnd = 1, kRise = 2, kFall = 3;

void addLine(vec3 p, vec3 inwards, double end, bool inside, vec3 n) {
  double nudge = 4.0lf * double(tolerance);
  double reachable = min(end, double(searchLength));
  double outRoot = kNone, outProminence = 0.0lf, t = 0.0lf, rise = 0.0lf;
  int wanted = inside ? kOut : kRise;
  gatherAlong(p, inside ? -inwards : inwards);
  for (int i = 0; i < 2 + 2 * kMostStretches; ++i) {
    if (wanted == kRise && (wraps == 0 || !(t < reachable) || !(sumWeight < 1.0))) return;
    double from = wanted == kRise ? t : wanted == kFall ? rise + nudge : 0.0lf;
    double to = wanted == kOut ? double(searchLength) : wanted == kRise ? reachable : end;
    double found = firstChange(from, to, wanted != kRise);
    if (wanted == kOut) {
      outRoot = found;
      if (found != kNone) outProminence = prominence(0.0lf, found);
      gatherAlong(p, inwards);
      wanted = kOwnEnd;
    } else if (wanted == kRise) {
      if (found == kNone) return;
      rise = found;
      wanted = kFall;
    } else {
      double last = found == kNone ? end : found;
      double root = wanted == kOwnEnd ? outRoot : rise;
      double prominent = prominence(wanted == kOwnEnd ? 0.0lf : rise, last);
      if (wanted == kOwnEnd) prominent = max(prominent, max(outProminence, sampleExact(0.0lf).x));
      float way = wanted == kOwnEnd ? -float(root) : float(root);
      if (root != kNone) addRoot(p + way * inwards, root, prominent, n);
      t = wanted == kFall || last > 0.0lf ? last + nudge : 0.0lf;
      wanted = kRise;
    }
  }
}

void addLines(vec3 p, vec3 n, vec3 anchor, bool inside) {
  vec3 way = anchor - p;
  int lineCount = toAnchors != 0 && !inside ? 2 : 1;  // The anchor is not always inside: then along the normal.
  for (int line = 0; line < lineCount && sumWeight < 1.0; ++line) {
    bool toAnchor = toAnchors != 0 && line == 0;
    addLine(p, toAnchor ? normalizeOr(way, -n) : -n, double(toAnchor ? length(way) : searchLength), inside, n);
  }
}

Vertex placed(Vertex onPatch, float omega, float inverseLimit) {
  vec3 p = onPatch.position.xyz, n = onPatch.normal.xyz;
  float patchShare = 1.0 - omega * sumWeight;
  vec3 position = patchShare == 0.0 ? sumPosition : sumPosition * omega + p * patchShare;
  vec3 normal = normalizeOr(sumNormal * omega + n * patchShare, n);
  float height = dotOf(position - p, n);
  float rise = length(position - p);
  float limited = limitedRise(rise, inverseLimit);
  if (limited != rise) {
    float share = limited / rise;
    position = p + share * (position - p);
    normal = normalizeOr(n + share * (normal - n), n);
    height *= share;
  }
  return Vertex(vec4(position, height), vec4(normal, 0.0));
}

bool seesAny() {
  for (int i = firstCandidate; i < endCandidate; ++i) {
    if (weightOf(candidates[i]) > 0.0) return true;
  }
  return false;
}

void main() {
  int v = item();
  if (v >= refinedVertices || !(omegas[v] > 0.0)) return;
  see(v, body());
  if (!seesAny()) return;
  int at = body() * refinedVertices + v;
  vec3 p = lines[at].from.xyz;
  bool inside = fieldAt(p).x > iso;
  if (wraps == 0 && !inside) return;
  sumPosition = sumNormal = vec3(0.0);
  sumWeight = 0.0;
  anyFound = false;
  addLines(p, lines[at].along.xyz, anchors[at].xyz, inside);
  if (!anyFound || !(sumWeight > 0.0)) return;
  surface[at] = placed(surface[at], omegas[v], wraps == 0 ? refined[v].weights.w : 0.0);
}
