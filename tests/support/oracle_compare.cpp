// tests/support/oracle_compare.cpp: a surface against the oracle.

#include "tests/support/oracle_compare.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace sinew::oracle {
namespace {

constexpr double kTolerance = 1e-4;  // Of H.

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

}  // namespace

void Tally::add(const Tally& other) {
  if (firstFar.empty() || (unexplained == 0 && other.unexplained > 0)) firstFar = other.firstFar;
  compared += other.compared;
  sought += other.sought;
  far += other.far;
  farUnsought += other.farUnsought;
  anotherRoot += other.anotherRoot;
  nearTangent += other.nearTangent;
  unexplained += other.unexplained;
  normalsOff += other.normalsOff;
  normalsOnCrease += other.normalsOnCrease;
  worst = std::max(worst, other.worst);
}

std::string Tally::text() const {
  std::ostringstream out;
  out << compared << " vertices compared, " << sought << " roots sought, " << far << " beyond 1e-4 H (" << anotherRoot
      << " another root, " << nearTangent << " near-tangent, " << unexplained << " unexplained), " << farUnsought
      << " off the patch, worst of the rest " << worst << " H; normals off by more than 1 degree: " << normalsOff
      << " (" << normalsOnCrease << " on a crease)";
  return out.str();
}

Tally compare(const Oracle& oracle, const Character& character, const Surface& surface, int stride, int first) {
  Tally tally;
  const double height = static_cast<double>(character.height);
  for (int v = first; v < static_cast<int>(surface.positions.size()); v += stride) {
    const Answer answer = oracle.evaluate(siteOf(character.mesh, *surface.refinement, v));
    const auto index = static_cast<std::size_t>(v);
    const Vec seen = vec(surface.positions[index]);
    const double distance = length(seen - answer.position) / height;
    ++tally.compared;
    if (answer.sought) ++tally.sought;
    if (!(distance <= kTolerance)) {
      Tally one;
      one.firstFar = describe(v, answer, seen, height);
      if (answer.sought) {
        one.far = 1;
        explain(one, oracle, answer, seen, height);
      } else {
        one.farUnsought = 1;
      }
      tally.add(one);
      continue;
    }
    tally.worst = std::max(tally.worst, distance);
    const double cosine = dot(vec(surface.normals[index]), answer.normal);
    if (!(cosine >= std::cos(3.14159265358979 / 180.0))) {
      ++tally.normalsOff;
      if (answer.lead < 1e-3) ++tally.normalsOnCrease;
    }
  }
  return tally;
}

}  // namespace sinew::oracle
