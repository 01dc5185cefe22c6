// tests/surface/driven_surface_test.cpp: a driven rig's surface matches that of a rig with the same values as
// constants.

#include <gtest/gtest.h>

#include "core/rig/validation.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/driven_rig.h"
#include "tests/support/rigs/random_animation.h"

namespace sinew {
namespace {

/// The rig with its current values and without drivers.
Rig typedIn(Rig rig) {
  rig.surface.animated.clear();
  for (MuscleLine& line : rig.lines) line.animated.clear();
  for (Primitive& primitive : rig.primitives) primitive.animated.clear();
  for (Link& link : rig.links) link.animated.clear();
  return rig;
}

class DrivenSurface : public testing::TestWithParam<SurfaceMode> {};

TEST_P(DrivenSurface, MatchesTheEvaluatedNumbers) {
  const auto character = test::makeLimb();
  const AnimationClip& clip = character->clips.front();
  int moved = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Rig rig = test::animatedLimbRig(*character, seed);
    rig.surface.mode = GetParam();
    rig.smoothing.depth = 2;
    ASSERT_TRUE(validate(rig)) << validate(rig).error().text();
    Smoother live(character);
    ASSERT_TRUE(live.prepare(rig));
    Surface driven;
    // Back and forth: earlier frames leave nothing behind.
    for (const float time : {1.4f, 0.2f, 1.4f}) {
      const Pose pose = samplePose(character->skeleton, clip, time);
      live.smooth(pose, driven);
      const Rig numbers = typedIn(test::drivenRig(rig, *character, pose));
      Smoother fresh(character);
      ASSERT_TRUE(fresh.prepare(numbers));
      Surface typed;
      fresh.smooth(pose, typed);
      EXPECT_EQ(driven.positions, typed.positions);
      EXPECT_EQ(driven.normals, typed.normals);
      EXPECT_EQ(driven.classes, typed.classes);
      moved += numbers != typedIn(rig) ? 1 : 0;
    }
  }
  EXPECT_GT(moved, 20);
}

INSTANTIATE_TEST_SUITE_P(Modes, DrivenSurface, testing::Values(SurfaceMode::kSwell, SurfaceMode::kReplace),
                         [](const auto& mode) { return std::string(nameOf(mode.param)); });

TEST(DrivenSurfaces, ZeroAmountIsNoMuscle) {
  const auto character = test::makeLimb();
  Rig rig = test::randomRig(*character, {.primitives = 3, .carveChance = 0.0f}, 4);
  rig.smoothing.depth = 2;
  Rig without = rig;
  for (Primitive& primitive : rig.primitives) primitive.amount = 0.0f;
  without.primitives.clear();
  const Pose pose = samplePose(character->skeleton, character->clips.front(), 1.0f);
  Surface none;
  Surface zero;
  Smoother a(character);
  ASSERT_TRUE(a.prepare(without));
  a.smooth(pose, none);
  Smoother b(character);
  ASSERT_TRUE(b.prepare(rig));
  b.smooth(pose, zero);
  EXPECT_EQ(zero.positions, none.positions);
  EXPECT_EQ(zero.normals, none.normals);
}

TEST(DrivenSurfaces, LargerAmountRisesHigher) {
  const auto character = test::makeLimb();
  const Pose pose = bindPose(character->skeleton);
  float last = -1.0f;
  for (const float amount : {0.25f, 0.5f, 1.0f, 1.5f, 2.0f}) {
    Rig rig = test::randomRig(*character, {.primitives = 1, .groups = 1, .carveChance = 0.0f, .radiusLow = 0.1f}, 9);
    rig.primitives[0].amount = amount;
    Smoother smoother(character);
    ASSERT_TRUE(smoother.prepare(rig));
    Surface surface;
    smoother.smooth(pose, surface);
    float most = 0.0f;
    for (const float lift : surface.displacement) most = std::max(most, lift);
    EXPECT_GT(most, last);
    last = most;
  }
}

}  // namespace
}  // namespace sinew
