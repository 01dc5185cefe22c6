// tests/bodies/skin_sight_test.cpp: exposed places are visible, covered ones are not.
#include "core/bodies/cloth_check.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace sinew {
namespace {

/// Boxes that face outwards, around the origin. @param open  the first one has no top
TriangleTree boxes(std::initializer_list<float> sizes, bool open) {
  std::vector<TriangleCorners> triangles;
  std::vector<int> numbers;
  const auto add = [&](const TriangleCorners& corners) {
    numbers.push_back(static_cast<int>(triangles.size()));
    triangles.push_back(corners);
  };
  for (const float size : sizes) {
    const auto corner = [&](int i) {
      const auto side = [&](int bit) { return (i & bit) != 0 ? size : -size; };
      return glm::vec3(side(1), side(2), side(4));
    };
    constexpr std::array<std::array<int, 4>, 6> kFaces{
        {{2, 6, 7, 3}, {0, 1, 5, 4}, {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (std::size_t f = open && triangles.empty() ? 1 : 0; f < kFaces.size(); ++f) {
      const auto& [a, b, c, d] = kFaces[f];
      add({corner(a), corner(b), corner(c)});
      add({corner(a), corner(c), corner(d)});
    }
  }
  return {triangles, numbers};
}

TEST(SkinVisibility, CoveredPointsAreNotVisible) {
  const glm::vec3 top(0.1f, 1.0f, 0.2f);
  const glm::vec3 up(0.0f, 5.0f, 0.0f);
  const TriangleTree alone = boxes({1.0f}, false);
  EXPECT_TRUE(isSeen(alone, top, up, 1e-4f));
  EXPECT_FALSE(isSeen(alone, top, -up, 1e-4f)) << "from inside";
  const TriangleTree covered = boxes({1.01f, 1.0f}, false);
  EXPECT_FALSE(isSeen(covered, top, up, 1e-4f));
  const TriangleTree throughTop = boxes({1.01f, 1.0f}, true);
  EXPECT_TRUE(isSeen(throughTop, top, up, 1e-4f));
  EXPECT_FALSE(isSeen(throughTop, glm::vec3(1.0f, -0.5f, 0.0f), glm::vec3(1.0f, 0.0f, 0.0f), 1e-4f))
      << "far down in the gap beside it";
}

}  // namespace
}  // namespace sinew
