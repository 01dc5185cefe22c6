// tests/character/pose_override_test.cpp: rotated joints: their descendants move rigidly, nothing else moves.

#include "core/character/pose_override.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

namespace sinew {
namespace {

constexpr int kTrials = 60;
constexpr int kBones = 9;

class Chance {
 public:
  explicit Chance(unsigned seed) : engine_(seed) {}
  float in(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }
  glm::vec3 vector() { return {in(-1, 1), in(-1, 1), in(-1, 1)}; }
  glm::quat rotation() {
    const glm::vec3 axis = normalizeOr(vector(), glm::vec3(1, 0, 0));
    return glm::angleAxis(in(0.2f, 2.9f), axis);
  }

 private:
  std::mt19937 engine_;
};

enum class Scale { kNone, kEven, kUneven, kMirrored };

glm::mat4 randomMatrix(Chance& chance, Scale scale) {
  glm::mat4 m = glm::translate(glm::mat4(1.0f), chance.vector()) * glm::mat4_cast(chance.rotation());
  if (scale == Scale::kEven) m = glm::scale(m, glm::vec3(chance.in(0.01f, 30.0f)));
  if (scale == Scale::kUneven) m = glm::scale(m, {chance.in(0.3f, 3), chance.in(0.3f, 3), chance.in(0.3f, 3)});
  if (scale == Scale::kMirrored) m = glm::scale(m, {-1.3f, 1.3f, 1.3f});
  return m;
}

/// A random tree of bones, each with its own matrix relative to its parent; bind pose and current pose differ.
struct Scene {
  Skeleton skeleton;
  Pose moment;
};

Scene randomScene(Chance& chance, Scale scale) {
  Scene scene;
  for (int i = 0; i < kBones; ++i) {
    Bone bone;
    bone.name = "b" + std::to_string(i);
    bone.node = i;
    bone.parent = i == 0 ? -1 : chance.below(i);
    const auto at = [&](const glm::mat4& local, const glm::mat4& parent) { return parent * local; };
    const auto p = static_cast<std::size_t>(std::max(bone.parent, 0));
    const glm::mat4 none(1.0f);
    // Only a few bones are scaled: products of many would flatten their descendants.
    const Scale own = i % 3 == 0 ? scale : Scale::kNone;
    bone.bindInWorld = at(randomMatrix(chance, own), i == 0 ? none : scene.skeleton.bones[p].bindInWorld);
    scene.moment.boneInWorld.push_back(at(randomMatrix(chance, own), i == 0 ? none : scene.moment.boneInWorld[p]));
    scene.skeleton.bones.push_back(bone);
  }
  finishBones(scene.skeleton);
  return scene;
}

bool isUnder(const Skeleton& skeleton, int bone, int ancestor) {
  for (int i = bone; i >= 0; i = skeleton.bones[static_cast<std::size_t>(i)].parent) {
    if (i == ancestor) return true;
  }
  return false;
}

double largest(const glm::dmat4& m) {
  double most = 0.0;
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) most = std::max(most, std::abs(m[c][r]));
  }
  return most;
}

void expectNear(const glm::mat4& a, const glm::mat4& b, const std::string& what) {
  EXPECT_LT(largest(glm::dmat4(a) - glm::dmat4(b)), 1e-4 * std::max(1.0, largest(glm::dmat4(b)))) << what;
}

class RotatedJoints : public testing::TestWithParam<Scale> {};
INSTANTIATE_TEST_SUITE_P(Scales, RotatedJoints,
                         testing::Values(Scale::kNone, Scale::kEven, Scale::kUneven, Scale::kMirrored));

TEST_P(RotatedJoints, MoveOnlyTheirDescendantsRigidly) {
  Chance chance(11);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Scene scene = randomScene(chance, GetParam());
    const int bone = chance.below(kBones);
    PoseOverrides overrides;
    overrides.set(bone, chance.rotation());
    const Pose after = posed(scene.skeleton, scene.moment, overrides);
    const auto& before = scene.moment.boneInWorld;
    const auto index = static_cast<std::size_t>(bone);
    const glm::dmat4 moved = glm::dmat4(after.boneInWorld[index]) * glm::inverse(glm::dmat4(before[index]));
    const glm::dmat3 rotation(moved);
    EXPECT_LT(largest(glm::dmat4(glm::transpose(rotation) * rotation) - glm::dmat4(1.0)), 2e-4) << "no rotation";
    EXPECT_GT(glm::determinant(rotation), 0.0);
    EXPECT_GT(largest(moved - glm::dmat4(1.0)), 0.01) << "it turned";
    const glm::dvec4 origin(before[index][3]);
    EXPECT_LT(glm::length(moved * origin - origin), 1e-3) << "the joint stays";
    for (int i = 0; i < kBones; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (isUnder(scene.skeleton, i, bone)) {
        expectNear(after.boneInWorld[k], glm::mat4(moved * glm::dmat4(before[k])), "rides along");
      } else {
        EXPECT_EQ(after.boneInWorld[k], before[k]) << "bit for bit";
      }
    }
  }
}

TEST(PoseOverrides, RotationIsLocalUnderUniformScale) {
  for (const Scale scale : {Scale::kNone, Scale::kEven}) {
    Chance chance(12);
    for (int trial = 0; trial < kTrials; ++trial) {
      const Scene scene = randomScene(chance, scale);
      PoseOverrides overrides;
      const int bone = chance.below(kBones);
      const glm::quat turn = chance.rotation();
      overrides.set(bone, turn);
      const auto i = static_cast<std::size_t>(bone);
      const Pose after = posed(scene.skeleton, scene.moment, overrides);
      expectNear(after.boneInWorld[i], scene.moment.boneInWorld[i] * glm::mat4_cast(turn), "B q");
    }
  }
}

TEST(PoseOverrides, ParentsRotateBeforeChildren) {
  Chance chance(13);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Scene scene = randomScene(chance, Scale::kUneven);
    const int child = 1 + chance.below(kBones - 1);
    const int parent = scene.skeleton.bones[static_cast<std::size_t>(child)].parent;
    PoseOverrides first;
    PoseOverrides second;
    PoseOverrides both;
    const glm::quat a = chance.rotation();
    const glm::quat b = chance.rotation();
    first.set(parent, a);
    second.set(child, b);
    both.set(child, b);
    both.set(parent, a);
    const Pose inTwo = posed(scene.skeleton, posed(scene.skeleton, scene.moment, first), second);
    const Pose atOnce = posed(scene.skeleton, scene.moment, both);
    for (std::size_t i = 0; i < kBones; ++i) expectNear(atOnce.boneInWorld[i], inTwo.boneInWorld[i], "order");
  }
}

TEST(PoseOverrides, IdentityRotationChangesNothing) {
  Chance chance(14);
  const Scene scene = randomScene(chance, Scale::kUneven);
  PoseOverrides overrides;
  overrides.set(2, glm::quat(1, 0, 0, 0));
  overrides.set(3, glm::quat(-1, 0, 0, 0));
  overrides.set(4, glm::quat(0, 0, 0, 0));
  overrides.set(5, glm::quat(std::nanf(""), 0, 0, 0));
  EXPECT_TRUE(overrides.isEmpty());
  overrides.set(6, chance.rotation());
  EXPECT_EQ(overrides.turns.size(), 1u);
  overrides.set(6, glm::quat(1, 0, 0, 0));
  EXPECT_TRUE(overrides.isEmpty());
  EXPECT_EQ(posed(scene.skeleton, scene.moment, overrides).boneInWorld, scene.moment.boneInWorld);
  overrides.set(100, chance.rotation());  // From a longer skeleton.
  EXPECT_EQ(posed(scene.skeleton, scene.moment, overrides).boneInWorld, scene.moment.boneInWorld);
}

TEST(PoseOverrides, RotationsAreSortedAndNormalized) {
  PoseOverrides overrides;
  for (const int bone : {5, 1, 3, 1}) overrides.set(bone, glm::quat(2.0f, 0.0f, static_cast<float>(bone), 0.0f));
  ASSERT_EQ(overrides.turns.size(), 3u);
  for (std::size_t i = 1; i < 3; ++i) EXPECT_LT(overrides.turns[i - 1].bone, overrides.turns[i].bone);
  for (const JointTurn& turn : overrides.turns) EXPECT_NEAR(glm::length(turn.turn), 1.0f, 1e-6f);
  EXPECT_EQ(overrides.turnOf(2), glm::quat(1, 0, 0, 0));
  EXPECT_EQ(overrides.turnOf(5), overrides.turns[2].turn);
}

TEST(PoseOverrides, FlattenedBonesStayFinite) {
  Chance chance(15);
  for (int trial = 0; trial < kTrials; ++trial) {
    Scene scene = randomScene(chance, Scale::kNone);
    scene.moment.boneInWorld[3] = glm::scale(scene.moment.boneInWorld[3], {1, trial % 2 ? 0 : 1, 0});
    scene.moment.boneInWorld[4] = glm::scale(scene.moment.boneInWorld[4], glm::vec3(0));
    PoseOverrides overrides;
    for (int bone = 0; bone < kBones; ++bone) overrides.set(bone, chance.rotation());
    for (const TurnsFrom from : {TurnsFrom::kMoment, TurnsFrom::kBindPose}) {
      overrides.from = from;
      for (const glm::mat4& m : posed(scene.skeleton, scene.moment, overrides).boneInWorld) EXPECT_TRUE(isFinite(m));
    }
  }
}

TEST_P(RotatedJoints, HeldJointsIgnoreTheClip) {
  Chance chance(16);
  for (int trial = 0; trial < kTrials; ++trial) {
    Scene scene = randomScene(chance, GetParam());
    const int bone = 1 + chance.below(kBones - 1);
    const auto i = static_cast<std::size_t>(bone);
    const auto parent = static_cast<std::size_t>(scene.skeleton.bones[i].parent);
    PoseOverrides overrides;
    overrides.from = TurnsFrom::kBindPose;
    overrides.set(bone, chance.rotation());
    const auto attitude = [&] {
      const Pose pose = posed(scene.skeleton, scene.moment, overrides);
      return glm::transpose(turnFrame(pose.boneInWorld[parent])) * turnFrame(pose.boneInWorld[i]);
    };
    const glm::mat3 before = attitude();
    const glm::mat3 bound = glm::transpose(turnFrame(scene.skeleton.bones[parent].bindInWorld)) *
                            turnFrame(scene.skeleton.bones[i].bindInWorld) * glm::mat3_cast(overrides.turnOf(bone));
    expectNear(glm::mat4(before), glm::mat4(bound), "bind pose and the turn");
    scene.moment.boneInWorld[i] = scene.moment.boneInWorld[i] * glm::mat4_cast(chance.rotation());
    expectNear(glm::mat4(attitude()), glm::mat4(before), "the clip's rotation counts no more");
  }
}

TEST_P(RotatedJoints, ChangingTheBaseKeepsTheCurrentPose) {
  Chance chance(17);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Scene scene = randomScene(chance, GetParam());
    PoseOverrides overrides;
    for (int i = 0; i < 4; ++i) overrides.set(chance.below(kBones), chance.rotation());
    const Pose before = posed(scene.skeleton, scene.moment, overrides);
    const PoseOverrides held = startingFrom(TurnsFrom::kBindPose, scene.skeleton, scene.moment, overrides);
    const PoseOverrides free = startingFrom(TurnsFrom::kMoment, scene.skeleton, scene.moment, held);
    EXPECT_EQ(held.from, TurnsFrom::kBindPose);
    EXPECT_EQ(free.from, TurnsFrom::kMoment);
    for (std::size_t i = 0; i < kBones; ++i) {
      expectNear(posed(scene.skeleton, scene.moment, held).boneInWorld[i], before.boneInWorld[i], "held");
      expectNear(posed(scene.skeleton, scene.moment, free).boneInWorld[i], before.boneInWorld[i], "and back");
    }
  }
}

/// A trunk with an arm on either side, mirrored across x = 0; frames of the right arm rotated randomly.
Skeleton twoArms(Chance& chance) {
  Skeleton skeleton;
  const auto add = [&](const char* name, int parent, const glm::vec3& origin) {
    Bone bone;
    bone.name = name;
    bone.node = static_cast<int>(skeleton.bones.size());
    bone.parent = parent;
    bone.bindInWorld = glm::translate(glm::mat4(1.0f), origin) * glm::mat4_cast(chance.rotation());
    skeleton.bones.push_back(bone);
  };
  add("trunk", -1, {0, 1, 0});
  add("arm.L", 0, {0.3f, 1.4f, 0});
  add("fore.L", 1, {0.7f, 1.5f, 0.1f});
  add("arm.R", 0, {-0.3f, 1.4f, 0});
  add("fore.R", 3, {-0.7f, 1.5f, 0.1f});
  finishBones(skeleton);
  return skeleton;
}

TEST(PoseOverrides, MirroredPoseIsMirroredInTheWorld) {
  constexpr int kTwins[] = {0, 3, 4, 1, 2};
  Chance chance(18);
  for (int trial = 0; trial < kTrials; ++trial) {
    const Skeleton skeleton = twoArms(chance);
    PoseOverrides overrides;
    for (int bone = 0; bone < 5; ++bone) overrides.set(bone, chance.rotation());
    const PoseOverrides mirrored = mirroredPose(overrides, skeleton, kTwins, {1, 0, 0});
    const Pose a = posed(skeleton, bindPose(skeleton), overrides);
    const Pose b = posed(skeleton, bindPose(skeleton), mirrored);
    for (std::size_t i = 0; i < 5; ++i) {
      const glm::vec3 here(a.boneInWorld[i][3]);
      const glm::vec3 there(b.boneInWorld[static_cast<std::size_t>(kTwins[i])][3]);
      EXPECT_LT(glm::length(there - glm::vec3(-here.x, here.y, here.z)), 1e-5f) << i;
    }
    const PoseOverrides back = mirroredPose(mirrored, skeleton, kTwins, {1, 0, 0});
    for (int bone = 0; bone < 5; ++bone) {
      EXPECT_GT(std::abs(glm::dot(back.turnOf(bone), overrides.turnOf(bone))), 1.0f - 1e-5f);
    }
  }
}

TEST(RepeatedPoseOverride, IsUnchangedBitForBit) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> part(-1.0f, 1.0f);
  for (int i = 0; i < 1000; ++i) {
    PoseOverrides first;
    first.set(0, glm::quat(part(random), part(random), part(random), part(random)));
    PoseOverrides again = first;
    again.set(0, first.turnOf(0));
    ASSERT_EQ(again, first);
  }
}

TEST(PoseOverrides, MirroringKeepsTurnsOfBonesWithoutTwins) {
  constexpr int kTwins[] = {-1, 3, 4, 1, 2};
  Chance chance(19);
  const Skeleton skeleton = twoArms(chance);
  PoseOverrides overrides;
  overrides.set(0, chance.rotation());
  overrides.set(1, chance.rotation());
  const PoseOverrides mirrored = mirroredPose(overrides, skeleton, kTwins, {1, 0, 0});
  EXPECT_EQ(mirrored.turnOf(0), overrides.turnOf(0));
  EXPECT_EQ(mirrored.turns.size(), 2u);
}

}  // namespace
}  // namespace sinew
