// tests/surface/cancelling_test.cpp: where the field is only rounding error, the skin stays.

#include <cmath>

#include <gtest/gtest.h>

#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew::test {
namespace {

constexpr float kStays = 1e-4f;  ///< Fraction of H.

/// Adds a carve for each muscle: the same ellipsoid with another quaternion, so that the sums do not cancel exactly.
Rig undone(Rig rig) {
  const std::vector<Primitive> muscles = rig.primitives;
  for (Primitive carve : muscles) {
    carve.name += " undone";
    carve.sign = -1;
    carve.placement.rotation = carve.placement.rotation * glm::quat(0.0f, 0.0f, 1.0f, 0.0f);
    rig.primitives.push_back(carve);
  }
  return rig;
}

TEST(Canceling, MuscleAndOppositeCarveCancel) {
  for (const auto& character : {makeLimb(), makeTwoLegged(), makeStrip()}) {
    int projected = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      RigRecipe recipe;
      recipe.primitives = 3;
      recipe.groups = 1;
      recipe.carveChance = 0.0f;
      Rig rig = undone(randomRig(*character, recipe, seed));
      rig.smoothing.depth = 4;
      Smoother smoother(character);
      ASSERT_TRUE(smoother.prepare(rig).ok());
      Surface surface;
      smoother.smooth(randomPose(character->skeleton, 0.5f, 0.1f, seed), surface);
      projected += surface.report.projected;
      for (std::size_t v = 0; v < surface.displacement.size(); ++v) {
        ASSERT_LE(std::abs(surface.displacement[v]), kStays * character->height)
            << character->name << ", seed " << seed << ", vertex " << v;
      }
    }
    EXPECT_GT(projected, 20) << "rounding never met the search";
  }
}

// An influence that just touches a vertex: the field there is rounding error, and so must be its effect.
TEST(Canceling, BarelyTouchingInfluenceBarelyMovesTheSkin) {
  const auto character = makeLimb();
  RigRecipe recipe;
  recipe.primitives = 1;
  recipe.carveChance = 0.0f;
  int touched = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Rig rig = randomRig(*character, recipe, seed);
    rig.smoothing.depth = 2;
    const Pose pose = bindPose(character->skeleton);
    Smoother smoother(character);
    Surface surface;
    float last = rig.primitives[0].reach;
    for (int step = 0; step < 200; ++step) {
      rig.primitives[0].reach = last;
      last = std::nextafter(last, 3.0f);
      ASSERT_TRUE(smoother.prepare(rig).ok());
      Surface next;
      smoother.smooth(pose, next);
      for (std::size_t v = 0; step > 0 && v < next.displacement.size(); ++v) {
        ASSERT_LE(std::abs(next.displacement[v] - surface.displacement[v]), kStays * character->height)
            << "seed " << seed << ", reach " << rig.primitives[0].reach << ", vertex " << v;
      }
      touched += next.report.projected;
      surface = std::move(next);
    }
  }
  EXPECT_GT(touched, 0);
}

}  // namespace
}  // namespace sinew::test
