// tests/symmetry/motion_clip_test.cpp: the range of motion joins the clips, once, and never in place of a file's own.

#include "core/symmetry/motion_clip.h"

#include <gtest/gtest.h>

#include "core/character/skin_bones.h"
#include "core/skeleton/range_of_motion.h"
#include "tests/support/characters/synthetic_characters.h"

namespace sinew {
namespace {

TEST(MotionClip, JoinsAtTheEndAndLeavesTheRestAlone) {
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

TEST(MotionClip, AFilesOwnClipOfThatNameWins) {
  Character own = *test::makeTwoLegged();
  own.clips.front().name = kRangeOfMotionName;
  const auto character = std::make_shared<const Character>(own);
  EXPECT_EQ(withRangeOfMotion(character), character);
  EXPECT_FALSE(character->clips[static_cast<std::size_t>(findClip(*character, kRangeOfMotionName))].turnsBindPose);
}

TEST(MotionClip, IsMadeOnlyWhenAskedForByName) {
  const auto character = test::makeLimb();
  EXPECT_EQ(withClipNamed(character, ""), character);
  EXPECT_EQ(withClipNamed(character, "bend"), character);
  EXPECT_NE(withClipNamed(character, std::string(kRangeOfMotionName)), character);
}

TEST(MotionClip, NothingToTurnIsNoClip) {
  Character lone = *test::makeLimb();
  for (Influence& influence : lone.mesh.influences) influence.binding = 0;  // All skin follows the root.
  const auto character = std::make_shared<const Character>(lone);
  EXPECT_EQ(withRangeOfMotion(character), character);
  const std::vector<bool> skin = bonesWithSkin(*character);
  EXPECT_TRUE(skin[0]);
  EXPECT_FALSE(skin[1]);
}

}  // namespace
}  // namespace sinew
