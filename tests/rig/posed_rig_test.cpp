// tests/rig/posed_rig_test.cpp: a rig in a pose: bones of its muscles, and the state of each line.
#include "core/rig/posed_rig.h"

#include <gtest/gtest.h>

#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_animation.h"

namespace sinew::test {
namespace {

std::filesystem::path asset(const char* name) { return std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / name; }

TEST(PosedRigs, MuscleWithoutItsBoneIsUnusableAndOthersAreUnchanged) {
  const auto character = importGltf(asset("humanoid.glb")).value();
  const Rig whole = loadRig(asset("humanoid-flex.rig.json")).value();
  Rig rig = whole;
  rig.primitives[0].bone = "none";
  const Pose pose = samplePose(character->skeleton, character->clips.at(0), 0.4f);
  const PosedRig before = RigPoser(whole, *character).pose(pose);
  const PosedRig after = RigPoser(rig, *character).pose(pose);
  EXPECT_TRUE(before.muscles[0].usable);
  EXPECT_FALSE(after.muscles[0].usable);
  for (std::size_t i = 1; i < after.muscles.size(); ++i) {
    EXPECT_EQ(after.muscles[i].carrier, before.muscles[i].carrier) << rig.primitives[i].name;
  }
}

TEST(PosedRigs, FlexingALineMovesOnlyItsMuscles) {
  const auto character = importGltf(asset("humanoid.glb")).value();
  const Rig rig = loadRig(asset("humanoid-flex.rig.json")).value();
  const RigPoser poser(rig, *character);
  Pose pose = samplePose(character->skeleton, character->clips.at(0), 0.4f);
  const PosedRig slack = poser.pose(pose);
  pose.flex = 0.7f;
  pose.flexedLines = {1};
  const PosedRig flexed = poser.pose(pose);
  int moved = 0;
  for (std::size_t i = 0; i < flexed.muscles.size(); ++i) {
    const bool same = flexed.muscles[i].carrier == slack.muscles[i].carrier;
    EXPECT_TRUE(same || flexed.muscles[i].line == 1) << rig.primitives[i].name;
    moved += same ? 0 : 1;
  }
  EXPECT_GT(moved, 0);
}

TEST(PosedRigs, MusclesWithoutLinesFollowTheirBones) {
  const auto character = makeLimb();
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Rig rig = animatedLimbRig(*character, seed);
    const Pose pose = samplePose(character->skeleton, character->clips.front(), 0.8f);
    const PosedRig posed = RigPoser(rig, *character).pose(pose);
    for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
      if (posed.muscles[i].line >= 0) continue;
      const int bone = character->skeleton.findBone(rig.primitives[i].bone).value();
      EXPECT_EQ(posed.muscles[i].carrier, pose.boneInWorld[static_cast<std::size_t>(bone)]);
      EXPECT_EQ(posed.muscles[i].body.placement, posed.numbers.primitives[i].placement);
    }
  }
}

}  // namespace
}  // namespace sinew::test
