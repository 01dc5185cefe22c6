// tests/geometry/nearest_name_test.cpp: suggestions for a misspelled word, or none.
#include "core/geometry/nearest_name.h"

#include <gtest/gtest.h>

namespace sinew {
namespace {

const std::vector<std::string> kBones{"upper_arm.L", "upper_arm.R",   "forearm.L",
                                      "hand.L",      "Armature|Walk", "Range of motion"};

TEST(NearestName, IgnoresCaseSeparatorsAndTypos) {
  EXPECT_EQ(nearestName("UpperArm_L", kBones), "upper_arm.L");
  EXPECT_EQ(nearestName("upper arm r", kBones), "upper_arm.R");
  EXPECT_EQ(nearestName("froearm.L", kBones), "forearm.L") << "two letters swapped";
  EXPECT_EQ(nearestName("hnd.L", kBones), "hand.L") << "one missing";
  EXPECT_EQ(nearestName("hannd.L", kBones), "hand.L") << "one too many";
  EXPECT_EQ(nearestName("range of motion", kBones), "Range of motion");
}

TEST(NearestName, FindsPartsOfNames) {
  EXPECT_EQ(nearestName("walk", kBones), "Armature|Walk");
  EXPECT_EQ(nearestName("forearm", kBones), "forearm.L");
}

TEST(NearestName, ReturnsNothingIfNothingIsNear) {
  for (const char* word : {"", "...", "tail", "x", "spine.002", "zz"}) EXPECT_EQ(nearestName(word, kBones), "") << word;
  EXPECT_EQ(nearestName("hand", {}), "");
  EXPECT_EQ(nearestName("b", {"a"}), "") << "of one letter none is right";
  EXPECT_EQ(nearestName(std::string(10000, 'a'), {std::string(10000, 'a')}), "") << "no name is as long";
}

TEST(NearestName, FirstWinsATie) { EXPECT_EQ(nearestName("upper_arm.X", kBones), "upper_arm.L"); }

TEST(DidYouMean, FormatsASuggestion) {
  EXPECT_EQ(didYouMean("hnd.L", kBones), "; did you mean \"hand.L\"?");
  EXPECT_EQ(didYouMean("tail", kBones), "");
}

}  // namespace
}  // namespace sinew
