// tests/character/bone_segments_test.cpp: closest points of segments, and segments of bones.
#include "core/character/bone_segments.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew {
namespace {

glm::vec3 anyPoint(test::Random& random) {
  return {random.uniform(-2.0f, 2.0f), random.uniform(-2.0f, 2.0f), random.uniform(-2.0f, 2.0f)};
}

TEST(Segment, ClosestPointIsClosest) {
  test::Random random(3);
  int beyond = 0;
  for (int round = 0; round < 500; ++round) {
    const Segment segment{anyPoint(random), anyPoint(random)};
    const glm::vec3 point = anyPoint(random);
    float nearest = std::numeric_limits<float>::infinity();
    for (int i = 0; i <= 1000; ++i) {
      const float t = static_cast<float>(i) / 1000.0f;
      nearest = std::min(nearest, glm::distance(point, segment.from + t * segment.along));
    }
    EXPECT_LE(segment.distance(point), nearest + 1e-6f);
    EXPECT_GE(segment.distance(point), nearest - 1e-3f * glm::length(segment.along));
    const float t = segment.parameter(point);
    EXPECT_NEAR(glm::dot(segment.from + t * segment.along - point, segment.along), 0.0f, 1e-4f) << "a foot is square";
    if (t < 0.0f || t > 1.0f) ++beyond;
    EXPECT_EQ(segment.closestTo(point), std::clamp(t, 0.0f, 1.0f));
  }
  EXPECT_GT(beyond, 100);
}

TEST(Segment, ZeroLengthSegmentIsAPoint) {
  const Segment point{{1, 2, 3}, {0, 0, 0}};
  EXPECT_EQ(point.parameter({9, 9, 9}), 0.0f);
  EXPECT_FLOAT_EQ(point.distance({1, 2, 5}), 2.0f);
}

TEST(BoneSegments, ConnectToChildrenOrElseToTheTip) {
  const auto body = test::makeTwoLegged();
  const Skeleton& skeleton = body->skeleton;
  const Pose pose = samplePose(skeleton, body->clips[0], 0.7f);
  std::vector<int> segmentsOfBone(skeleton.bones.size(), 0);
  for (const BoneSegment& segment : boneSegments(skeleton, pose)) {
    const auto bone = static_cast<std::size_t>(segment.bone);
    const auto end = static_cast<std::size_t>(segment.endBone);
    ++segmentsOfBone[bone];
    EXPECT_EQ(segment.head, glm::vec3(pose.boneInWorld[bone][3]));
    if (bone != end) {
      EXPECT_EQ(skeleton.bones[end].parent, segment.bone);
      EXPECT_EQ(segment.tail, glm::vec3(pose.boneInWorld[end][3]));
    } else {
      EXPECT_EQ(segment.tail, glm::vec3(pose.boneInWorld[bone] * glm::vec4(skeleton.bones[bone].tip, 1.0f)));
    }
  }
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    EXPECT_EQ(segmentsOfBone[b], std::max(1, static_cast<int>(skeleton.bones[b].children.size())));
  }
}

}  // namespace
}  // namespace sinew
