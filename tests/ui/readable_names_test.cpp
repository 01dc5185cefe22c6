// tests/ui/readable_names_test.cpp: names that no font can show become numbers, in lists only.

#include "app/ui/code_points.h"

#include <gtest/gtest.h>

#include "app/document/shown_names.h"

namespace sinew::app {
namespace {

bool latinAlone(char32_t c) { return c < 0x250; }

/// Simulates a machine with Latin fonts only during its lifetime.
struct LatinMachine {
  LatinMachine() { setGlyphs(latinAlone); }
  ~LatinMachine() { setGlyphs({}); }
};

TEST(ReadableNames, DisplayableNamesAreUnchanged) {
  for (const char* name : {"", "Arm.L", "Bras gauche é", "##", "\xff"}) {
    EXPECT_EQ(readable(name, "bone 3", [](char32_t) { return true; }), name);
    EXPECT_EQ(readable(name, "bone 3", {}), name);
  }
  EXPECT_EQ(readable("左腕", "bone 3", [](char32_t) { return true; }), "左腕");
}

TEST(ReadableNames, NumberReplacesMissingLetters) {
  EXPECT_EQ(readable("左腕", "bone 3", latinAlone), "bone 3");
  EXPECT_EQ(readable("腕.L", "bone 3", latinAlone), "bone 3.L");
  EXPECT_EQ(readable("左足_IK_先", "bone 3", latinAlone), "bone 3_IK_");
  EXPECT_EQ(readable("ذراع أيسر", "bone 3", latinAlone), "bone 3 ");
}

TEST(ReadableNames, AllRemainingLettersHaveGlyphs) {
  for (const char* name : {"左腕", "腕.L", "a右b左c", "팔 1", "\xe5\xb7"}) {
    for (const char32_t c : codePoints(readable(name, "bone 3", latinAlone))) EXPECT_TRUE(latinAlone(c)) << name;
  }
}

TEST(ReadableNames, BonesAreNumberedFromOne) {
  Skeleton skeleton;
  for (const char* name : {"Hips", "左腕", "右腕", "腕.L"}) {
    Bone bone;
    bone.name = name;
    skeleton.bones.push_back(bone);
  }
  const std::vector<std::string> names = shownBoneNames(skeleton);
  EXPECT_EQ(names, (std::vector<std::string>{"Hips", "左腕", "右腕", "腕.L"}));
  const LatinMachine machine;
  EXPECT_EQ(shownBoneNames(skeleton), (std::vector<std::string>{"Hips", "bone 2", "bone 3", "bone 4.L"}));
  EXPECT_EQ(shortBoneNames(skeleton), names) << "what new muscles are called";
}

TEST(ReadableNames, MusclesAndGroupsAreNumbered) {
  Rig rig;
  rig.primitives.resize(2);
  rig.primitives[0].name = "Biceps";
  rig.primitives[1].name = "上腕二頭筋";
  rig.groups.resize(1);
  rig.groups[0].name = "腕";
  EXPECT_EQ(shownMuscleName(rig, 1), "上腕二頭筋");
  const LatinMachine machine;
  EXPECT_EQ(shownMuscleName(rig, 0), "Biceps");
  EXPECT_EQ(shownMuscleName(rig, 1), "muscle 2");
  EXPECT_EQ(shownGroupName(rig, 0), "group 1");
  EXPECT_EQ(rig.primitives[1].name, "上腕二頭筋");
}

}  // namespace
}  // namespace sinew::app
