// core/surface/patches/sample_grids.h: one control triangle's surface in several poses, at even samples.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace sinew {

struct PlaceSample {
  glm::vec3 position;
  glm::vec3 normal;
};

/// Where three samples are mixed; the same in all poses.
struct SampleCell {
  std::array<std::size_t, 3> samples{};
  std::array<float, 3> shares{};
};

/// Keeps references to the samples.
class SampleGrids {
 public:
  /// @param positions, normals  pose after pose, in the order of forEachSample().
  /// @param sampled  pieces of a side.  @param fine  those used, a divisor of that
  SampleGrids(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals, int sampled, int fine)
      : positions_(positions),
        normals_(normals),
        sampled_(sampled),
        fine_(fine),
        stride_(sampled / fine),
        perPose_(static_cast<std::size_t>((sampled + 1) * (sampled + 2) / 2)) {}

  [[nodiscard]] std::size_t poses() const { return positions_.size() / perPose_; }

  /// @param place  barycentric (1-x-y, x, y)
  [[nodiscard]] SampleCell cellOf(const glm::dvec2& place) const {
    const auto [j, x] = cellOf(place.x);
    const auto [k, y] = cellOf(place.y);
    if (x + y <= 1.0f || j + k >= fine_ - 1) {
      if (j + k >= fine_) return {{numberOf(j, std::min(k, fine_ - j)), 0, 0}, {1.0f, 0.0f, 0.0f}};
      return {{numberOf(j, k), numberOf(j + 1, k), numberOf(j, k + 1)}, {1.0f - x - y, x, y}};
    }
    return {{numberOf(j + 1, k + 1), numberOf(j, k + 1), numberOf(j + 1, k)}, {x + y - 1.0f, 1.0f - x, 1.0f - y}};
  }

  /// Linear between samples.
  [[nodiscard]] PlaceSample at(const SampleCell& cell, std::size_t pose) const {
    return {mean(positions_, cell, pose), mean(normals_, cell, pose)};
  }
  [[nodiscard]] glm::vec3 positionAt(const SampleCell& cell, std::size_t pose) const {
    return mean(positions_, cell, pose);
  }

 private:
  [[nodiscard]] glm::vec3 mean(std::span<const glm::vec3> of, const SampleCell& cell, std::size_t pose) const {
    const glm::vec3* own = of.data() + pose * perPose_;
    const auto& [a, b, c] = cell.samples;
    return cell.shares[0] * own[a] + cell.shares[1] * own[b] + cell.shares[2] * own[c];
  }
  [[nodiscard]] std::pair<int, float> cellOf(double coordinate) const {
    const double scaled = std::clamp(coordinate, 0.0, 1.0) * fine_;
    const double nearest = static_cast<int>(scaled + 0.5);
    const double place = std::abs(scaled - nearest) < 1e-9 ? nearest : scaled;
    const int cell = static_cast<int>(place);
    return {cell, static_cast<float>(place - cell)};
  }
  [[nodiscard]] std::size_t numberOf(int row, int column) const {
    const int j = row * stride_;
    return static_cast<std::size_t>(j * (sampled_ + 1) - j * (j - 1) / 2 + column * stride_);
  }

  std::span<const glm::vec3> positions_;
  std::span<const glm::vec3> normals_;
  int sampled_;
  int fine_;
  int stride_;  ///< Samples to the next one used.
  std::size_t perPose_;
};

}  // namespace sinew
