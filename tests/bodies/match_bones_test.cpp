// tests/bodies/match_bones_test.cpp: whether two files have the same bones.
#include "core/bodies/transfer_clips.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/characters/named_bodies.h"

namespace sinew {
namespace {

TEST(SameBones, HaveEqualPathsAndBindPoses) {
  std::map<std::string, std::string> slots;
  const Character body = test::characterOf(test::namedBodies().front(), test::Stance::kArmsLevel, slots);
  const Skeleton& bones = body.skeleton;
  EXPECT_TRUE(haveSameBones(bones, bones, body.height));
  Skeleton other = bones;
  std::ranges::reverse(other.bones);
  EXPECT_TRUE(haveSameBones(other, bones, body.height)) << "in any order";
  other = bones;
  other.bones.back().path += "x";
  EXPECT_FALSE(haveSameBones(other, bones, body.height));
  other = bones;
  other.bones.pop_back();
  EXPECT_FALSE(haveSameBones(other, bones, body.height));
  EXPECT_FALSE(haveSameBones(bones, other, body.height));
  for (const float moved : {1e-5f, 0.05f}) {
    other = bones;
    other.bones.back().bindInWorld[3].x += moved * body.height;
    EXPECT_EQ(haveSameBones(other, bones, body.height), moved < 1e-3f) << moved;
  }
  other = bones;
  other.bones.back().bindInWorld = glm::rotate(other.bones.back().bindInWorld, 0.1f, {0.0f, 0.0f, 1.0f});
  EXPECT_FALSE(haveSameBones(other, bones, body.height));
}

}  // namespace
}  // namespace sinew
