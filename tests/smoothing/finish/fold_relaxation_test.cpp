// tests/smoothing/finish/fold_relaxation_test.cpp: folds are smoothed out along the lifted skin, continuously, nowhere
// else.

#include "core/smoothing/finish/fold_relaxation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/surface/fold_stage.h"
#include "tests/support/surface/mesh_checks.h"

namespace sinew::test {
namespace {

using RelaxationStage = FoldStage<FoldRelaxation>;

constexpr float kCell = 0.1f;  ///< Side of a cell of flatSheet().

// Skin that went back to the patch where it folds would leave a pit in the middle of the bump.
TEST(FoldRelaxation, KeepsTheSkinUp) {
  RelaxationStage scene(flatSheet());
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.3f);
  const std::vector<glm::vec3> relaxed = scene.applied(lifted);
  ASSERT_GT(largestStep(lifted, relaxed), 0.04f) << "nothing was relaxed";
  for (std::size_t v = 0; v < lifted.size(); ++v) {
    EXPECT_GT(relaxed[v].z, 0.6f * lifted[v].z - 0.01f) << v;
    EXPECT_LT(relaxed[v].z, 0.31f) << v;
  }
}

// A border that moved would open a crack to the skin that is drawn beside it.
TEST(FoldRelaxation, KeepsBorders) {
  Sheet half = flatSheet();
  std::erase_if(half.triangles, [&](const auto& t) {
    return std::ranges::any_of(t, [&](int v) { return half.positions[static_cast<std::size_t>(v)].y < -0.05f; });
  });
  RelaxationStage scene(half);
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.3f);
  const std::vector<glm::vec3> relaxed = scene.applied(lifted);
  ASSERT_GT(largestStep(lifted, relaxed), 0.01f);
  int border = 0;
  for (std::size_t v = 0; v < lifted.size(); ++v) {
    if (scene.patch[v].y > 0.05f || lifted[v] == scene.patch[v]) continue;
    ++border;
    EXPECT_TRUE(sameBits(relaxed[v], lifted[v])) << v;
  }
  EXPECT_GT(border, 5);
}

// A vertex that has only just begun to move is not thrown about by the fold beside it.
TEST(FoldRelaxation, IsContinuousWhereAVertexBeginsToMove) {
  RelaxationStage scene(flatSheet());
  std::vector<glm::vec3> lifted = converging(scene.patch, 0.3f);
  std::size_t nearest = 0;
  for (std::size_t v = 0; v < lifted.size(); ++v) {
    if (glm::length(scene.patch[v]) < glm::length(scene.patch[nearest])) nearest = v;
  }
  lifted[nearest] = scene.patch[nearest];
  const std::vector<glm::vec3> unmoved = scene.applied(lifted);
  lifted[nearest].z += 1e-5f;
  EXPECT_LT(largestStep(scene.applied(lifted), unmoved), 2e-3f);
}

/// Squeezes one column of cells to `share` of its width in the patch.
void squeeze(std::vector<glm::vec3>& patch, float share) {
  for (glm::vec3& p : patch) {
    if (std::abs(p.x - kCell) < 0.1f * kCell) p.x = share * kCell;
  }
}

/// Lifts the sheet, and the squeezed column's far side towards its near one, until q is that of `narrowed`.
std::vector<glm::vec3> narrowedTo(float q, const std::vector<glm::vec3>& patch, float share) {
  std::vector<glm::vec3> lifted = patch;
  for (glm::vec3& p : lifted) {
    if (p.x == share * kCell) p.x *= q;
    p.z += 0.3f;
  }
  return lifted;
}

// Slivers lie in the creases of a pose. Their q changes as much faster than the skin moves as they are narrower than
// the cells beside them, to whose mean the relaxation leads. Without a bound it moves them by 3, 8 and 16 times what is
// missing, and 3, 9 and 19 times as fast.
TEST(FoldRelaxation, IsNoFasterAroundSlivers) {
  for (const float share : {0.5f, 0.2f, 0.1f}) {
    RelaxationStage scene(flatSheet());
    squeeze(scene.patch, share);
    constexpr int kSteps = 400;
    const float width = share * kCell;
    std::vector<glm::vec3> before;
    float furthest = 0.0f;
    float fastest = 0.0f;
    for (int i = 1; i <= kSteps; ++i) {
      const float q = 0.4f * (1.0f - static_cast<float>(i) / kSteps);
      const std::vector<glm::vec3> lifted = narrowedTo(q, scene.patch, share);
      const std::vector<glm::vec3> relaxed = scene.applied(lifted);
      furthest = std::max(furthest, largestStep(relaxed, lifted) / ((0.4f - q) * width));
      if (i > 1) fastest = std::max(fastest, largestStep(relaxed, before) * kSteps / (0.4f * width));
      before = relaxed;
    }
    std::printf("  cells squeezed to %.1f: moved by %.1f of what is missing, %.1f times as fast as the skin\n",
                double{share}, double{furthest}, double{fastest});
    EXPECT_GT(furthest, 0.1f) << share;
    EXPECT_LT(furthest, 2.5f) << share;
    EXPECT_LT(fastest, 6.0f) << share;
  }
}

}  // namespace
}  // namespace sinew::test
