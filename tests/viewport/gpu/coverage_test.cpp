// tests/viewport/gpu/coverage_test.cpp: surfaces that the GPU cannot compute are left to the CPU, with a reason.

#include "app/viewport/gpu/card_surface.h"

#include <string>

#include <gtest/gtest.h>

#include "app/viewport/gpu/card_tables.h"
#include "sinew/files/gltf_import.h"
#include "tests/support/characters/dressed_humanoid.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/keyed_links.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/rigs/trial_scenes.h"

namespace sinew::test {
namespace {

std::shared_ptr<const Preparation> prepared(const std::shared_ptr<const Character>& character, const Rig& rig) {
  BlendingGraphMemo graphs;
  auto preparation = prepare(characterTables(character), rig, {}, nullptr, graphs);
  EXPECT_TRUE(preparation.ok());
  return preparation.value();
}

std::string reasonOf(const TrialScene& scene, int bodies = 1) {
  return app::leftToProcessor(*prepared(scene.character, scene.rig), bodies).value_or("");
}

TEST(GpuCoverage, IncludesTheBundledRigs) {
  for (const char* name : {"humanoid", "horse", "demo", "tangle", "wrapped", "humanoid-wrapped", "horse-wrapped"}) {
    EXPECT_EQ(reasonOf(bundledTrialScene(name)), "") << name;
    EXPECT_EQ(reasonOf(bundledTrialScene(name), 100), "") << name;
  }
}

TEST(GpuCoverage, GivesTheReasonForTheProcessor) {
  TrialScene scene = bundledTrialScene("demo");
  scene.rig.smoothing.creaseAngle = 10.0f;
  EXPECT_EQ(reasonOf(scene), "the surface has creases");

  scene.rig.smoothing.creaseAngle = kDefaultCreaseAngle;
  scene.rig.surface.grooves = 0.015f;
  EXPECT_EQ(reasonOf(scene), "") << "swell";
  scene.rig = withMode(scene.rig, SurfaceMode::kReplace);
  EXPECT_EQ(reasonOf(scene), "in replace, grooves between muscles are soft");

  scene = bundledTrialScene("demo");
  ASSERT_FALSE(scene.rig.links.empty());
  scene.rig.links.front().amount = 0.5f;
  EXPECT_EQ(reasonOf(scene, 100), "") << "swell";
  EXPECT_EQ(reasonOf({"", scene.character, withMode(scene.rig, SurfaceMode::kReplace)}),
            "in replace, groups are linked in part");
  scene.rig = withKeyedLinks(scene.rig, scene.character->clips.front(), 1);
  EXPECT_EQ(reasonOf(scene), "") << "swell";
  EXPECT_EQ(reasonOf(scene, 2), "keys or drivers change links of a crowd's bodies");
  EXPECT_EQ(reasonOf({"", scene.character, withMode(scene.rig, SurfaceMode::kReplace)}),
            "in replace, keys or drivers change links");

  EXPECT_EQ(reasonOf({"", dressedHumanoid(), bundledTrialScene("humanoid").rig}), "the character wears cloth");

  RigRecipe crowded;
  crowded.primitives = 400;
  crowded.groups = 1;
  crowded.radiusHigh = 0.3f;
  const auto character = makeTwoLegged();
  const std::string many = reasonOf({"", character, randomRig(*character, crowded, 1)});
  EXPECT_NE(many.find(" muscles reach one place of the skin, at most 96"), std::string::npos) << many;
}

// A line bends its muscle only in some poses, which `replace` does not support.
TEST(GpuCoverage, IsCheckedInEveryPose) {
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    const TrialScene scene = bundledTrialScene("humanoid-flex");
    const auto preparation = prepared(scene.character, withMode(scene.rig, mode));
    EXPECT_EQ(app::leftToProcessor(*preparation).value_or(""), "");
    app::PosedMuscles posed;
    int left = 0;
    for (const Pose& pose : spreadPoses(*scene.character, 4)) {
      const auto reason = app::poseMuscles(preparation, pose, posed);
      EXPECT_EQ(reason.value_or("in replace, a muscle is not a plain ellipsoid"),
                "in replace, a muscle is not a plain ellipsoid");
      left += reason ? 1 : 0;
    }
    EXPECT_EQ(left > 0, mode == SurfaceMode::kReplace);
  }
}

TEST(WorkGroups, HoldEveryItemWithinTheLimit) {
  for (const std::uint32_t most : {1u, 5u, 1000u, app::kMostGroupsAlong}) {
    for (const std::uint32_t items : {1u, 63u, 64u, 65u, 4'194'240u, 4'194'241u, 16'000'000u}) {
      const std::uint64_t groups = (items + app::kGroupSize - 1) / app::kGroupSize;
      if (groups > std::uint64_t{most} * most) continue;
      const app::Groups made = app::groupsFor(items, most);
      EXPECT_LE(made.x, most);
      EXPECT_LE(made.y, most);
      EXPECT_GE(std::uint64_t{made.x} * made.y, groups);
      EXPECT_LT(std::uint64_t{made.x} * made.y - groups, made.y) << "no more are idle than fill up the rows";
    }
  }
}

}  // namespace
}  // namespace sinew::test
