// tests/document/visibility_test.cpp: eye, lock, solo and isolation, also when the rig changes.

#include "app/document/visibility.h"

#include <gtest/gtest.h>

#include "app/document/command_stack.h"
#include "sinew/rig/rig_edit.h"

namespace sinew::app {
namespace {

Bone boneNamed(const std::string& name, int parent) {
  Bone bone;
  bone.name = name;
  bone.parent = parent;
  return bone;
}

/// Hip, knee below it, arm apart; a muscle on each, and one on a missing bone.
class MuscleVisibility : public testing::Test {
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
    rig = CommandStack(rig).rig();
    welcomeNew(visibility, rig, skeleton);
  }
  [[nodiscard]] PrimitiveId id(int index) const { return rig.primitives[static_cast<std::size_t>(index)].id(); }
  [[nodiscard]] std::vector<int> hidden() const { return hiddenPrimitives(visibility, rig, skeleton); }
  [[nodiscard]] std::string path(int bone) const { return skeleton.bones[static_cast<std::size_t>(bone)].path; }

  Skeleton skeleton;
  Rig rig;
  Visibility visibility;
};

TEST_F(MuscleVisibility, BonesOfMusclesMatchFindBone) {
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

TEST_F(MuscleVisibility, BoneMarkAppliesToItsMusclesAndDescendants) {
  EXPECT_TRUE(hidden().empty());
  visibility.setBone(Mark::kHidden, path(0), true);
  EXPECT_EQ(hidden(), (std::vector<int>{0, 1}));
  visibility.setBone(Mark::kHidden, path(0), false);
  visibility.setMuscle(Mark::kHidden, id(2), true);
  EXPECT_EQ(hidden(), (std::vector<int>{2}));
  visibility.setBone(Mark::kLocked, path(1), true);
  EXPECT_FALSE(isPickable(visibility, rig, skeleton, 1));
  EXPECT_TRUE(isPickable(visibility, rig, skeleton, 0));
  EXPECT_FALSE(isPickable(visibility, rig, skeleton, 2));
}

TEST_F(MuscleVisibility, SoloHidesAllOthers) {
  visibility.setMuscle(Mark::kSolo, id(3), true);
  EXPECT_EQ(hidden(), (std::vector<int>{0, 1, 2}));
  visibility.setBone(Mark::kSolo, path(1), true);
  EXPECT_EQ(hidden(), (std::vector<int>{0, 2}));
  visibility.setMuscle(Mark::kHidden, id(1), true);
  EXPECT_EQ(hidden(), (std::vector<int>{0, 1, 2}));
}

TEST_F(MuscleVisibility, IsolationAndBareHideFurtherMuscles) {
  visibility.isolated = std::set<PrimitiveId>{id(0), id(2)};
  EXPECT_EQ(hidden(), (std::vector<int>{1, 3}));
  visibility.bare = true;
  EXPECT_EQ(hidden().size(), 4u);
}

TEST_F(MuscleVisibility, MarksFollowRenameAndUndo) {
  CommandStack commands(rig);
  visibility.setMuscle(Mark::kHidden, commands.rig().primitives[2].id(), true);
  commands.apply("Rename", renamePrimitive(commands.rig(), 2, "biceps").value());
  welcomeNew(visibility, commands.rig(), skeleton);
  EXPECT_EQ(hiddenPrimitives(visibility, commands.rig(), skeleton), (std::vector<int>{2}));
  commands.undo();
  EXPECT_EQ(hiddenPrimitives(visibility, commands.rig(), skeleton), (std::vector<int>{2}));
}

TEST_F(MuscleVisibility, UndoRestoresHiddenStateAndANewMuscleIsVisible) {
  CommandStack commands(rig);
  visibility.setMuscle(Mark::kHidden, commands.rig().primitives[3].id(), true);
  commands.apply("Delete", removePrimitives(commands.rig(), std::vector<int>{3}));
  commands.undo();
  welcomeNew(visibility, commands.rig(), skeleton);
  EXPECT_EQ(hiddenPrimitives(visibility, commands.rig(), skeleton), (std::vector<int>{3}));
  commands.redo();
  Primitive again;
  again.name = "on tail";
  again.bone = "tail";
  commands.apply("Add", addPrimitive(commands.rig(), again).value());
  welcomeNew(visibility, commands.rig(), skeleton);
  EXPECT_TRUE(hiddenPrimitives(visibility, commands.rig(), skeleton).empty());
}

TEST_F(MuscleVisibility, NewMuscleJoinsTheIsolatedButUndoneDeletionsDoNot) {
  CommandStack commands(rig);
  welcomeNew(visibility, commands.rig(), skeleton);
  visibility.isolated = std::set<PrimitiveId>{commands.rig().primitives[0].id()};
  Primitive primitive;
  primitive.name = "new";
  primitive.bone = "arm";
  commands.apply("Add", addPrimitive(commands.rig(), primitive).value());
  welcomeNew(visibility, commands.rig(), skeleton);
  EXPECT_EQ(hiddenPrimitives(visibility, commands.rig(), skeleton), (std::vector<int>{1, 2, 3}));
  commands.apply("Delete", removePrimitives(commands.rig(), std::vector<int>{1}));
  welcomeNew(visibility, commands.rig(), skeleton);
  commands.undo();
  welcomeNew(visibility, commands.rig(), skeleton);
  EXPECT_EQ(hiddenPrimitives(visibility, commands.rig(), skeleton), (std::vector<int>{1, 2, 3}));
}

TEST_F(MuscleVisibility, SoloOfAnUndoneMuscleHidesNothing) {
  CommandStack commands(rig);
  welcomeNew(visibility, commands.rig(), skeleton);
  visibility.setMuscle(Mark::kSolo, commands.rig().primitives[0].id(), true);
  Primitive primitive;
  primitive.name = "new";
  primitive.bone = "arm";
  commands.apply("Add", addPrimitive(commands.rig(), primitive).value());
  welcomeNew(visibility, commands.rig(), skeleton);
  EXPECT_EQ(hiddenPrimitives(visibility, commands.rig(), skeleton), (std::vector<int>{1, 2, 3}));
  commands.undo();
  visibility.setMuscle(Mark::kSolo, commands.rig().primitives[0].id(), false);
  EXPECT_TRUE(hiddenPrimitives(visibility, commands.rig(), skeleton).empty());
}

TEST_F(MuscleVisibility, NewMuscleOnASoloedBoneNeedsNoMark) {
  CommandStack commands(rig);
  welcomeNew(visibility, commands.rig(), skeleton);
  visibility.setBone(Mark::kSolo, path(2), true);
  Primitive primitive;
  primitive.name = "new";
  primitive.bone = "arm";
  commands.apply("Add", addPrimitive(commands.rig(), primitive).value());
  welcomeNew(visibility, commands.rig(), skeleton);
  visibility.setBone(Mark::kSolo, path(2), false);
  EXPECT_TRUE(hiddenPrimitives(visibility, commands.rig(), skeleton).empty());
}

}  // namespace
}  // namespace sinew::app
