// core/surface/patches/levels.h: levels that follow a finely sampled surface, and levels raised to match neighbors.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <glm/vec3.hpp>

#include "core/geometry/edge_sides.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// The levels that LevelGrader picks from; most of them divide each other.
inline constexpr std::array kGradedLevels{1, 2, 3, 4, 6, 12, 16};

/// Raises levels to the lowest of kGradedLevels at which neither a side nor the inside of a triangle has pieces more
/// than three times as long as another's, unless its level is as high. Jumps in size make slivers; equal levels keep
/// the triangle's own shape. Lengths are those of the bind pose.
class LevelGrader {
 public:
  /// @param mesh  must outlive this.
  explicit LevelGrader(const ControlMesh& mesh) : mesh_(mesh), sides_(mesh) {}

  /// Never lowers a level. The result does not depend on the order of triangles.
  [[nodiscard]] RefinementLevels graded(RefinementLevels levels) const;

 private:
  const ControlMesh& mesh_;
  EdgeSides sides_;
};

struct FineSamples {
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> normals;  ///< Unit, for shading.
};

struct LevelTolerance {
  float distance = 0.0f;       ///< Between samples and the flat pieces, world units.
  float normalCosine = 0.99f;  ///< Between sampled and interpolated normals where the surface is smooth.
  float seenPiece = 0.0f;      ///< Length; on shorter pieces normals may be off by more, as many times as these fit in.
};

/// Distance of a sample from a flat piece: from the point of its barycentric coordinates or the plane, the lesser one.
[[nodiscard]] float distanceFromPiece(const glm::vec3& sample, const std::array<glm::vec3, 3>& corners,
                                      const std::array<float, 3>& shares);

/// The least divisor n >= `from` of R at which n chords stay within the tolerance.
/// @param samples [R + 1] evenly spaced along an edge.
[[nodiscard]] int edgeLevel(const FineSamples& samples, int from, const LevelTolerance& tolerance);

/// How many times the tolerance samples of an edge are off its one chord, in distance or in the angle of normals.
[[nodiscard]] float edgeMisfit(const FineSamples& samples, const LevelTolerance& tolerance);

/// The same for the n^2 split of a triangle.  @param fine  R, at most kMaxDepth.  @param samples [(R+1)(R+2)/2] at
/// barycentric (R-j-k, j, k) / R, row j = 0 first, k ascending.
[[nodiscard]] int triangleLevel(const FineSamples& samples, int fine, int from, const LevelTolerance& tolerance);

/// edgeMisfit() for a triangle that is one flat piece.
[[nodiscard]] float triangleMisfit(const FineSamples& samples, int fine, const LevelTolerance& tolerance);

/// Samples of one side of a triangle, from corner `side` on.
class SideSamples {
 public:
  SideSamples(const FineSamples& ofTriangle, int fine, std::size_t side);
  [[nodiscard]] FineSamples samples() const {
    return {std::span(positions_).first(count_), std::span(normals_).first(count_)};
  }

 private:
  std::size_t count_;
  std::array<glm::vec3, kMaxDepth + 1> positions_;
  std::array<glm::vec3, kMaxDepth + 1> normals_;
};

}  // namespace sinew
