// core/surface/patches/sample_grids.h: one control triangle's surface in several poses, at even samples.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

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

class SampleGrids {
 public:
  SampleGrids() = default;
  /// @param fine  samples along a side
  SampleGrids(int fine, std::size_t poses)
      : fine_(fine), perPose_(static_cast<std::size_t>((fine + 1) * (fine + 2) / 2)), samples_(poses * perPose_) {}

  [[nodiscard]] int fine() const { return fine_; }
  [[nodiscard]] std::size_t poses() const { return perPose_ == 0 ? 0 : samples_.size() / perPose_; }
  /// In the order of forEachSample().
  [[nodiscard]] std::span<PlaceSample> inPose(std::size_t pose) {
    return std::span(samples_).subspan(pose * perPose_, perPose_);
  }

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
    const PlaceSample* own = samples_.data() + pose * perPose_;
    const PlaceSample& a = own[cell.samples[0]];
    const PlaceSample& b = own[cell.samples[1]];
    const PlaceSample& c = own[cell.samples[2]];
    const auto& [u, v, w] = cell.shares;
    return {u * a.position + v * b.position + w * c.position, u * a.normal + v * b.normal + w * c.normal};
  }

 private:
  [[nodiscard]] std::pair<int, float> cellOf(double coordinate) const {
    const double scaled = std::clamp(coordinate, 0.0, 1.0) * fine_;
    const double nearest = std::round(scaled);
    const double place = std::abs(scaled - nearest) < 1e-9 ? nearest : scaled;
    const int cell = static_cast<int>(place);
    return {cell, static_cast<float>(place - cell)};
  }
  [[nodiscard]] std::size_t numberOf(int row, int column) const {
    return static_cast<std::size_t>(row * (fine_ + 1) - row * (row - 1) / 2 + column);
  }

  int fine_ = 0;
  std::size_t perPose_ = 0;
  std::vector<PlaceSample> samples_;  ///< [poses][perPose]
};

}  // namespace sinew
