// core/rig/tendons.cpp: soft curves through few points.
#include "core/rig/tendons.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace sinew {
namespace {

constexpr float kBeside = 0.9f;  ///< Anchors must lie further out than this along the belly.
constexpr int kPerCurve = 24;    ///< Segments of a drawn curve.

glm::vec3 directionOr(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 0.0f ? v / length : otherwise;
}

/// From a point in one direction to a point in another.
std::array<glm::vec3, 4> softCurve(const glm::vec3& from, const glm::vec3& leaves, const glm::vec3& to,
                                   const glm::vec3& arrives) {
  const float third = glm::distance(from, to) / 3.0f;
  return {from, from + third * leaves, to - third * arrives, to};
}

std::optional<Tendon> tendonTo(const glm::mat4& belly, const glm::vec2& bend, float side, const glm::vec3& anchor,
                               const std::optional<glm::vec3>& via) {
  const glm::mat4 inBelly = glm::inverse(belly);
  const auto along = [&](const glm::vec3& point) { return side * (inBelly * glm::vec4(point, 1.0f)).y; };
  const float end = along(anchor);
  if (!(end > kBeside)) return std::nullopt;  // Also where the belly is flat.
  Tendon tendon;
  tendon.side = side;
  // On the belly's axis: (x, z) = bend (1 - y^2).
  const glm::vec2 aside = bend * (1.0f - kTendonStart * kTendonStart), turn = -2.0f * kTendonStart * bend;
  const glm::vec3 from(belly * glm::vec4(aside.x, kTendonStart * side, aside.y, 1.0f));
  const glm::vec3 straight = directionOr(anchor - from, glm::vec3(0.0f, 1.0f, 0.0f));
  const glm::vec3 leaves = directionOr(glm::mat3(belly) * glm::vec3(turn.x, side, turn.y), straight);
  if (via && along(*via) > 1.0f && along(*via) < end) {
    const float before = glm::distance(from, *via);
    tendon.length = before + glm::distance(*via, anchor);
    const float share = before / tendon.length;
    const glm::vec3 arrives = directionOr(anchor - *via, straight);
    tendon.parts = {{softCurve(from, leaves, *via, straight), {0.0f, share}},
                    {softCurve(*via, straight, anchor, arrives), {share, 1.0f}}};
    return tendon;
  }
  tendon.length = glm::distance(from, anchor);
  tendon.parts = {{softCurve(from, leaves, anchor, straight), {0.0f, 1.0f}}};
  return tendon;
}

void addCurve(const std::array<glm::vec3, 4>& curve, std::vector<glm::vec3>& points) {
  for (int i = 1; i <= kPerCurve; ++i) {
    const float t = static_cast<float>(i) / kPerCurve, s = 1.0f - t;
    points.push_back(s * s * s * curve[0] + 3.0f * s * s * t * curve[1] + 3.0f * s * t * t * curve[2] +
                     t * t * t * curve[3]);
  }
}

}  // namespace

std::vector<Tendon> tendonsOf(const glm::mat4& bellyInWorld, const LinePath& line, const glm::vec2& bend) {
  if (!(std::abs(glm::determinant(glm::mat3(bellyInWorld))) > 0.0f)) return {};
  const float towards = glm::dot(glm::vec3(bellyInWorld[1]), line.insertion - line.origin) < 0.0f ? -1.0f : 1.0f;
  std::vector<Tendon> tendons;
  if (auto tendon = tendonTo(bellyInWorld, bend, -towards, line.origin, line.via))
    tendons.push_back(std::move(*tendon));
  if (auto tendon = tendonTo(bellyInWorld, bend, towards, line.insertion, line.via))
    tendons.push_back(std::move(*tendon));
  return tendons;
}

std::vector<glm::vec3> pointsAlong(const LinePath& line) {
  const glm::vec3 across = directionOr(line.insertion - line.origin, glm::vec3(0.0f, 1.0f, 0.0f));
  std::vector<glm::vec3> points{line.origin};
  if (!line.via) {
    addCurve(softCurve(line.origin, across, line.insertion, across), points);
    return points;
  }
  addCurve(softCurve(line.origin, directionOr(*line.via - line.origin, across), *line.via, across), points);
  addCurve(softCurve(*line.via, across, line.insertion, directionOr(line.insertion - *line.via, across)), points);
  return points;
}

}  // namespace sinew
