// core/surface/patches/level_fit.h: the least level at which flat pieces follow a finely sampled edge or triangle.
#pragma once

#include <array>
#include <span>

#include <glm/vec3.hpp>

namespace sinew {

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
