// tests/bodies/height_model_test.cpp: changes of heights against differences of heights.
#include "core/bodies/height_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/bodies/fit_muscles.h"
#include "core/geometry/at.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew {
namespace {

using test::Random;

/// A rig with every kind of blending whose muscles are not in motion.
Rig someRig(const Character& character, std::uint64_t seed) {
  const test::RigRecipe recipe{.primitives = 5,
                               .carveChance = 0.2f,
                               .shapedChance = 0.4f,
                               .reachHigh = 1.8f,
                               .groovesChance = seed % 2 == 0 ? 1.0f : 0.0f};
  return test::randomRig(character, recipe, seed);
}

TEST(HeightModel, ChangesAreThoseOfDifferences) {
  const auto character = test::makeTwoLegged();
  std::size_t compared = 0;
  std::size_t apart = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Rig rig = someRig(*character, seed);
    auto model = HeightModel::create(character, rig);
    ASSERT_TRUE(model.ok()) << model.error().text();
    const FitMuscles muscles(rig, *character, nullptr);
    const auto changes = model->changes();
    std::vector<ResidualRow> rows;
    for (const auto& own : changes) rows.push_back(muscles.rowOf(own));
    for (std::size_t number = 0; number < muscles.size() * kFitNumbers; number += 3) {
      const double size = number % kFitNumbers < 3 ? 1e-4 * static_cast<double>(character->height) : 1e-3;
      std::array<std::vector<float>, 2> heights;
      for (int side = 0; side < 2; ++side) {
        std::vector<double> step(muscles.size() * kFitNumbers, 0.0);
        step[number] = side == 0 ? -size : size;
        ASSERT_TRUE(model.value().raise(muscles.moved(rig, step)).ok());
        heights[static_cast<std::size_t>(side)].assign(model->heights().begin(), model->heights().end());
      }
      float most = 0.0f;
      for (std::size_t v = 0; v < rows.size(); ++v) {
        most = std::max(most, std::abs(heights[1][v] - heights[0][v]) / static_cast<float>(2.0 * size));
      }
      for (std::size_t v = 0; v < rows.size(); ++v) {
        float made = 0.0f;
        for (const UnknownChange& change : rows[v]) {
          if (change.unknown == static_cast<int>(number / kFitNumbers)) made = change.by[number % kFitNumbers];
        }
        const float measured = (heights[1][v] - heights[0][v]) / static_cast<float>(2.0 * size);
        if (std::abs(measured) < 0.02f * most && std::abs(made) < 0.02f * most) continue;
        ++compared;
        // Blend widths change with the muscles, too; changes leave that out.
        apart += std::abs(measured - made) > 0.1f * most ? 1 : 0;
      }
    }
  }
  EXPECT_GT(compared, 5000U);
  EXPECT_LT(static_cast<double>(apart), 0.06 * static_cast<double>(compared)) << compared;
}

TEST(HeightModel, HeightsAreThoseOfTheSurfaceWithoutItsLastStages) {
  const auto character = test::makeTwoLegged();
  Rig rig = someRig(*character, 3);
  auto model = HeightModel::create(character, rig);
  ASSERT_TRUE(model.ok()) << model.error().text();
  Smoother smoother(character);
  rig.smoothing.detail = DetailKind::kUniform;
  std::size_t moved = 0;
  std::size_t same = 0;
  for (int depth = 1; depth <= 4; ++depth) {  // The model chooses one.
    rig.smoothing.depth = depth;
    ASSERT_TRUE(smoother.prepare(rig).ok());
    Surface surface;
    ASSERT_TRUE(smoother.smooth(bindPose(character->skeleton), surface));
    if (surface.displacement.size() != model->points().size()) continue;
    for (std::size_t v = 0; v < surface.displacement.size(); ++v) {
      if (surface.displacement[v] == 0.0f && model->heights()[v] == 0.0f) continue;
      ++moved;
      same += std::abs(surface.displacement[v] - model->heights()[v]) < 1e-4f * character->height ? 1 : 0;
    }
  }
  EXPECT_GT(moved, 100U);
  EXPECT_GT(static_cast<double>(same), 0.6 * static_cast<double>(moved)) << moved;  // Most are not lowered or filtered.
}

}  // namespace
}  // namespace sinew
