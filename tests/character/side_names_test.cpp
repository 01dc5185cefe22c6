// tests/character/side_names_test.cpp: side markers in names, as riggers write them.

#include "core/character/bone_names.h"

#include <gtest/gtest.h>

#include <array>

namespace sinew {
namespace {

struct Named {
  const char* left;
  const char* right;
};

constexpr std::array kPairs{Named{"thigh L", "thigh R"},
                            Named{"L_arm", "R_arm"},
                            Named{"hand.l", "hand.r"},
                            Named{"hand.l.001", "hand.r.001"},
                            Named{"LeftArm", "RightArm"},
                            Named{"b_LeftLeg01_015", "b_RightLeg01_015"},
                            Named{"mixamorig:LeftUpLeg", "mixamorig:RightUpLeg"},
                            Named{"Bip01 L Thigh", "Bip01 R Thigh"},
                            Named{"handL", "handR"},
                            Named{"LArm", "RArm"},
                            Named{"armleft", "armright"},
                            Named{"LEFT_ARM", "RIGHT_ARM"},
                            Named{"leg_FL", "leg_FR"},
                            Named{"paw-bl-2", "paw-br-2"},
                            Named{"eye_lf", "eye_rt"},
                            Named{"L1", "R1"},
                            Named{"\xc3\xa4rm L", "\xc3\xa4rm R"}};

TEST(SideNames, CounterpartsNameEachOther) {
  for (const Named& pair : kPairs) {
    EXPECT_EQ(mirroredName(pair.left), pair.right);
    EXPECT_EQ(mirroredName(pair.right), pair.left);
    ASSERT_EQ(sideMarkers(pair.left).size(), 1u) << pair.left;
    EXPECT_EQ(sideMarkers(pair.left)[0].side, Side::kLeft) << pair.left;
    EXPECT_EQ(sideMarkers(pair.right)[0].side, Side::kRight) << pair.right;
    EXPECT_EQ(sideNamed(pair.left), Side::kLeft) << pair.left;
    EXPECT_EQ(sideNamed(pair.right), Side::kRight) << pair.right;
  }
}

TEST(SideNames, LettersInsideWordsAreNotMarkers) {
  for (const char* name :
       {"spine", "Bright", "upright", "cleft palate", "Root", "tail", "skull", "", "l\xc3\xa4ng", "12", "pelvis.001"}) {
    EXPECT_FALSE(mirroredName(name)) << name;
    EXPECT_TRUE(sideMarkers(name).empty()) << name;
    EXPECT_FALSE(sideNamed(name)) << name;
  }
}

TEST(SideNames, SeveralMarkersAreAmbiguous) {
  EXPECT_FALSE(mirroredName("L_arm_R"));
  EXPECT_EQ(sideMarkers("L_arm_R").size(), 2u);
  EXPECT_FALSE(sideNamed("L_arm_R"));
  // A whole word takes precedence over letters.
  EXPECT_EQ(mirroredName("LeftHand_r"), "RightHand_r");
}

}  // namespace
}  // namespace sinew
