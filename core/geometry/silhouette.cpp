// core/geometry/silhouette.cpp: contours, on a grid over the body, where its normals are perpendicular to the view.
#include "core/geometry/silhouette.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace sinew {
namespace {

constexpr int kSilhouetteRows = 28;  ///< From pole to pole.
constexpr int kColumns = 36;
constexpr int kPlaces = kSilhouetteRows * kColumns;

/// A point of the contour on an edge of the grid, which goes down a column (0) or along a row (1) from a node.
struct Crossing {
  std::array<int, 2> next{-1, -1};  ///< Edges of the adjacent crossings.
  glm::vec3 inShape{0.0f};
};

class Contour {
 public:
  Contour(const Shape& shape, const UnitShape& unit, const glm::vec3& eye, bool parallel)
      : shape_(shape), unit_(unit), eye_(eye), parallel_(parallel), crossings_(2 * (kPlaces + kColumns)) {
    for (int row = 0; row <= kSilhouetteRows; ++row) {
      for (int column = 0; column < kColumns; ++column) facing_.push_back(facing(onGrid(row, column)));
    }
    for (int row = 0; row < kSilhouetteRows; ++row) {
      for (int column = 0; column < kColumns; ++column) joinCell(row, column);
    }
  }

  /// The longest closed line.
  [[nodiscard]] std::vector<glm::vec3> line() {
    std::vector<glm::vec3> longest;
    std::vector<bool> seen(crossings_.size(), false);
    for (std::size_t first = 0; first < crossings_.size(); ++first) {
      if (crossings_[first].next[0] < 0 || seen[first]) continue;
      std::vector<glm::vec3> points;
      int from = -1;
      int edge = static_cast<int>(first);
      while (edge >= 0 && !seen[static_cast<std::size_t>(edge)]) {
        seen[static_cast<std::size_t>(edge)] = true;
        const Crossing& here = crossings_[static_cast<std::size_t>(edge)];
        points.push_back(here.inShape);
        const int onward = here.next[0] == from ? here.next[1] : here.next[0];
        from = edge;
        edge = onward;
      }
      if (points.size() > longest.size()) longest = std::move(points);
    }
    return longest;
  }

 private:
  [[nodiscard]] glm::vec3 onGrid(float row, float column) const {
    const float polar = std::numbers::pi_v<float> * row / kSilhouetteRows;
    const float turn = 2.0f * std::numbers::pi_v<float> * column / kColumns;
    return onShape(shape_, 1.0f, {std::sin(polar) * std::sin(turn), std::cos(polar), std::sin(polar) * std::cos(turn)});
  }
  [[nodiscard]] glm::vec3 onGrid(int row, int column) const {
    return onGrid(static_cast<float>(row), static_cast<float>(column));
  }

  /// > 0 where the surface faces the eye.
  [[nodiscard]] float facing(const glm::vec3& p) const {
    return glm::dot(unit_.rSquaredSlope(p), parallel_ ? -eye_ : eye_ - p);
  }
  [[nodiscard]] float facingAt(int row, int column) const {
    return facing_[static_cast<std::size_t>(row * kColumns + column % kColumns)];
  }

  static int down(int row, int column) { return 2 * (row * kColumns + column % kColumns); }
  static int along(int row, int column) { return down(row, column) + 1; }

  void cross(int edge, int row, int column, bool isDown, std::array<int, 4>& crossed, int& count) {
    const float a = facingAt(row, column);
    const float b = isDown ? facingAt(row + 1, column) : facingAt(row, column + 1);
    if ((a > 0.0f) == (b > 0.0f)) return;
    const float share = a / (a - b);
    crossings_[static_cast<std::size_t>(edge)].inShape =
        onGrid(static_cast<float>(row) + (isDown ? share : 0.0f), static_cast<float>(column) + (isDown ? 0.0f : share));
    crossed[static_cast<std::size_t>(count++)] = edge;
  }

  void joinCell(int row, int column) {
    std::array<int, 4> crossed{};
    int count = 0;
    cross(along(row, column), row, column, false, crossed, count);
    cross(down(row, column + 1), row, (column + 1) % kColumns, true, crossed, count);
    cross(along(row + 1, column), row + 1, column, false, crossed, count);
    cross(down(row, column), row, column, true, crossed, count);
    for (int i = 0; i + 1 < count; i += 2)
      join(crossed[static_cast<std::size_t>(i)], crossed[static_cast<std::size_t>(i + 1)]);
  }

  void join(int a, int b) {
    const auto add = [&](int edge, int other) {
      auto& next = crossings_[static_cast<std::size_t>(edge)].next;
      (next[0] < 0 ? next[0] : next[1]) = other;
    };
    add(a, b);
    add(b, a);
  }

  const Shape& shape_;
  const UnitShape& unit_;
  glm::vec3 eye_;  ///< In the primitive's unit space; parallel: direction of view.
  bool parallel_;
  std::vector<float> facing_;
  std::vector<Crossing> crossings_;
};

}  // namespace

Silhouette silhouetteOf(const Shape& shape, const glm::mat4& unitBallInWorld, const glm::vec3& eye, bool parallel) {
  Silhouette points;
  const glm::vec3 center(unitBallInWorld[3]);
  points.fill(center);
  const glm::mat3 linear(unitBallInWorld);
  if (glm::determinant(linear) == 0.0f) return points;
  const glm::mat3 toShape = glm::inverse(linear);
  const UnitShape unit = unitShape(shape, 1.0f);
  const glm::vec3 inShape = toShape * (parallel ? eye : eye - center);
  if (!parallel && unit.rSquared(inShape) <= 1.0f) return points;
  const std::vector<glm::vec3> line = Contour(shape, unit, inShape, parallel).line();
  if (line.size() < 3) return points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float at = static_cast<float>(i) * static_cast<float>(line.size()) / static_cast<float>(points.size());
    const auto from = std::min(static_cast<std::size_t>(at), line.size() - 1);
    const glm::vec3 p = glm::mix(line[from], line[(from + 1) % line.size()], at - static_cast<float>(from));
    points[i] = center + linear * p;
  }
  return points;
}

}  // namespace sinew
