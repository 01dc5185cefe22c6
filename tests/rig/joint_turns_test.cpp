// tests/rig/joint_turns_test.cpp: bend, twist and nearness measured for given rotations.

#include "core/rig/driver_input.h"

#include <cmath>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "core/character/pose_override.h"
#include "core/character/range_of_motion.h"
#include "tests/support/characters/real_characters.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew {
namespace {

int boneNamed(const Character& character, const char* name) { return *character.skeleton.findBone(name); }

/// One joint rotated from the bind pose, in its own frame for rotations.
Pose turned(const Character& character, int bone, const glm::quat& turn) {
  PoseOverrides overrides;
  overrides.set(bone, turn);
  return posed(character.skeleton, bindPose(character.skeleton), overrides);
}

TEST(JointRotations, AreZeroInTheBindPose) {
  const auto character = test::makeTwoLegged();
  const Pose bind = bindPose(character->skeleton);
  for (int bone = 0; bone < static_cast<int>(character->skeleton.bones.size()); ++bone) {
    EXPECT_NEAR(bendOf(character->skeleton, bind, bone), 0.0f, 1e-4f);
    EXPECT_NEAR(turnAbout(heldTurn(character->skeleton, bind, bone), {0.0f, 1.0f, 0.0f}), 0.0f, 1e-4f);
  }
}

TEST(JointRotations, BendIsTheAppliedAngle) {
  const auto character = test::makeLimb();
  const int bone = boneNamed(*character, "middle");
  const glm::vec3 along = boneDirection(character->skeleton.bones[static_cast<std::size_t>(bone)]);
  const glm::vec3 across = glm::normalize(glm::cross(along, glm::vec3(0.3f, 0.2f, 0.9f)));
  for (float degrees = -170.0f; degrees <= 170.0f; degrees += 10.0f) {
    const Pose pose = turned(*character, bone, glm::angleAxis(glm::radians(degrees), across));
    // The limb is straight in the bind pose.
    EXPECT_NEAR(bendOf(character->skeleton, pose, bone), std::abs(degrees), 1e-3f);
  }
}

TEST(JointRotations, TwistIsTheAppliedAngleWithoutBend) {
  const auto character = test::makeLimb();
  const int bone = boneNamed(*character, "middle");
  const glm::vec3 along = boneDirection(character->skeleton.bones[static_cast<std::size_t>(bone)]);
  test::Random random(5);
  for (float degrees = -175.0f; degrees <= 175.0f; degrees += 12.5f) {
    const glm::quat twist = glm::angleAxis(glm::radians(degrees), along);
    const Pose pose = turned(*character, bone, twist);
    EXPECT_NEAR(turnAbout(heldTurn(character->skeleton, pose, bone), along), degrees, 1e-2f);
    EXPECT_NEAR(bendOf(character->skeleton, pose, bone), 0.0f, 0.05f);
    // A swing after the twist does not change it.
    const glm::vec3 across = glm::normalize(glm::cross(along, glm::vec3(random.uniform(-1, 1), 0.2f, 0.9f)));
    const glm::quat swung = glm::angleAxis(glm::radians(random.uniform(-80.0f, 80.0f)), across) * twist;
    const Pose both = turned(*character, bone, swung);
    EXPECT_NEAR(turnAbout(heldTurn(character->skeleton, both, bone), along), degrees, 1e-2f);
  }
}

TEST(JointRotations, NearnessMatchesTheClosedForm) {
  test::Random random(6);
  for (int i = 0; i < 200; ++i) {
    const glm::quat wanted = random.rotation();
    const float angle = random.uniform(0.0f, 180.0f);
    const glm::vec3 axis = glm::normalize(glm::vec3(random.uniform(-1, 1), random.uniform(-1, 1), 0.5f));
    glm::quat turn = wanted * glm::angleAxis(glm::radians(angle), axis);
    if (random.chance(0.5f)) turn = -turn;
    EXPECT_NEAR(nearness(turn, wanted, 35.0f), std::exp(-angle * angle / (2.0f * 35.0f * 35.0f)), 1e-4f);
  }
}

/// Largest change of any joint's measures over the range of motion, in steps of at most a tenth of a degree.
void expectContinuous(const Character& character) {
  const AnimationClip clip = rangeOfMotion(character.skeleton);
  const Skeleton& skeleton = character.skeleton;
  std::vector<Pose> poses;
  // Dense intervals of a few frames each, spread over the clip: all of it takes minutes on a detailed skeleton.
  const float step = 0.0005f;
  for (float from = 0.0f; from < clip.duration; from += clip.duration / 60.0f) {
    Pose last = samplePose(skeleton, clip, from);
    for (int i = 1; i <= 4; ++i) {
      const Pose now = samplePose(skeleton, clip, from + step * static_cast<float>(i));
      for (int bone = 0; bone < static_cast<int>(skeleton.bones.size()); ++bone) {
        const glm::vec3 along = boneDirection(skeleton.bones[static_cast<std::size_t>(bone)]);
        EXPECT_NEAR(bendOf(skeleton, now, bone), bendOf(skeleton, last, bone), 1.0f);
        const float before = turnAbout(heldTurn(skeleton, last, bone), along);
        const float after = turnAbout(heldTurn(skeleton, now, bone), along);
        const float jump = std::abs(after - before);
        EXPECT_LT(std::min(jump, 360.0f - jump), 1.0f) << skeleton.bones[static_cast<std::size_t>(bone)].name;
      }
      last = now;
    }
  }
}

TEST(JointRotations, AreContinuousOverTheRangeOfMotion) { expectContinuous(*test::makeTwoLegged()); }

TEST(JointRotations, AreContinuousOverTheRangeOfMotionOfFox) {
  const auto fox = test::realCharacter("Fox.glb");
  if (!fox) GTEST_SKIP() << "left out: real characters are not at hand";
  expectContinuous(*fox);
}

}  // namespace
}  // namespace sinew
