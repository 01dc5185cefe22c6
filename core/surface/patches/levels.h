// core/surface/patches/levels.h: the least level at which flat pieces follow a finely sampled edge or triangle.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew {

// Levels raised until neighbors are alike.

/// Levels that are raised to: most divide each other.
inline constexpr std::array kGradedLevels{1, 2, 3, 4, 6, 12, 16};

/// Raises levels to the least ones of kGradedLevels at which no side of a triangle, and not its inside, is
/// split into pieces more than three times as long as another's, unless it has as high a level: jumps in size make
/// slivers, and equal levels keep the triangle's own shape. Lengths are the bind pose's.
class LevelGrader {
 public:
  /// @param mesh  must outlive this.
  explicit LevelGrader(const ControlMesh& mesh);

  /// Nothing is lowered; the result is the same in whatever order triangles are looked at.
  [[nodiscard]] RefinementLevels graded(RefinementLevels levels) const;

 private:
  const ControlMesh& mesh_;
  std::vector<float> lengths_;       ///< [E]
  std::vector<int> trianglesBegin_;  ///< [E + 1] into trianglesAt_.
  std::vector<int> trianglesAt_;     ///< Edge by edge.
};

/// Samples of a fine surface.
struct FineSamples {
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> normals;  ///< Unit, for shading.
};

struct LevelTolerance {
  float distance = 0.0f;       ///< Of samples from the flat pieces, world units.
  float normalCosine = 0.99f;  ///< Of samples' normals and the interpolated ones, where the surface is smooth.
};

/// How far a sample is off a flat piece: from the piece's point at the sample's own barycentric shares, or from its
/// plane, whichever is less.
[[nodiscard]] float distanceFromPiece(const glm::vec3& sample, const std::array<glm::vec3, 3>& corners,
                                      const std::array<float, 3>& shares);

/// The least divisor n >= `from` of R at which the n chords stay within the tolerance.  @param samples [R + 1] evenly
/// along an edge.
[[nodiscard]] int edgeLevel(const FineSamples& samples, int from, const LevelTolerance& tolerance);

/// The same for the n^2 split of a triangle.  @param fine  R, at most kMaxDepth.  @param samples [(R+1)(R+2)/2] at
/// barycentric (R-j-k, j, k) / R, row j = 0 first, k ascending.
[[nodiscard]] int triangleLevel(const FineSamples& samples, int fine, int from, const LevelTolerance& tolerance);

}  // namespace sinew
