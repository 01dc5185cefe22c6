// tests/smoothing/fold_relaxation_test.cpp: folds are smoothed out along the lifted skin, continuously, nowhere else.

#include "core/smoothing/finish/fold_relaxation.h"

#include <algorithm>
#include <cstdio>
#include <set>

#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/surface/lifted_sheet.h"
#include "tests/support/surface/mesh_checks.h"

namespace sinew::test {
namespace {

/// Through the relaxation.
struct Scene : LiftedSheet {
  using LiftedSheet::LiftedSheet;

  [[nodiscard]] std::vector<glm::vec3> relaxed(std::vector<glm::vec3> positions) {
    moved.find(mesh, refinement, patch, positions);
    moves_.start(positions.size());
    region_.find(mesh, refinement, moved.control, view(), positions, FoldRelaxation::kWholeArea);
    relaxation_.apply(refinement, borderVertices(mesh, refinement), patch, region_, moves_, positions);
    touched.assign(moves_.list().begin(), moves_.list().end());
    return positions;
  }

  std::vector<FoldMove> touched;  ///< By the last call.

 private:
  FoldRegion region_;
  FoldMoves moves_;
  FoldRelaxation relaxation_;
};

TEST(FoldRelaxation, TurnsTrianglesBack) {
  Scene scene(flatSheet());
  for (const float lift : {0.25f, 0.3f, 0.4f}) {
    const std::vector<glm::vec3> lifted = converging(scene.patch, lift);
    const std::vector<glm::vec3> relaxed = scene.relaxed(lifted);
    std::printf("  lift %.2f: %d turned, relaxed %d\n", double{lift}, scene.turned(lifted), scene.turned(relaxed));
    ASSERT_GT(scene.turned(lifted), 10) << lift;
    EXPECT_LE(10 * scene.turned(relaxed), scene.turned(lifted)) << lift;
  }
}

// Skin that went back to the patch where it folds would leave a pit in the middle of the bump.
TEST(FoldRelaxation, KeepsTheSkinUp) {
  Scene scene(flatSheet());
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.3f);
  const std::vector<glm::vec3> relaxed = scene.relaxed(lifted);
  ASSERT_GT(largestStep(lifted, relaxed), 0.05f) << "nothing was relaxed";
  for (std::size_t v = 0; v < lifted.size(); ++v) {
    EXPECT_GT(relaxed[v].z, 0.6f * lifted[v].z - 0.01f) << v;
    EXPECT_LT(relaxed[v].z, 0.31f) << v;
  }
}

TEST(FoldRelaxation, LeavesTheRestAloneBitForBit) {
  Scene scene(flatSheet());
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.3f);
  const std::vector<glm::vec3> relaxed = scene.relaxed(lifted);
  std::set<int> touched;
  for (const FoldMove& one : scene.touched) {
    EXPECT_TRUE(touched.insert(one.vertex).second) << one.vertex << " twice";
    EXPECT_TRUE(sameBits(one.from, lifted[static_cast<std::size_t>(one.vertex)]));
    EXPECT_FALSE(sameBits(one.from, scene.patch[static_cast<std::size_t>(one.vertex)])) << "an unmoved vertex";
  }
  int alone = 0;
  for (int v = 0; v < static_cast<int>(lifted.size()); ++v) {
    if (touched.contains(v)) continue;
    ++alone;
    EXPECT_TRUE(sameBits(relaxed[static_cast<std::size_t>(v)], lifted[static_cast<std::size_t>(v)])) << v;
  }
  EXPECT_GT(touched.size(), 10u);
  EXPECT_GT(alone, 200);
}

TEST(FoldRelaxation, TouchesNothingWithoutAFold) {
  Scene scene(flatSheet());
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.05f);
  ASSERT_GE(scene.leastArea(lifted), 0.4f);
  EXPECT_TRUE(sameBytes(scene.relaxed(lifted), lifted));
  EXPECT_TRUE(scene.touched.empty());
}

// A border that moved would open a crack to the skin that is drawn beside it.
TEST(FoldRelaxation, KeepsBorders) {
  Sheet half = flatSheet();
  std::erase_if(half.triangles, [&](const auto& t) {
    return std::ranges::any_of(t, [&](int v) { return half.positions[static_cast<std::size_t>(v)].y < -0.05f; });
  });
  Scene scene(half);
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.3f);
  const std::vector<glm::vec3> relaxed = scene.relaxed(lifted);
  ASSERT_GT(largestStep(lifted, relaxed), 0.01f);
  int border = 0;
  for (std::size_t v = 0; v < lifted.size(); ++v) {
    if (scene.patch[v].y > 0.05f || lifted[v] == scene.patch[v]) continue;
    ++border;
    EXPECT_TRUE(sameBits(relaxed[v], lifted[v])) << v;
  }
  EXPECT_GT(border, 5);
}

TEST(FoldRelaxation, DoesNotDependOnTheOrderOfTriangles) {
  Scene scene(flatSheet());
  const std::vector<glm::vec3> lifted = converging(scene.patch, 0.25f);
  const std::vector<glm::vec3> relaxed = scene.relaxed(lifted);
  ASSERT_GT(largestStep(relaxed, lifted), 0.01f);
  std::ranges::reverse(scene.mesh.triangles);
  std::ranges::reverse(scene.refinement.triangles);
  std::ranges::reverse(scene.bindFronts);
  EXPECT_LT(largestStep(scene.relaxed(lifted), relaxed), 1e-4f);
}

TEST(FoldRelaxation, IsContinuousInTheLift) {
  Scene scene(flatSheet());
  const auto finish = [&](std::vector<glm::vec3> lifted) { return scene.relaxed(std::move(lifted)); };
  const float slope = steepestStep(scene.patch, 0.4f, 200, finish);
  const float finer = steepestStep(scene.patch, 0.4f, 1600, finish);
  EXPECT_LT(finer, 2.0f * slope) << "a jump stays as steps shrink";
}

// A vertex that has only just begun to move is not thrown about by the fold beside it.
TEST(FoldRelaxation, IsContinuousWhereAVertexBeginsToMove) {
  Scene scene(flatSheet());
  std::vector<glm::vec3> lifted = converging(scene.patch, 0.3f);
  std::size_t nearest = 0;
  for (std::size_t v = 0; v < lifted.size(); ++v) {
    if (glm::length(scene.patch[v]) < glm::length(scene.patch[nearest])) nearest = v;
  }
  lifted[nearest] = scene.patch[nearest];
  const std::vector<glm::vec3> unmoved = scene.relaxed(lifted);
  lifted[nearest].z += 1e-5f;
  EXPECT_LT(largestStep(scene.relaxed(lifted), unmoved), 2e-3f);
}

}  // namespace
}  // namespace sinew::test
