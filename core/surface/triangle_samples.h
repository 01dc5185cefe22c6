// core/surface/triangle_samples.h: the surface at even points of control triangles, each in a few poses.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "core/geometry/at.h"
#include "core/surface/patches/levels.h"
#include "core/surface/preparation.h"
#include "sinew/character/pose.h"

namespace sinew {

/// Some of at most eight poses, as bits.
using PoseSet = std::uint8_t;
[[nodiscard]] inline bool contains(PoseSet set, std::size_t pose) { return (set >> pose & 1) != 0; }

/// Triangles and poses to sample.
struct SamplesAsked {
  const std::vector<std::uint8_t>& fine;  ///< [T] pieces of a side; 0: not asked.
  const std::vector<PoseSet>& poses;      ///< [T]
};

/// Calls take(triangle, pose, samples) for each triangle pose by pose, for several triangles at once. The samples, in
/// the order of forEachSample(), are those of SurfaceSampler.  @param next  as for findLevels()
void sampleTriangles(const Preparation& next, const std::vector<Pose>& poses, const SamplesAsked& asked,
                     const std::function<void(int, std::size_t, const FineSamples&)>& take);

/// Of one triangle.
struct TriangleSamples {
  int fine = 0;                      ///< Pieces of a side.
  std::vector<glm::vec3> positions;  ///< Pose after pose.
  std::vector<glm::vec3> normals;

  /// @param nth  of the triangle's poses
  [[nodiscard]] FineSamples of(std::size_t nth) const;
  [[nodiscard]] bool hold(int pieces) const { return fine > 0 && fine % pieces == 0; }
  /// Where the sample at barycentric (n-j-k, j, k) / n is among them. They hold n.
  [[nodiscard]] std::size_t placeOf(int n, int j, int k) const {
    const int row = j * (fine / n);
    return toIndex(row * (fine + 1) - row * (row - 1) / 2 + k * (fine / n));
  }
};

/// Samples that are kept for what else needs them.
class SampledSurface {
 public:
  /// @param next, poses  must outlive this.  @param posesOf [T]
  SampledSurface(const Preparation& next, const std::vector<Pose>& poses, std::vector<PoseSet> posesOf)
      : next_(next), poses_(poses), posesOf_(std::move(posesOf)), samples_(posesOf_.size()) {}

  /// Samples those triangles that do not hold so many yet.  @param fine [T] 0: not asked
  void sample(const std::vector<std::uint8_t>& fine);
  /// Adds samples of the next one of the triangle's poses.
  void keep(int triangle, int fine, const FineSamples& samples);
  void forget(std::size_t triangle) { samples_[triangle] = {}; }
  void setPoses(std::size_t triangle, PoseSet poses) { posesOf_[triangle] = poses; }

  [[nodiscard]] const std::vector<Pose>& poses() const { return poses_; }
  [[nodiscard]] const std::vector<PoseSet>& posesOf() const { return posesOf_; }  ///< [T]
  [[nodiscard]] const TriangleSamples& of(int triangle) const;

 private:
  const Preparation& next_;
  const std::vector<Pose>& poses_;
  std::vector<PoseSet> posesOf_;
  std::vector<TriangleSamples> samples_;  ///< [T]
};

}  // namespace sinew
