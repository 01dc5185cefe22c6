// tests/surface/hidden_test.cpp: hidden muscles give the surface of a rig without them, bit for bit.

#include <vector>

#include <gtest/gtest.h>

#include "sinew/rig/rig_edit.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/prepared_in_turn.h"

namespace sinew::test {
namespace {

std::vector<int> randomlyHidden(const Rig& rig, Random& random) {
  const float share = random.uniform(0.0f, 1.0f);
  std::vector<int> hidden;
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    if (random.chance(share)) hidden.push_back(static_cast<int>(i));
  }
  return hidden;
}

void expectSameSurface(const Surface& a, const Surface& b) {
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.normals, b.normals);
  EXPECT_EQ(a.shadingNormals, b.shadingNormals);
  EXPECT_EQ(a.displacement, b.displacement);
  EXPECT_EQ(a.classes, b.classes);
  EXPECT_EQ(a.report.primitives, b.report.primitives);
  EXPECT_EQ(a.report.cliques, b.report.cliques);
  EXPECT_EQ(a.report.projected, b.report.projected);
  EXPECT_EQ(a.report.unresolved, b.report.unresolved);
}

class HiddenMuscles : public testing::TestWithParam<SurfaceMode> {};

TEST_P(HiddenMuscles, MatchARigWithoutThem) {
  const auto character = makeTwoLegged();
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Random random(seed);
    RigRecipe recipe;
    recipe.primitives = 12;
    recipe.groups = 1 + static_cast<int>(seed % 5);
    recipe.linkChance = 0.5f;
    recipe.carveChance = 0.3f;
    Rig rig = randomRig(*character, recipe, seed);
    rig.surface.mode = GetParam();
    rig.smoothing.creaseAngle = seed % 2 == 0 ? 180.0f : 30.0f;
    if (seed % 3 == 0) rig.primitives[2].bone = "of another character";
    const Pose pose = samplePose(character->skeleton, character->clips.back(), 0.1f * static_cast<float>(seed));
    const glm::vec3 eye(3.0f * character->height, character->height, 2.0f * character->height);
    Smoother masked(character);
    for (int step = 0; step < 6; ++step) {
      const std::vector<int> hidden = randomlyHidden(rig, random);
      if (step == 3) rig.primitives[0].placement.radii *= 1.2f;
      if (step == 5) rig.primitives[1].group = rig.groups.back().name;
      ASSERT_TRUE(masked.prepare(rig, hidden).ok());
      Smoother thinned(character);
      ASSERT_TRUE(thinned.prepare(removePrimitives(rig, hidden)).ok());
      const std::optional<glm::vec3> from = step % 2 == 0 ? std::nullopt : std::optional(eye);
      Surface surface, expected;
      masked.smooth(pose, surface, from);
      thinned.smooth(pose, expected, from);
      SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step));
      expectSameSurface(surface, expected);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, HiddenMuscles, testing::Values(SurfaceMode::kSwell, SurfaceMode::kReplace));

TEST(HiddenMuscles, ShowingAndHidingReattachesNothing) {
  const auto character = makeTwoLegged();
  const Rig rig = randomRig(*character, {}, 3);
  PreparedInTurn preparations(character);
  const auto attached = preparations.next(rig)->attached;
  const std::vector<int> all{0, 1, 2, 3, 4};
  for (const std::vector<int>& hidden : {all, std::vector<int>{}, std::vector<int>{1, 3}, all}) {
    EXPECT_EQ(preparations.next(rig, hidden)->attached, attached);
  }
}

TEST(HiddenMuscles, IndicesReferToTheWholeRig) {
  const auto character = makeTwoLegged();
  Rig rig = randomRig(*character, {}, 3);
  rig.primitives[4].bone = "of another character";
  Smoother smoother(character);
  ASSERT_TRUE(smoother.prepare(rig, std::vector<int>{0, 1}).ok());
  EXPECT_EQ(smoother.unattached(), std::vector<int>{4});
  Surface surface;
  smoother.smooth(bindPose(character->skeleton), surface);
  EXPECT_EQ(surface.report.primitives, 2);
}

}  // namespace
}  // namespace sinew::test
