// core/surface/patches/split_triangle.h: points and small triangles of one control triangle at given levels.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace sinew {

/// Levels of one control triangle. Side i goes from corner i to corner (i + 1) % 3.
struct SplitLevels {
  std::array<int, 3> sides{1, 1, 1};
  int inside = 1;

  [[nodiscard]] bool isUniform() const { return sides[0] == inside && sides[1] == inside && sides[2] == inside; }

  friend bool operator==(const SplitLevels&, const SplitLevels&) = default;
};

/// Points of each side between its ends, as shares of the way along it, ascending; empty: evenly spaced.
using SideShares = std::array<std::vector<double>, 3>;

/// Numbers of points: corners 0, 1, 2; then the points on sides 0, 1, 2, each from corner i on; then those inside.
/// Barycentric coordinates are (1-x-y, x, y).
///
/// With one level n everywhere the inner points are those of the n^2 split, and so are the triangles if all sides are
/// evenly spaced. Otherwise the inner points lie in rows along the longest side, spaced as the inner level would split
/// that side, and keep away from much coarser sides, and a Delaunay triangulation in the plane of the bind pose joins
/// all points without slivers. Reused for its memory.
class SplitTriangle {
 public:
  /// @param corners  bind pose. A triangle without area counts as equilateral.
  void split(const SplitLevels& levels, const std::array<glm::vec3, 3>& corners, const SideShares& sides = {});

  [[nodiscard]] std::span<const glm::dvec2> inside() const { return inside_; }
  /// Counter-clockwise, as the corners are.
  [[nodiscard]] std::span<const std::array<int, 3>> triangles() const { return triangles_; }

 private:
  struct Face {
    std::array<int, 3> points{};
    std::array<int, 3> across{-1, -1, -1};  ///< Face beyond the side opposite each point; -1: none.
  };

  void placeEvenly();
  void joinEvenly();
  void flatten(const std::array<glm::vec3, 3>& corners);
  void placeInside();
  void placePoints(const SideShares& sides);
  void joinBoundary();
  void insert(int point);
  void link();
  void makeDelaunay();
  void relink(int face, int from, int to);
  void flipIfBetter(int face, std::size_t side);
  [[nodiscard]] double areaOf(int a, int b, int c) const;
  [[nodiscard]] bool onOneSide(int a, int b, int c) const;
  [[nodiscard]] bool isInCircle(int a, int b, int c, int d) const;
  [[nodiscard]] glm::dvec2 inPlane(const glm::dvec2& barycentric) const;
  [[nodiscard]] int firstInside() const { return levels_.sides[0] + levels_.sides[1] + levels_.sides[2]; }

  SplitLevels levels_;
  std::array<glm::dvec2, 3> corners_{};  ///< In the plane, the longest side being 1.
  std::vector<glm::dvec2> inside_;
  std::vector<glm::dvec2> points_;  ///< In the plane.
  std::vector<int> sidesOf_;        ///< Bit i: the point lies on side i.
  std::vector<int> ring_;           ///< Boundary points not yet cut off by a face.
  std::vector<Face> faces_;
  std::vector<std::array<int, 2>> pending_;  ///< Face and side to check.
  std::vector<std::array<int, 3>> triangles_;
};

}  // namespace sinew
