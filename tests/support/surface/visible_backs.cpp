// tests/support/surface/visible_backs.cpp: a depth buffer in memory, one picture after the other.
#include "tests/support/surface/visible_backs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

namespace sinew::test {
namespace {

class Picture {
 public:
  explicit Picture(int pixels) : pixels_(pixels), depth_(count()), isBack_(count()) {}

  void clear() {
    std::ranges::fill(depth_, std::numeric_limits<float>::infinity());
    std::ranges::fill(isBack_, std::uint8_t{0});
  }

  /// Corners in pixels, y up; z is the distance.
  void draw(const std::array<glm::vec3, 3>& t) {
    const float area = cross(t[0], t[1], t[2]);
    if (!(std::abs(area) > 0.0f)) return;
    const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [low, high] = std::minmax({t[0].y, t[1].y, t[2].y});
    for (int y = first(low); y <= last(high); ++y) {
      for (int x = first(left); x <= last(right); ++x) {
        const glm::vec3 at(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f, 0.0f);
        const float a = cross(t[1], t[2], at) / area;
        const float b = cross(t[2], t[0], at) / area;
        const float c = 1.0f - a - b;
        if (a < 0.0f || b < 0.0f || c < 0.0f) continue;
        const float distance = a * t[0].z + b * t[1].z + c * t[2].z;
        const auto pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(pixels_) + static_cast<std::size_t>(x);
        if (!(distance < depth_[pixel])) continue;
        depth_[pixel] = distance;
        isBack_[pixel] = area < 0.0f ? 1 : 0;
      }
    }
  }

  [[nodiscard]] long long backs() const { return std::ranges::count(isBack_, std::uint8_t{1}); }

 private:
  static float cross(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  }
  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(pixels_) * static_cast<std::size_t>(pixels_);
  }
  [[nodiscard]] int first(float from) const {
    return static_cast<int>(std::clamp(std::floor(from), 0.0f, static_cast<float>(pixels_)));
  }
  [[nodiscard]] int last(float to) const {
    return static_cast<int>(std::clamp(std::ceil(to), -1.0f, static_cast<float>(pixels_ - 1)));
  }

  int pixels_;
  std::vector<float> depth_;
  std::vector<std::uint8_t> isBack_;
};

/// Towards the faces and corners of a cube, turned a little so that nothing is seen edge-on.
std::vector<glm::mat3> eyes() {
  std::vector<glm::mat3> out;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        const int sides = std::abs(x) + std::abs(y) + std::abs(z);
        if (sides != 1 && sides != 3) continue;
        const glm::vec3 towards = glm::normalize(glm::vec3(x, y, z) + glm::vec3(0.11f, 0.07f, 0.05f));
        const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0.1f, 1.0f, 0.2f), towards));
        out.emplace_back(right, glm::cross(towards, right), -towards);
      }
    }
  }
  return out;
}

}  // namespace

long long visibleBacks(const Refinement& refinement, const std::vector<glm::vec3>& positions, const glm::vec3& center,
                       float extent, int pixels) {
  Picture picture(pixels);
  std::vector<glm::vec3> seen(positions.size());
  const float scale = static_cast<float>(pixels) / extent;
  const float middle = 0.5f * static_cast<float>(pixels);
  long long backs = 0;
  for (const glm::mat3& eye : eyes()) {
    for (std::size_t v = 0; v < positions.size(); ++v) {
      seen[v] = scale * ((positions[v] - center) * eye) + glm::vec3(middle, middle, 0.0f);
    }
    picture.clear();
    for (const std::array<int, 3>& t : refinement.triangles) {
      picture.draw({seen[static_cast<std::size_t>(t[0])], seen[static_cast<std::size_t>(t[1])],
                    seen[static_cast<std::size_t>(t[2])]});
    }
    backs += picture.backs();
  }
  return backs;
}

}  // namespace sinew::test
