// tests/character/range_of_motion_test.cpp: the clip generated from a skeleton: complete, within limits, starts and
// ends at rest.

#include "core/character/range_of_motion.h"

#include <cmath>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/character/joint_roles.h"
#include "core/character/pose_override.h"
#include "core/rig/mirror.h"
#include "sinew/character/character.h"
#include "sinew/files/gltf_import.h"
#include "tests/support/characters/characters.h"
#include "tests/support/characters/real_characters.h"
#include "tests/support/characters/synthetic_characters.h"

namespace sinew {
namespace {

constexpr float kDegree = std::numbers::pi_v<float> / 180.0f;

std::vector<bool> skinned(const Character& character) {
  std::vector<bool> result(character.skeleton.bones.size(), false);
  for (const Influence& influence : character.mesh.influences) {
    const int bone = character.skeleton.bindings[static_cast<std::size_t>(influence.binding)].bone;
    if (influence.weight > 0.0f) result[static_cast<std::size_t>(bone)] = true;
  }
  return result;
}

RangeOfMotionHints hintsFor(const Character& character) {
  const MirrorPlan plan = makeMirrorPlan(character);
  return {plan.twinOf, glm::vec3(plan.plane.normal), skinned(character), {}, {}};
}

/// Rotation of a bone relative to its parent and the bind pose, radians.
float bentBy(const Skeleton& skeleton, const Pose& pose, std::size_t bone) {
  const Bone& b = skeleton.bones[bone];
  const auto relative = [&](const glm::mat4& own, const glm::mat4& parent) {
    return glm::transpose(turnFrame(parent)) * turnFrame(own);
  };
  const glm::mat4 none(1.0f);
  const auto p = static_cast<std::size_t>(std::max(b.parent, 0));
  const glm::mat3 bound = relative(b.bindInWorld, b.parent < 0 ? none : skeleton.bones[p].bindInWorld);
  const glm::mat3 now = relative(pose.boneInWorld[bone], b.parent < 0 ? none : pose.boneInWorld[p]);
  const glm::quat q = glm::quat_cast(glm::transpose(bound) * now);
  return 2.0f * std::atan2(glm::length(glm::vec3(q.x, q.y, q.z)), std::abs(q.w));
}

void expectSound(const Character& character, bool withHints) {
  const Skeleton& skeleton = character.skeleton;
  const RangeOfMotionHints hints = withHints ? hintsFor(character) : RangeOfMotionHints{};
  const AnimationClip clip = rangeOfMotion(skeleton, hints);
  ASSERT_FALSE(clip.channels.empty());
  EXPECT_EQ(clip.name, kRangeOfMotionName);
  EXPECT_GT(clip.duration, 0.9f);
  EXPECT_LT(clip.duration, 240.0f);
  const Pose bound = bindPose(skeleton);
  EXPECT_EQ(samplePose(skeleton, clip, 0.0f).boneInWorld, bound.boneInWorld);
  EXPECT_EQ(samplePose(skeleton, clip, clip.duration).boneInWorld, bound.boneInWorld);
  std::vector<float> most(skeleton.bones.size(), 0.0f);
  Pose before = bound;
  for (float time = 0.0f; time <= clip.duration; time += 1.0f / 30.0f) {
    const Pose pose = samplePose(skeleton, clip, time);
    for (std::size_t i = 0; i < most.size(); ++i) {
      ASSERT_TRUE(isFinite(pose.boneInWorld[i])) << skeleton.bones[i].name << " at " << time;
      most[i] = std::max(most[i], bentBy(skeleton, pose, i));
      const glm::quat step =
          glm::quat_cast(glm::transpose(turnFrame(before.boneInWorld[i])) * turnFrame(pose.boneInWorld[i]));
      EXPECT_LT(2.0f * std::acos(std::min(1.0f, std::abs(step.w))), 30.0f * kDegree) << "a jump at " << time;
    }
    before = pose;
  }
  const std::vector<JointRole> roles = jointRoles(skeleton);
  const std::vector<bool> skin = skinned(character);
  for (std::size_t i = 0; i < most.size(); ++i) {
    EXPECT_LT(most[i], 131.0f * kDegree) << skeleton.bones[i].name;
    const Bone& bone = skeleton.bones[i];
    if (bone.parent < 0 || (roles[i] == JointRole::kStill && !bone.children.empty())) {
      EXPECT_LT(most[i], 0.1f * kDegree) << bone.name << " moves the whole body";
    } else if (withHints && skin[i]) {
      EXPECT_GT(most[i], 9.0f * kDegree) << bone.name << " stands still";
    }
  }
}

TEST(RangeOfMotion, IsSoundOnSyntheticCharacters) {
  for (const auto& character :
       {test::makeLimb(), test::makeTwoLegged(), test::makeStrip(), test::makeTube(), test::makeCube()}) {
    for (const bool hints : {false, true}) expectSound(*character, hints);
  }
}

TEST(RangeOfMotion, IsSoundOnBundledCharacters) {
  for (const char* name : {"demo.glb", "humanoid.glb", "horse.glb"}) {
    const auto file = std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / name;
    if (!std::filesystem::exists(file)) continue;
    const auto imported = importGltf(file);
    ASSERT_TRUE(imported.ok()) << imported.error().text();
    SCOPED_TRACE(name);
    for (const bool hints : {false, true}) expectSound(*imported.value(), hints);
  }
}

TEST(RangeOfMotion, IsSoundOnRealCharacters) {
  if (!test::characterFile("greenman.glb")) SINEW_SKIP_WITHOUT_CHARACTERS();
  for (const char* name : {"Fox.glb", "greenman.glb", "robot.glb", "cesium_man.gltf", "rigged_simple.gltf"}) {
    SCOPED_TRACE(name);
    const auto character = test::realCharacter(name);
    ASSERT_TRUE(character);
    for (const bool hints : {false, true}) expectSound(*character, hints);
  }
}

TEST(RangeOfMotion, IsRepeatable) {
  const auto character = test::makeTwoLegged();
  const AnimationClip a = rangeOfMotion(character->skeleton);
  const AnimationClip b = rangeOfMotion(character->skeleton);
  ASSERT_EQ(a.channels.size(), b.channels.size());
  for (std::size_t i = 0; i < a.channels.size(); ++i) {
    EXPECT_EQ(a.channels[i].node, b.channels[i].node);
    EXPECT_EQ(a.channels[i].times, b.channels[i].times);
    EXPECT_EQ(a.channels[i].values, b.channels[i].values);
  }
}

TEST(RangeOfMotion, LoneRootHasNone) {
  Skeleton skeleton;
  skeleton.nodes.resize(1);
  skeleton.bones.resize(1);
  finishBones(skeleton);
  EXPECT_TRUE(rangeOfMotion(skeleton).channels.empty());
  EXPECT_EQ(rangeOfMotion(skeleton).duration, 0.0f);
  EXPECT_TRUE(rangeOfMotion(Skeleton{}).channels.empty());
}

// A person in a T-pose that faces +Z or, rotated, -Z; with random frames.
struct Joint {
  const char* name;
  int parent;
  glm::vec3 origin;
};
constexpr Joint kPerson[] = {
    {"Hips", -1, {0, 1, 0}},
    {"Spine", 0, {0, 1.2f, 0}},
    {"Head", 1, {0, 1.6f, 0}},
    {"LeftArm", 1, {0.2f, 1.5f, 0}},
    {"LeftForeArm", 3, {0.5f, 1.5f, 0}},
    {"LeftHand", 4, {0.75f, 1.5f, 0}},
    {"RightArm", 1, {-0.2f, 1.5f, 0}},
    {"RightForeArm", 6, {-0.5f, 1.5f, 0}},
    {"RightHand", 7, {-0.75f, 1.5f, 0}},
    {"LeftUpLeg", 0, {0.1f, 0.95f, 0}},
    {"LeftLeg", 9, {0.1f, 0.5f, 0}},
    {"LeftFoot", 10, {0.1f, 0.08f, 0}},
    {"RightUpLeg", 0, {-0.1f, 0.95f, 0}},
    {"RightLeg", 12, {-0.1f, 0.5f, 0}},
    {"RightFoot", 13, {-0.1f, 0.08f, 0}},
};

Skeleton person(float facing, bool hasMirroredFrames = false) {
  Skeleton skeleton;
  for (const Joint& joint : kPerson) {
    Bone bone;
    bone.name = joint.name;
    bone.node = static_cast<int>(skeleton.bones.size());
    bone.parent = joint.parent;
    const float k = static_cast<float>(bone.node);
    const glm::vec3 origin(facing * joint.origin.x, joint.origin.y, facing * joint.origin.z);
    bone.bindInWorld = glm::translate(glm::mat4(1.0f), origin) *
                       glm::mat4_cast(glm::angleAxis(0.7f * k, glm::normalize(glm::vec3(1.0f, 0.3f * k, 0.5f))));
    if (hasMirroredFrames && bone.node % 2 == 0) bone.bindInWorld[0] *= -1.0f;
    skeleton.bones.push_back(bone);
    skeleton.nodes.push_back({joint.name, joint.parent, {}});
  }
  finishBones(skeleton);
  return skeleton;
}

int boneNamed(const Skeleton& skeleton, const char* name) { return skeleton.findBone(name).value(); }

/// Visits the position of a point carried by a bone at every frame of the clip, relative to its bind position.
template <class Visit>
void follow(const Skeleton& skeleton, const AnimationClip& clip, const char* bone, Visit visit) {
  const auto i = static_cast<std::size_t>(boneNamed(skeleton, bone));
  const glm::vec3 bound(skeleton.bones[i].bindInWorld[3]);
  for (int frame = 0; static_cast<float>(frame) / 30.0f <= clip.duration; ++frame) {
    const Pose pose = samplePose(skeleton, clip, static_cast<float>(frame) / 30.0f);
    visit(glm::vec3(pose.boneInWorld[i][3]) - bound, pose, i);
  }
}

/// Steps in which one joint moves.
std::vector<MovementStep> stepsOf(const Skeleton& skeleton, const char* bone) {
  std::vector<MovementStep> found;
  for (const MovementStep& step : rangeOfMotionSteps(skeleton)) {
    for (const JointMovement& m : step) {
      if (m.bone == boneNamed(skeleton, bone)) found.push_back(step);
    }
  }
  return found;
}

glm::vec3 originAfter(const Skeleton& skeleton, const MovementStep& step, float share, const char* bone) {
  PoseOverrides turns;
  for (const JointMovement& m : step) {
    turns.set(m.bone, glm::angleAxis(share > 0 ? share * m.to : -share * m.from, m.axis));
  }
  const auto i = static_cast<std::size_t>(boneNamed(skeleton, bone));
  return glm::vec3(posed(skeleton, bindPose(skeleton), turns).boneInWorld[i][3] - skeleton.bones[i].bindInWorld[3]);
}

TEST(RangeOfMotion, ElbowsBendOnlyForwardsAndKneesOnlyBackwards) {
  for (const auto& [facing, isMirrored] : {std::pair{1.0f, false}, {-1.0f, false}, {1.0f, true}, {-1.0f, true}}) {
    const Skeleton skeleton = person(facing, isMirrored);
    const struct {
      const char* joint;
      const char* carried;
      float sign;
    } hinges[] = {{"LeftForeArm", "LeftHand", 1},
                  {"RightForeArm", "RightHand", 1},
                  {"LeftLeg", "LeftFoot", -1},
                  {"RightLeg", "RightFoot", -1}};
    for (const auto& hinge : hinges) {
      const auto steps = stepsOf(skeleton, hinge.joint);
      ASSERT_EQ(steps.size(), 1u) << hinge.joint;
      for (const JointMovement& m : steps[0]) EXPECT_EQ(m.from, 0.0f);
      for (const float share : {0.25f, 0.5f, 1.0f}) {
        const glm::vec3 moved = originAfter(skeleton, steps[0], share, hinge.carried);
        EXPECT_GT(hinge.sign * facing * moved.z, 0.05f) << hinge.joint << " facing " << facing;
      }
    }
  }
}

TEST(RangeOfMotion, SpinesBendForwardsArmsRiseAndLegsSpread) {
  for (const float facing : {1.0f, -1.0f}) {
    const Skeleton skeleton = person(facing);
    EXPECT_GT(facing * originAfter(skeleton, stepsOf(skeleton, "Spine")[0], 1.0f, "Head").z, 0.05f);
    const auto arm = stepsOf(skeleton, "LeftArm");
    ASSERT_EQ(arm.size(), 3u);
    EXPECT_GT(facing * originAfter(skeleton, arm[0], 1.0f, "LeftHand").z, 0.2f);
    EXPECT_GT(originAfter(skeleton, arm[1], 1.0f, "LeftHand").y, 0.2f);
    EXPECT_LT(originAfter(skeleton, arm[1], -1.0f, "LeftHand").y, -0.2f);
    EXPECT_LT(glm::length(originAfter(skeleton, arm[2], 1.0f, "LeftHand")), 1e-4f) << "a twist about the arm";
    const auto leg = stepsOf(skeleton, "RightUpLeg");
    ASSERT_EQ(leg.size(), 3u);
    EXPECT_GT(facing * originAfter(skeleton, leg[0], 1.0f, "RightFoot").z, 0.2f);
    EXPECT_LT(facing * originAfter(skeleton, leg[1], 1.0f, "RightFoot").x, -0.2f) << "outwards";
  }
}

TEST(RangeOfMotion, LeftAndRightMoveTogetherAsMirrorImages) {
  const Skeleton skeleton = person(1.0f);
  const AnimationClip clip = rangeOfMotion(skeleton);
  for (const auto& [left, right] : {std::pair{"LeftHand", "RightHand"}, std::pair{"LeftFoot", "RightFoot"},
                                    std::pair{"LeftForeArm", "RightForeArm"}}) {
    const auto l = static_cast<std::size_t>(boneNamed(skeleton, left));
    const auto r = static_cast<std::size_t>(boneNamed(skeleton, right));
    float moved = 0.0f;
    follow(skeleton, clip, left, [&](const glm::vec3& by, const Pose& pose, std::size_t) {
      // The spine and the head bend sideways on their own.
      if (bentBy(skeleton, pose, 1) > 1e-3f || bentBy(skeleton, pose, 2) > 1e-3f) return;
      const glm::vec3 a(pose.boneInWorld[l][3]);
      const glm::vec3 b(pose.boneInWorld[r][3]);
      EXPECT_LT(glm::length(b - glm::vec3(-a.x, a.y, a.z)), 1e-4f);
      moved = std::max(moved, glm::length(by));
    });
    EXPECT_GT(moved, 0.1f);
  }
}

TEST(JointRoles, AreRecognizedInManyNamingStyles) {
  const auto chain = [](std::initializer_list<const char*> names) {
    Skeleton skeleton;
    for (const char* name : names) {
      Bone bone;
      bone.name = name;
      bone.parent = static_cast<int>(skeleton.bones.size()) - 1;
      skeleton.bones.push_back(bone);
    }
    finishBones(skeleton);
    return jointRoles(skeleton);
  };
  using enum JointRole;
  const auto expectRoles = [&](std::initializer_list<const char*> names, std::vector<JointRole> roles) {
    EXPECT_EQ(chain(names), roles) << *names.begin() << " ... " << *(names.end() - 1);
  };
  expectRoles({"hips", "spine", "shoulder.L", "upper_arm.L", "forearm.L", "hand.L", "f_index.01.L"},
              {kStill, kTrunk, kCollar, kShoulder, kElbow, kWrist, kDigit});
  expectRoles({"mixamorig:Hips", "mixamorig:Spine2", "mixamorig:LeftShoulder", "mixamorig:LeftArm",
               "mixamorig:LeftForeArm", "mixamorig:LeftHand", "mixamorig:LeftHandThumb1"},
              {kStill, kTrunk, kCollar, kShoulder, kElbow, kWrist, kDigit});
  expectRoles({"Armature", "Hips", "UpperLeg.R", "LowerLeg.R", "Foot.R", "Toe.R", "Toe.R_end"},
              {kStill, kStill, kHip, kKnee, kAnkle, kDigit, kStill});
  expectRoles({"_rootJoint", "b_Root_00", "b_Hip_01", "b_LeftLeg01_015", "b_LeftLeg02_016", "b_LeftFoot01_017"},
              {kStill, kStill, kStill, kHip, kKnee, kAnkle});
  expectRoles({"root", "body_up", "hand_L", "socket_hand_L"}, {kStill, kTrunk, kShoulder, kStill});
  expectRoles({"root", "body_low", "hip_L", "leg_L"}, {kStill, kTrunk, kHip, kKnee});
  expectRoles({"hips", "tail.1", "tail.2"}, {kStill, kTail, kTail});
  expectRoles({"joint 0", "joint 1", "PoleTarget.L"}, {kStill, kFree, kStill});
}

TEST(RangeOfMotion, SwingsBothWaysTakeHalfAsLongAgain) {
  const Skeleton skeleton = person(1.0f);
  float frames = 0.0f;
  for (const MovementStep& step : rangeOfMotionSteps(skeleton)) {
    const bool bothWays = std::ranges::any_of(step, [](const auto& m) { return m.from < 0.0f && m.to > 0.0f; });
    frames += bothWays ? 45.0f : 30.0f;
  }
  EXPECT_NEAR(rangeOfMotion(skeleton).duration, frames / 30.0f, 1e-4f);
}

}  // namespace
}  // namespace sinew
