// tests/document/visibility_test.cpp: eye, lock, solo and isolation, and what becomes of them when the rig changes.

#include "app/document/visibility.h"

#include <gtest/gtest.h>

#include "core/rig/rig_edit.h"

namespace sinew::app {
namespace {

Bone boneNamed(const std::string& name, int parent) {
  Bone bone;
  bone.name = name;
  bone.parent = parent;
  return bone;
}

/// hip, knee below it, arm apart; a muscle on each, one on a bone that is not there.
class VisibilityTest : public testing::Test {
 protected:
  void SetUp() override {
    skeleton.nodes.resize(3);
    skeleton.bones = {boneNamed("hip", -1), boneNamed("knee", 0), boneNamed("arm", -1)};
    for (int b = 0; b < 3; ++b) skeleton.bones[static_cast<std::size_t>(b)].node = b;
    finishBones(skeleton);
    for (const char* bone : {"hip", "knee", "arm", "tail"}) {
      Primitive primitive;
      primitive.name = std::string("on ") + bone;
      primitive.bone = bone;
      rig = addPrimitive(rig, primitive).value();
    }
  }
  [[nodiscard]] std::vector<int> hidden() const { return hiddenPrimitives(visibility, rig, skeleton); }
  [[nodiscard]] std::string path(int bone) const { return skeleton.bones[static_cast<std::size_t>(bone)].path; }

  Skeleton skeleton;
  Rig rig;
  Visibility visibility;
};

TEST_F(VisibilityTest, BonesOfEachAreThoseThatFindBoneFinds) {
  skeleton.bones.push_back(boneNamed("arm", 0));
  skeleton.nodes.resize(4);
  skeleton.bones.back().node = 3;
  finishBones(skeleton);
  Primitive primitive;
  primitive.name = "by path";
  primitive.bone = skeleton.bones.back().path;
  rig = addPrimitive(rig, primitive).value();
  const std::vector<int> bones = boneOfEach(rig, skeleton);
  ASSERT_EQ(bones.size(), rig.primitives.size());
  for (std::size_t i = 0; i < bones.size(); ++i) {
    EXPECT_EQ(bones[i], skeleton.findBone(rig.primitives[i].bone).value_or(-1)) << rig.primitives[i].bone;
  }
}

TEST_F(VisibilityTest, ABoneSpeaksForWhatIsOnItAndBelow) {
  EXPECT_TRUE(hidden().empty());
  visibility.setBone(Mark::kHidden, path(0), true);
  EXPECT_EQ(hidden(), (std::vector<int>{0, 1}));
  visibility.setBone(Mark::kHidden, path(0), false);
  visibility.setMuscle(Mark::kHidden, "on arm", true);
  EXPECT_EQ(hidden(), (std::vector<int>{2}));
  visibility.setBone(Mark::kLocked, path(1), true);
  EXPECT_FALSE(isPickable(visibility, rig, skeleton, 1));
  EXPECT_TRUE(isPickable(visibility, rig, skeleton, 0));
  EXPECT_FALSE(isPickable(visibility, rig, skeleton, 2));
}

TEST_F(VisibilityTest, SoloLeavesItselfAlone) {
  visibility.setMuscle(Mark::kSolo, "on tail", true);
  EXPECT_EQ(hidden(), (std::vector<int>{0, 1, 2}));
  visibility.setBone(Mark::kSolo, path(1), true);
  EXPECT_EQ(hidden(), (std::vector<int>{0, 2}));
  visibility.setMuscle(Mark::kHidden, "on knee", true);
  EXPECT_EQ(hidden(), (std::vector<int>{0, 1, 2}));
}

TEST_F(VisibilityTest, IsolationAndBareCutFurther) {
  visibility.isolated = std::set<std::string>{"on hip", "on arm"};
  EXPECT_EQ(hidden(), (std::vector<int>{1, 3}));
  visibility.bare = true;
  EXPECT_EQ(hidden().size(), 4u);
}

TEST_F(VisibilityTest, MarksGoWithARenamedMuscleAndComeBackWithUndo) {
  visibility.setMuscle(Mark::kHidden, "on arm", true);
  const Rig renamed = renamePrimitive(rig, 2, "biceps").value();
  followRig(visibility, rig, renamed, false);
  EXPECT_EQ(hiddenPrimitives(visibility, renamed, skeleton), (std::vector<int>{2}));
  followRig(visibility, renamed, rig, true);
  EXPECT_EQ(hidden(), (std::vector<int>{2}));
}

TEST_F(VisibilityTest, WhatUndoBringsBackIsAsItWasLeftAndWhatIsNewIsSeen) {
  visibility.setMuscle(Mark::kHidden, "on tail", true);
  const Rig without = removePrimitives(rig, std::vector<int>{3});
  followRig(visibility, rig, without, false);
  Visibility undone = visibility;
  followRig(undone, without, rig, true);
  EXPECT_EQ(hiddenPrimitives(undone, rig, skeleton), (std::vector<int>{3}));
  Visibility again = visibility;
  followRig(again, without, rig, false);
  EXPECT_TRUE(hiddenPrimitives(again, rig, skeleton).empty());
}

TEST_F(VisibilityTest, ANewMuscleIsSeenAmongTheIsolated) {
  visibility.isolated = std::set<std::string>{"on hip"};
  Primitive primitive;
  primitive.name = "new";
  primitive.bone = "arm";
  const Rig grown = addPrimitive(rig, primitive).value();
  followRig(visibility, rig, grown, false);
  EXPECT_EQ(hiddenPrimitives(visibility, grown, skeleton), (std::vector<int>{1, 2, 3}));
}

}  // namespace
}  // namespace sinew::app
