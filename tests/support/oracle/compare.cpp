// tests/support/oracle/compare.cpp: comparison of a surface with the oracle.

#include "tests/support/oracle/compare.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace sinew::oracle {
namespace {

constexpr double kTolerance = 1e-4;  // Fraction of H.
constexpr double kRough = 1e-5;

std::string describe(int vertex, const Answer& answer, const Vec& seen, double height) {
  const Vec away = seen - answer.rayOrigin;
  std::ostringstream out;
  out << "vertex " << vertex << ": oracle (" << answer.position.x << ", " << answer.position.y << ", "
      << answer.position.z << "), surface (" << seen.x << ", " << seen.y << ", " << seen.z << "), "
      << length(seen - answer.position) / height << " H apart; oracle offset " << answer.offset / height
      << " H, surface " << dot(away, answer.rayDirection) / height << " H along the ray, F at start " << answer.field
      << ", weight " << answer.weight << (answer.resolved ? "" : ", unresolved")
      << (answer.fellBack ? ", anchor outside" : "") << ", roots:";
  for (const double root : answer.roots) out << ' ' << root / height;
  return out.str();
}

void explain(Tally& tally, const Oracle& oracle, const Answer& answer, const Vec& seen, double height) {
  const double along = dot(seen - answer.rayOrigin, answer.rayDirection);
  const bool onRay = length(seen - answer.rayOrigin - along * answer.rayDirection) < kTolerance * height;
  const bool onRoot = std::any_of(answer.roots.begin(), answer.roots.end(),
                                  [&](double root) { return std::abs(root - along) < kTolerance * height; });
  if (onRay && onRoot) {
    ++tally.anotherRoot;
  } else if (onRay && std::abs(oracle.phiAt(answer, along)) < 1e-4) {
    ++tally.nearTangent;
  } else {
    ++tally.unexplained;
  }
}

double degreesBetween(const Vec& a, const Vec& b) {
  return std::acos(std::clamp(dot(a, b) / (length(a) * length(b)), -1.0, 1.0)) * 180.0 / 3.14159265358979;
}

/// By more than 1 degree.
bool isOff(const Vec& normal, const Vec& expected) { return !(degreesBetween(normal, expected) <= 1.0); }

void note(Tally& tally, int vertex, const char* what, double amount) {
  if (!tally.firstOff.empty()) return;
  std::ostringstream out;
  out << "vertex " << vertex << ": " << what << ' ' << amount;
  tally.firstOff = out.str();
}

/// One vertex before folds are taken out against the brute-force search.
void compareRaw(Tally& tally, const Oracle& oracle, const Answer& answer, int vertex, const Vec& seen,
                const Vec& normal, double height) {
  const double distance = length(seen - answer.position) / height;
  if (!(distance <= kTolerance)) {
    Tally one;
    one.firstFar = describe(vertex, answer, seen, height);
    if (answer.sought) {
      one.far = 1;
      explain(one, oracle, answer, seen, height);
    } else {
      one.farUnsought = 1;
    }
    tally.add(one);
    return;
  }
  tally.worst = std::max(tally.worst, distance);
  if (answer.sought && distance > kRough) ++tally.rough;
  if (!isOff(normal, answer.normal)) return;
  ++tally.normalsOff;
  if (answer.lead < 1e-3) {
    ++tally.normalsOnCrease;
  } else {
    note(tally, vertex, "field normal off by", degreesBetween(normal, answer.normal));
  }
}

void compareFinished(Tally& tally, const Finished& finished, std::size_t vertex, const Surface& surface,
                     double height) {
  const double distance = length(vec(surface.positions[vertex]) - finished.positions[vertex]) / height;
  const bool guarded = finished.guarded[vertex];
  tally.guarded += guarded ? 1 : 0;
  if (guarded && !(distance <= kTolerance)) {
    ++tally.guardOff;
    note(tally, static_cast<int>(vertex), "guard off by (H)", distance);
  }
  const Vec normal = vec(surface.normals[vertex]);
  tally.worstShading = std::max(tally.worstShading, degreesBetween(normal, finished.normals[vertex]));
  if (!isOff(normal, finished.normals[vertex])) return;
  ++tally.shadingOff;
  note(tally, static_cast<int>(vertex), "shading off by", degreesBetween(normal, finished.normals[vertex]));
}

}  // namespace

void Tally::add(const Tally& other) {
  if (firstFar.empty() || (unexplained == 0 && other.unexplained > 0)) firstFar = other.firstFar;
  compared += other.compared;
  sought += other.sought;
  far += other.far;
  rough += other.rough;
  inGrooves += other.inGrooves;
  whereGroovesMeet += other.whereGroovesMeet;
  farUnsought += other.farUnsought;
  anotherRoot += other.anotherRoot;
  nearTangent += other.nearTangent;
  unexplained += other.unexplained;
  guarded += other.guarded;
  guardOff += other.guardOff;
  shadingOff += other.shadingOff;
  if (firstOff.empty()) firstOff = other.firstOff;
  normalsOff += other.normalsOff;
  normalsOnCrease += other.normalsOnCrease;
  worstShading = std::max(worstShading, other.worstShading);
  worst = std::max(worst, other.worst);
}

std::string Tally::text() const {
  std::ostringstream out;
  out << compared << " vertices compared, " << sought << " roots sought, " << far << " beyond 1e-4 H (" << anotherRoot
      << " another root, " << nearTangent << " near-tangent, " << unexplained << " unexplained), " << farUnsought
      << " off the patch, worst of the rest " << worst << " H, " << rough
      << " beyond 1e-5 H; normals off by more than 1 degree: " << normalsOff << " (" << normalsOnCrease
      << " on a crease); " << guarded << " guarded (" << guardOff << " off), shading off: " << shadingOff << " (worst "
      << worstShading << " degrees); " << inGrooves << " in grooves, " << whereGroovesMeet << " where they meet";
  return out.str();
}

Tally compare(const Oracle& oracle, const Character& character, const Stages& stages, const Surface& surface,
              int stride, int first) {
  Tally tally;
  const double height = static_cast<double>(character.height);
  for (int v = first; v < static_cast<int>(surface.positions.size()); v += stride) {
    const Answer answer = oracle.evaluate(siteOf(character.mesh, *surface.refinement, v));
    const auto index = static_cast<std::size_t>(v);
    ++tally.compared;
    if (answer.sought) ++tally.sought;
    const int inPart = oracle.field().groupsInPart(answer.position, answer.fieldWeights);
    tally.inGrooves += inPart > 0 ? 1 : 0;
    tally.whereGroovesMeet += inPart > 2 ? 1 : 0;
    const bool guarded = stages.finished.guarded[index];
    const Vec seen = vec(guarded ? stages.raw.positions[index] : surface.positions[index]);
    compareRaw(tally, oracle, answer, v, seen, vec(stages.raw.normals[index]), height);
    compareFinished(tally, stages.finished, index, surface, height);
  }
  return tally;
}

}  // namespace sinew::oracle
