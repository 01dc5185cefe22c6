// tests/surface/projection/blend_width_test.cpp: a wider skin blend makes muscles softer, up to their own size.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/mesh_checks.h"
#include "tests/support/surface/projected.h"

namespace sinew::test {
namespace {

/// The limb's skin over one muscle on its middle bone, half sunk in, before heights are filtered.
Surface over(const Placement& placement, float skinBlend) {
  const auto character = makeLimb();
  Rig rig;
  rig.groups.push_back({"muscles", {}});
  Primitive muscle;
  muscle.name = "muscle";
  muscle.bone = character->skeleton.fileName(1);
  muscle.group = "muscles";
  muscle.placement = placement;
  muscle.reach = kNewReach;
  rig.primitives.push_back(muscle);
  rig.surface.skinBlend = skinBlend;
  rig.smoothing.depth = 6;
  return Projected(*character, rig).at(bindPose(character->skeleton));
}

const Placement kMuscle{glm::vec3(0.3f, 0.3f, 0.0f), glm::quat(1.0f, 0.0f, 0.0f, 0.0f), glm::vec3(0.1f, 0.24f, 0.15f)};
const float kMeanRadius = std::cbrt(0.1f * 0.24f * 0.15f) / 2.0f;  // Fraction of H, which is 2.

TEST(BlendWidth, WiderBlendNeverLowersTheSkin) {
  Surface before = over(kMuscle, 0.002f);
  int higher = 0;
  for (const float blend : {0.005f, 0.01f, 0.02f, 0.04f, 0.06f}) {
    const Surface now = over(kMuscle, blend);
    for (std::size_t v = 0; v < now.positions.size(); ++v) {
      EXPECT_GE(now.displacement[v], before.displacement[v] - 2e-5f) << "vertex " << v << ", blend " << blend;
      higher += now.displacement[v] > before.displacement[v] + 1e-4f ? 1 : 0;
    }
    before = now;
  }
  EXPECT_GT(higher, 50);
}

TEST(BlendWidth, SaturatesAtTheMusclesMeanRadius) {
  ASSERT_LT(kMeanRadius, 0.08f);
  const Surface full = over(kMuscle, 1.001f * kMeanRadius);
  for (const float blend : {0.1f, 0.3f, 2.0f}) {
    EXPECT_TRUE(sameBytes(full.positions, over(kMuscle, blend).positions)) << blend;
  }
  const Surface narrower = over(kMuscle, 0.8f * kMeanRadius);
  EXPECT_FALSE(sameBytes(full.positions, narrower.positions)) << "the limit is the mean radius";
}

// A rim as steep as a wall at the influence's border used to turn every muscle into a hard pillow.
TEST(BlendWidth, KeepsRimsFromBecomingWalls) {
  for (const float blend : {0.04f, 0.15f, 0.5f}) {
    const Surface surface = over(kMuscle, blend);
    const Surface bare = over({glm::vec3(9.0f), kMuscle.rotation, kMuscle.radii}, blend);
    float steepest = 0.0f;
    for (const auto& t : surface.refinement->triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto a = static_cast<std::size_t>(t[i]);
        const auto b = static_cast<std::size_t>(t[(i + 1) % 3]);
        const float along = glm::distance(bare.positions[a], bare.positions[b]);
        steepest = std::max(steepest, std::abs(surface.displacement[a] - surface.displacement[b]) / along);
      }
    }
    EXPECT_LT(steepest, 0.85f) << "blend " << blend;
    EXPECT_GT(steepest, 0.1f) << "blend " << blend << ": hardly a muscle";
  }
}

}  // namespace
}  // namespace sinew::test
