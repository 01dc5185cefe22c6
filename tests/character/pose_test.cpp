// tests/character/pose_test.cpp: channels, poses, bone names.
#include "sinew/character/pose.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "sinew/character/node_locals.h"

namespace sinew {
namespace {

Channel slide(Interpolation interpolation) {
  Channel channel;
  channel.interpolation = interpolation;
  channel.times = {1.0f, 2.0f, 4.0f};
  channel.values = {{0, 0, 0, 0}, {2, 0, 0, 0}, {2, 4, 0, 0}};
  return channel;
}

TEST(SampleChannel, HoldsBeforeFirstAndAfterLastKey) {
  for (const auto interpolation : {Interpolation::kStep, Interpolation::kLinear}) {
    const Channel channel = slide(interpolation);
    EXPECT_EQ(sampleChannel(channel, -5.0f), channel.values[0]);
    EXPECT_EQ(sampleChannel(channel, 9.0f), channel.values[2]);
  }
}

TEST(SampleChannel, StepHoldsAndLinearInterpolates) {
  EXPECT_EQ(sampleChannel(slide(Interpolation::kStep), 1.99f).x, 0.0f);
  EXPECT_EQ(sampleChannel(slide(Interpolation::kStep), 2.0f).x, 2.0f);
  EXPECT_FLOAT_EQ(sampleChannel(slide(Interpolation::kLinear), 3.0f).y, 2.0f);
}

TEST(SampleChannel, CubicSplineReproducesACubic) {
  // A Hermite spline reproduces x(t) = t^3 with its exact tangents.
  Channel channel;
  channel.interpolation = Interpolation::kCubicSpline;
  for (const float t : {0.0f, 0.5f, 2.0f}) {
    channel.times.push_back(t);
    const glm::vec4 tangent(3 * t * t, 0, 0, 0);
    channel.values.insert(channel.values.end(), {tangent, glm::vec4(t * t * t, 0, 0, 0), tangent});
  }
  for (float t = 0.0f; t <= 2.0f; t += 0.05f) EXPECT_NEAR(sampleChannel(channel, t).x, t * t * t, 1e-5f) << t;
}

TEST(SampleChannel, RotationsTakeTheShorterArcAndStayUnit) {
  Channel channel;
  channel.path = ChannelPath::kRotation;
  channel.times = {0.0f, 1.0f};
  const glm::quat from = glm::angleAxis(0.2f, glm::vec3(0, 0, 1));
  const glm::quat to = -glm::angleAxis(1.0f, glm::vec3(0, 0, 1));  // same rotation, other sign
  channel.values = {{from.x, from.y, from.z, from.w}, {to.x, to.y, to.z, to.w}};
  for (float t = 0.0f; t <= 1.0f; t += 0.125f) {
    const glm::vec4 v = sampleChannel(channel, t);
    EXPECT_NEAR(glm::length(v), 1.0f, 1e-6f);
    const float angle = 2.0f * std::atan2(std::abs(v.z), std::abs(v.w));
    EXPECT_NEAR(angle, 0.2f + 0.8f * t, 1e-4f) << t;
  }
}

Bone boneNamed(const std::string& name, int node, int parent) {
  Bone bone;
  bone.name = name;
  bone.node = node;
  bone.parent = parent;
  return bone;
}

Skeleton arm() {
  Skeleton skeleton;
  Node root{"Root", -1, {}};
  root.rest.scale = glm::vec3(0.01f);
  Node upper{"Upper", 0, {}};
  upper.rest.translation = {100, 0, 0};
  Node lower{"Lower", 1, {}};
  lower.rest.translation = {0, 200, 0};
  skeleton.nodes = {root, upper, lower};
  Bone a = boneNamed("Upper", 1, -1);
  a.bindInWorld = glm::translate(glm::mat4(1.0f), {1, 0, 0});
  Bone b = boneNamed("Lower", 2, 0);
  b.bindInWorld = glm::translate(glm::mat4(1.0f), {1, 2, 0});
  skeleton.bones = {a, b};
  finishBones(skeleton);
  return skeleton;
}

TEST(Pose, ComposesParentsAndClampsTime) {
  const Skeleton skeleton = arm();
  EXPECT_NEAR(glm::distance(glm::vec3(restPose(skeleton).boneInWorld[1][3]), glm::vec3(1, 2, 0)), 0.0f, 1e-6f);
  AnimationClip clip{"turn", 1.0f, {}};
  Channel turn;
  turn.node = 1;
  turn.path = ChannelPath::kRotation;
  turn.times = {0.0f, 1.0f};
  turn.values = {{0, 0, 0, 1}, {0, 0, std::sqrt(0.5f), std::sqrt(0.5f)}};
  clip.channels = {turn};
  for (const float time : {1.0f, 7.0f}) {
    const Pose pose = samplePose(skeleton, clip, time);
    EXPECT_NEAR(glm::distance(glm::vec3(pose.boneInWorld[1][3]), glm::vec3(-1, 0, 0)), 0.0f, 1e-5f);
  }
}

TEST(Pose, IsComposedFromLocalTransforms) {
  const Skeleton skeleton = arm();
  std::vector<LocalTransform> locals = restLocals(skeleton);
  EXPECT_EQ(poseFromLocals(skeleton, locals), restPose(skeleton));
  locals[1].rotation = glm::angleAxis(glm::radians(90.0f), glm::vec3(0, 0, 1));
  const Pose turned = poseFromLocals(skeleton, locals);
  EXPECT_NEAR(glm::distance(glm::vec3(turned.boneInWorld[0][3]), glm::vec3(1, 0, 0)), 0.0f, 1e-5f);
  EXPECT_NEAR(glm::distance(glm::vec3(turned.boneInWorld[1][3]), glm::vec3(-1, 0, 0)), 0.0f, 1e-5f);
  locals[2].scale = glm::vec3(3.0f);  // Only the last bone.
  const Pose grown = poseFromLocals(skeleton, locals);
  EXPECT_EQ(grown.boneInWorld[0], turned.boneInWorld[0]);
  EXPECT_NEAR(glm::length(glm::vec3(grown.boneInWorld[1][0])), 0.03f, 1e-6f);
}

TEST(Bones, TipsPointAtChildrenOrContinueTheChain) {
  const Skeleton skeleton = arm();
  EXPECT_NEAR(glm::distance(skeleton.bones[0].tip, glm::vec3(0, 2, 0)), 0.0f, 1e-6f);
  EXPECT_NEAR(glm::distance(skeleton.bones[1].tip, glm::vec3(0, 1, 0)), 0.0f, 1e-6f);
}

TEST(Bones, AreFoundByUniqueNameOrPathOnly) {
  Skeleton skeleton = arm();
  skeleton.bones.push_back(boneNamed("Lower", 2, 0));
  skeleton.bones.push_back(boneNamed("Hand", 2, 1));
  finishBones(skeleton);
  EXPECT_EQ(skeleton.findBone("Lower"), std::nullopt) << "two of that name";
  EXPECT_EQ(skeleton.findBone("Hand"), 3);
  EXPECT_EQ(skeleton.findBone("nobody"), std::nullopt);
  for (int bone = 0; bone < 4; ++bone) EXPECT_EQ(skeleton.findBone(skeleton.fileName(bone)), bone);
}

}  // namespace
}  // namespace sinew
