// tests/smoothing/finish/fold_relaxation_test.cpp: folds are smoothed out along the lifted skin, continuously, nowhere
// else.

#include "core/smoothing/finish/fold_relaxation.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/surface/fold_stage.h"
#include "tests/support/surface/mesh_checks.h"

namespace sinew::test {
namespace {

using RelaxationStage = FoldStage<FoldRelaxation>;

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

}  // namespace
}  // namespace sinew::test
