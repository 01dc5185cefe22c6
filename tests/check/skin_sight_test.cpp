// tests/check/skin_sight_test.cpp: what lies open is in sight, what is covered is not.
#include "core/check/skin_sight.h"

#include <array>
#include <memory>

#include <gtest/gtest.h>

namespace sinew {
namespace {

/// Boxes that face outwards, about the origin. @param open  the first one has no top
Surface boxes(std::initializer_list<float> sizes, bool open) {
  auto refinement = std::make_shared<Refinement>();
  Surface surface;
  for (const float size : sizes) {
    const int first = static_cast<int>(surface.positions.size());
    for (int i = 0; i < 8; ++i) {
      const auto side = [&](int bit) { return (i & bit) != 0 ? size : -size; };
      surface.positions.emplace_back(side(1), side(2), side(4));
    }
    constexpr std::array<std::array<int, 4>, 6> kFaces{
        {{2, 6, 7, 3}, {0, 1, 5, 4}, {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (std::size_t f = open && first == 0 ? 1 : 0; f < kFaces.size(); ++f) {
      const auto& [a, b, c, d] = kFaces[f];
      refinement->triangles.push_back({first + a, first + b, first + c});
      refinement->triangles.push_back({first + a, first + c, first + d});
    }
  }
  surface.refinement = refinement;
  return surface;
}

TEST(SkinSight, WhatIsCoveredIsNotSeen) {
  const glm::vec3 top(0.1f, 1.0f, 0.2f);
  const glm::vec3 up(0.0f, 5.0f, 0.0f);
  const SkinSight alone(boxes({1.0f}, false));
  EXPECT_TRUE(alone.isSeen(top, up, 1e-4f));
  EXPECT_FALSE(alone.isSeen(top, -up, 1e-4f)) << "from inside";
  const SkinSight covered(boxes({1.01f, 1.0f}, false));
  EXPECT_FALSE(covered.isSeen(top, up, 1e-4f));
  const SkinSight throughTop(boxes({1.01f, 1.0f}, true));
  EXPECT_TRUE(throughTop.isSeen(top, up, 1e-4f));
  EXPECT_FALSE(throughTop.isSeen(glm::vec3(1.0f, -0.5f, 0.0f), glm::vec3(1.0f, 0.0f, 0.0f), 1e-4f))
      << "far down in the gap beside it";
}

}  // namespace
}  // namespace sinew
