// tests/rig/motion_clip_test.cpp: the range of motion is added to the clips once, and never replaces a file's own clip.

#include "core/rig/motion_clip.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "core/character/bindings.h"
#include "core/character/pose_override.h"
#include "core/character/range_of_motion.h"
#include "core/geometry/at.h"
#include "tests/support/characters/named_bodies.h"
#include "tests/support/characters/synthetic_characters.h"

namespace sinew {
namespace {

TEST(MotionClip, IsAppendedWithoutOtherChanges) {
  const auto before = test::makeTwoLegged();
  const auto after = withRangeOfMotion(before);
  ASSERT_NE(after, before);
  ASSERT_EQ(after->clips.size(), before->clips.size() + 1);
  EXPECT_EQ(after->clips.front().name, before->clips.front().name);
  EXPECT_EQ(findClip(*after, kRangeOfMotionName), static_cast<int>(before->clips.size()));
  EXPECT_EQ(findClip(*before, kRangeOfMotionName), -1);
  EXPECT_EQ(after->mesh.positions, before->mesh.positions);
  EXPECT_EQ(withRangeOfMotion(after), after) << "once";
}

TEST(MotionClip, ClipOfTheFileWithThatNameWins) {
  Character own = *test::makeTwoLegged();
  own.clips.front().name = kRangeOfMotionName;
  const auto character = std::make_shared<const Character>(own);
  EXPECT_EQ(withRangeOfMotion(character), character);
  EXPECT_FALSE(character->clips[static_cast<std::size_t>(findClip(*character, kRangeOfMotionName))].turnsBindPose);
}

TEST(MotionClip, IsCreatedOnlyByName) {
  const auto character = test::makeLimb();
  EXPECT_EQ(withClipNamed(character, ""), character);
  EXPECT_EQ(withClipNamed(character, "bend"), character);
  EXPECT_NE(withClipNamed(character, std::string(kRangeOfMotionName)), character);
}

TEST(MotionClip, IsNotCreatedWithoutJointsToRotate) {
  Character lone = *test::makeLimb();
  for (Influence& influence : lone.mesh.influences) influence.binding = 0;  // All skin follows the root.
  const auto character = std::make_shared<const Character>(lone);
  EXPECT_EQ(withRangeOfMotion(character), character);
  const std::vector<bool> skin = bonesWithSkin(*character);
  EXPECT_TRUE(skin[0]);
  EXPECT_FALSE(skin[1]);
}

/// Displacement of a point at the end of a movement step.
glm::vec3 wayOf(const Skeleton& skeleton, const MovementStep& step, int bone) {
  PoseOverrides turns;
  for (const JointMovement& m : step) turns.set(m.bone, glm::angleAxis(m.to, m.axis));
  const auto i = static_cast<std::size_t>(bone);
  return glm::vec3(posed(skeleton, bindPose(skeleton), turns).boneInWorld[i][3] - skeleton.bones[i].bindInWorld[3]);
}

/// Japanese names, meaningless names, names of every program: the same body makes the same movements.
TEST(MotionClip, JointsMoveByRoleWhateverTheirNames) {
  const std::map<std::string, std::size_t> swings{
      {"hips", 0},       {"spine", 3},      {"neck", 3},   {"head", 3},   {"upperArm.L", 3}, {"upperArm.R", 3},
      {"lowerArm.L", 1}, {"lowerArm.R", 1}, {"hand.L", 2}, {"hand.R", 2}, {"upperLeg.L", 3}, {"upperLeg.R", 3},
      {"lowerLeg.L", 1}, {"lowerLeg.R", 1}, {"foot.L", 2}, {"foot.R", 2}};
  for (const test::NamedBody& body : test::namedBodies()) {
    for (const test::Stance stance : {test::Stance::kArmsLevel, test::Stance::kArmsDown}) {
      if (body.quadruped) continue;
      std::map<std::string, std::string> names;
      const Character character = test::characterOf(body, stance, names);
      const Skeleton& skeleton = character.skeleton;
      std::map<int, std::vector<MovementStep>> steps;
      for (const MovementStep& step : rangeOfMotionSteps(skeleton, motionHints(character))) {
        for (const JointMovement& m : step) steps[m.bone].push_back(step);
      }
      for (const auto& [slot, count] : swings) {
        if (!names.contains(slot)) continue;
        const int bone = skeleton.findBone(names[slot]).value();
        EXPECT_EQ(steps[bone].size(), count) << body.style << ": " << slot << ", " << names[slot];
      }
      for (const Bone& bone : skeleton.bones) {
        const bool twists =
            bone.name.find("Twist") != std::string::npos || bone.name.find("twist") != std::string::npos;
        if (!twists || bone.name.find("Neck") != std::string::npos) continue;
        EXPECT_TRUE(steps[skeleton.findBone(bone.name).value()].empty()) << body.style << ": " << bone.name;
      }
      for (const auto& [hinge, carried, forwards] :
           {std::tuple{"lowerArm.L", "hand.L", 1.0f}, std::tuple{"lowerLeg.R", "foot.R", -1.0f}}) {
        if (!names.contains(carried)) continue;
        const int bone = skeleton.findBone(names[hinge]).value();
        const int end = skeleton.findBone(names[carried]).value();
        const bool isCarried = at(skeleton.bones, end).path.starts_with(at(skeleton.bones, bone).path);
        if (steps[bone].size() != 1 || !isCarried) continue;
        const float forward = wayOf(skeleton, steps[bone][0], end).z;
        EXPECT_GT(forwards * forward, 0.05f) << body.style << ": " << hinge;
      }
    }
  }
}

}  // namespace
}  // namespace sinew
