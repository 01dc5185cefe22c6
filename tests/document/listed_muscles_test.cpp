// tests/document/listed_muscles_test.cpp: a sheet is listed, selected and hidden as one muscle.

#include "app/document/listed_muscles.h"

#include <gtest/gtest.h>

#include "app/document/shown_names.h"
#include "core/rig/sheet_edit.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/editor/muscles_named.h"
#include "tests/support/rigs/sheet_on_skin.h"

namespace sinew::app {
namespace {

/// The limb with a single muscle and two sheets, "low" and "high".
class ListedMuscles : public testing::Test {
 protected:
  void SetUp() override {
    document.character = test::makeLimb();
    prepareMirror(document);
    Primitive single;
    single.name = "single";
    single.bone = "middle";
    Rig rig = addPrimitive(document.rig(), single).value();
    rig = addSheet(rig, test::sheetBetweenBones(document.character, "low", "root", "middle")).value();
    rig = addSheet(rig, test::sheetBetweenBones(document.character, "high", "middle", "end")).value();
    document.commands.apply("Set up", rig);
    ASSERT_EQ(document.rig().primitives.size(), 19u);
  }
  [[nodiscard]] const Rig& rig() const { return document.rig(); }
  [[nodiscard]] std::vector<int> hidden() const {
    return hiddenPrimitives(document.visibility, rig(), document.character->skeleton);
  }
  void setStrips(int sheet, int strips) {
    document.commands.apply("Strips",
                            editSheet(rig(), sheet, [strips](MuscleSheet& edited) { edited.strips = strips; }).value());
  }

  Document document;
};

TEST_F(ListedMuscles, ASheetCountsOnce) {
  EXPECT_EQ(allLeads(rig()), (std::vector{0, 1, 10}));
  EXPECT_EQ(leadOf(rig(), 9), 1);
  EXPECT_EQ(leadOf(rig(), 10), 10);
  EXPECT_EQ(leadsOf(rig(), std::vector{12, 0, 11, 3, 2}), (std::vector{10, 0, 1}));
  EXPECT_EQ(membersOfMuscle(rig(), 0), std::vector{0});
  EXPECT_EQ(membersOfMuscle(rig(), 14).size(), 9u);
  EXPECT_EQ(membersOfMuscle(rig(), 14).front(), 10);
  EXPECT_EQ(nextIndex(rig()), 1);
  EXPECT_EQ(muscleName(rig(), 12), "high");
  EXPECT_EQ(namedMuscles(rig(), membersOfMuscle(rig(), 5)), "low");
  EXPECT_EQ(namedMuscles(rig(), std::vector{0, 1, 2, 3}), "2 muscles");
}

TEST_F(ListedMuscles, ASheetIsListedUnderTheBoneOfItsOrigin) {
  const Skeleton& skeleton = document.character->skeleton;
  const std::vector<int> bones = listedBones(rig(), skeleton, boneOfEach(rig(), skeleton));
  EXPECT_EQ(listedBone(rig(), 15), rig().sheets[1].edges[0].points[0].bone);
  for (std::size_t i = 10; i < 19; ++i) EXPECT_EQ(bones[i], *skeleton.findBone(listedBone(rig(), 10)));
  EXPECT_EQ(bones[0], *skeleton.findBone("middle"));
}

TEST_F(ListedMuscles, TheSelectionIsCompletedWithTheFirstBellyLast) {
  document.selection.primitives = {document.idAt(5), document.idAt(0), document.idAt(13)};
  completeSheets(document);
  EXPECT_EQ(document.selection.primitives.size(), 19u);
  EXPECT_EQ(document.activePrimitive(), 10);
  EXPECT_EQ(document.selection.primitives[8], document.idAt(1)) << "the sheet picked first stays first";
  EXPECT_EQ(document.selection.primitives[9], document.idAt(0));
  const std::vector<PrimitiveId> once = document.selection.primitives;
  completeSheets(document);
  EXPECT_EQ(document.selection.primitives, once);
  toggleMuscle(document, 4);
  EXPECT_EQ(document.selection.primitives.size(), 10u);
  toggleMuscle(document, 4);
  EXPECT_EQ(document.activeName(), "low");
}

TEST_F(ListedMuscles, NewBelliesOfASelectedSheetAreSelected) {
  selectMuscle(document, 1);
  setStrips(0, 5);
  completeSheets(document);
  EXPECT_EQ(document.selection.primitives.size(), 15u);
  document.commands.undo();
  completeSheets(document);
  EXPECT_EQ(selectedSheets(document), std::vector{0});
  EXPECT_EQ(document.activeName(), "low");
}

TEST_F(ListedMuscles, AMarkOnTheFirstBellyHidesTheSheetHoweverItIsLaid) {
  document.visibility.setMuscle(Mark::kHidden, document.idAt(1), true);
  EXPECT_EQ(hidden(), membersOfMuscle(rig(), 1));
  setStrips(0, 6);
  EXPECT_EQ(hidden().size(), 18u);
  EXPECT_FALSE(isPickable(document.visibility, rig(), document.character->skeleton, 18));
  document.visibility = {};
  document.visibility.setMuscle(Mark::kSolo, document.idAt(19), true);
  ASSERT_EQ(muscleName(rig(), 19), "high");
  EXPECT_EQ(hidden().size(), 19u);
}

TEST_F(ListedMuscles, AHiddenBoneHidesSheetsThatBeginOnIt) {
  const Skeleton& skeleton = document.character->skeleton;
  const std::string end = skeleton.bones[static_cast<std::size_t>(*skeleton.findBone("end"))].path;
  document.visibility.setBone(Mark::kHidden, end, true);
  EXPECT_TRUE(hidden().empty()) << "it only ends there";
}

TEST_F(ListedMuscles, AddedMusclesStandBeforeBellies) {
  Primitive further;
  further.name = "further";
  further.bone = "end";
  const int index = nextIndex(rig());
  document.commands.apply("Add", addPrimitive(rig(), further).value());
  EXPECT_EQ(findPrimitive(rig(), "further"), index);
}

}  // namespace
}  // namespace sinew::app
