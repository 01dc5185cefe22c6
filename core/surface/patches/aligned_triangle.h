// core/surface/patches/aligned_triangle.h: the split of one control triangle, moved closer to its surface.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/geometry/at.h"
#include "core/surface/patches/sample_grids.h"
#include "core/surface/patches/split_triangle.h"
#include "core/surface/patches/triangulation.h"

namespace sinew {

inline constexpr double kAnyAngle = 4.0;  ///< More than any.

/// How well the small triangles at a point fit the surface.
struct PointFit {
  double turned = 0.0;  ///< Squared distance of interpolated normals from the surface's in the triangles' middles,
                        ///< times area, over poses.
  double area = 0.0;    ///< Of these triangles, times the number of poses.
  double leastAngle = kAnyAngle;  ///< Bind pose; those of more than 15 degrees may be left out.
  float off = 0.0f;  ///< Largest distance from the surface in a pose, of middles also of sides, world units.

  void add(const PointFit& other);
};

/// No fit beyond these is better than another.
struct FitBound {
  double leastAngle = -kAnyAngle;
  double turned = std::numeric_limits<double>::max();

  [[nodiscard]] bool excludes(const PointFit& fit) const { return fit.leastAngle < leastAngle || fit.turned > turned; }
};

[[nodiscard]] FitBound boundOf(const PointFit& former);

/// Whether `moved` is closer, makes no slivers and stays within the tolerance, or is no worse there than `former`.
/// @param tolerance  of `off`
[[nodiscard]] bool isBetterFit(const PointFit& moved, const PointFit& former, float tolerance);

class AlignedTriangle {
 public:
  /// @param corners  bind pose.  @param tolerance  of positions, world units
  AlignedTriangle(const SplitLevels& levels, const SideShares& sides, const std::array<glm::vec3, 3>& corners,
                  const SampleGrids& grids, float tolerance);

  [[nodiscard]] int pointOn(std::size_t side, int step) const;  ///< @param step  1..level-1 from corner `side`.
  [[nodiscard]] glm::dvec2 placeOn(std::size_t side, double share) const;
  /// Of the small triangles at a point, if it were at `place`; of some of them if these are beyond the bound.
  [[nodiscard]] PointFit fitAt(int point, const glm::dvec2& place, const FitBound& bound = {});
  void move(int point, const glm::dvec2& place);

  /// Moves inner points and swaps diagonals.
  void align();
  [[nodiscard]] Triangulation triangulation() const;  ///< Without triangles if that has changed nothing.

 private:
  /// Moves inner points by up to `step` of the small triangles' size to where these fit better.
  void moveInside(double step);
  /// Of two small triangles the common side becomes the other diagonal of their four points if the normal interpolated
  /// along that comes closer, where the two cross (data-dependent triangulation: Dyn, Levin, Rippa 1990).
  void swapDiagonals();
  void flatten(const std::array<glm::vec3, 3>& corners);
  void placePoints(const SideShares& sides);
  void read(const glm::dvec2& place, PlaceSample* out) const;
  [[nodiscard]] PlaceSample& sampleAt(int point, std::size_t pose) { return samples_[toIndex(point) * poses() + pose]; }
  [[nodiscard]] std::size_t poses() const { return grids_.poses(); }
  [[nodiscard]] int firstInside() const { return levels_.sides[0] + levels_.sides[1] + levels_.sides[2]; }
  [[nodiscard]] glm::dvec2 inPlane(const glm::dvec2& place) const { return place.x * plane_[0] + place.y * plane_[1]; }
  [[nodiscard]] double leastAngle(const std::array<int, 3>& t) const;
  void addFit(const std::array<int, 3>& t, PointFit& fit);
  void moveIfBetter(int point, double step);
  [[nodiscard]] std::optional<std::size_t> beyond(std::size_t from, int a, int b) const;
  bool swapIfBetter(std::size_t one, std::size_t side);
  [[nodiscard]] bool isCloser(int a, int b, int c, int d);

  SplitLevels levels_;
  SampleGrids grids_;
  float tolerance_;
  std::array<glm::dvec2, 2> plane_{};  ///< Sides from corner 0.
  std::vector<glm::dvec2> places_;     ///< Barycentric, of all points.
  std::vector<std::array<int, 3>> triangles_;
  std::vector<PlaceSample> samples_;  ///< [points][poses]
  std::vector<PlaceSample> former_;   ///< [poses] of a point on trial.
  bool isChanged_ = false;
};

}  // namespace sinew
