// tests/panels/outliner_parts_test.cpp: flat lists of the outliner, by region and by group.

#include "tests/support/editor/headless_editor.h"

#include "app/editor/outliner.h"
#include "app/editor/session.h"
#include "tests/support/editor/muscles_named.h"

namespace sinew::app {
namespace {

class OutlinerParts : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    ASSERT_TRUE(openFile(state, std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "demo.rig.json"));
    state.open.transport.playing = false;
    settle();
  }
};

TEST(BodyParts, NameTheRegionsOfThePerson) {
  const Result<Document> person =
      openDocument(std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "humanoid.rig.json");
  ASSERT_TRUE(person);
  const Skeleton& skeleton = person->character->skeleton;
  const std::vector<std::string> parts = bodyParts(skeleton);
  const auto of = [&](const char* bone) { return parts.at(static_cast<std::size_t>(skeleton.findBone(bone).value())); };
  EXPECT_EQ(of("forearm.L"), "Left arm");
  EXPECT_EQ(of("upper_arm.R"), "Right arm");
  EXPECT_EQ(of("thigh.L"), "Left leg");
  EXPECT_EQ(of("foot.R"), "Right leg");
  EXPECT_EQ(of("spine"), "Torso");
  EXPECT_EQ(of("hips"), "Torso");
  EXPECT_EQ(of("head"), "Head and neck");
}

TEST(BodyParts, AreRecognizedInJapaneseNames) {
  Skeleton skeleton;
  for (const auto& [name, parent] : std::initializer_list<std::pair<const char*, int>>{{"全ての親", -1},
                                                                                       {"下半身", 0},
                                                                                       {"上半身", 0},
                                                                                       {"首", 2},
                                                                                       {"左肩", 2},
                                                                                       {"左腕", 4},
                                                                                       {"右足", 1},
                                                                                       {"右ひざ", 6}}) {
    if (parent >= 0)
      skeleton.bones[static_cast<std::size_t>(parent)].children.push_back(static_cast<int>(skeleton.bones.size()));
    Bone bone;
    bone.name = name;
    bone.parent = parent;
    skeleton.bones.push_back(bone);
  }
  EXPECT_EQ(bodyParts(skeleton), (std::vector<std::string>{"Torso", "Torso", "Torso", "Head and neck", "Left arm",
                                                           "Left arm", "Right leg", "Right leg"}));
}

TEST_F(OutlinerParts, RegionOrderIsAFlatListUnderFoldingTitles) {
  ASSERT_TRUE(openFile(state, std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "humanoid.rig.json"));
  settle();
  click("outliner/order/regions");
  ASSERT_TRUE(shown("outliner/part/Left arm"));
  EXPECT_FALSE(shown("outliner/bone/hips"));
  const float left = center("outliner/part/Left arm").y;
  ASSERT_TRUE(shown("outliner/muscle/biceps L"));
  EXPECT_GT(center("outliner/muscle/biceps L").y, left);
  click("outliner/part/Left arm");
  EXPECT_FALSE(shown("outliner/muscle/biceps L"));
  jumpToMuscle(state, idOf(state.document, "biceps L"));
  settle();
  EXPECT_TRUE(shown("outliner/muscle/biceps L")) << "what is selected unfolds its part";
  EXPECT_EQ(selectedNames(state.document), std::vector<std::string>{"biceps L"});
}

TEST_F(OutlinerParts, GroupOrderListsEveryMuscleOnceUnderItsGroup) {
  state.view.outliner.order = OutlinerOrder::kGroups;
  settle();
  for (const Group& group : state.document.rig().groups) {
    state.view.outliner.folded.insert(foldedKey(group.name));
  }
  settle();
  const Rig& rig = state.document.rig();
  OutlinerView view;
  view.order = OutlinerOrder::kGroups;
  const Skeleton& skeleton = state.character().skeleton;
  const auto rows = outlinerRows(rig, skeleton, boneOfEach(rig, skeleton), view);
  std::vector<int> seen;
  std::string part;
  for (const OutlinerRow& row : rows) {
    if (row.kind == RowKind::kPart) part = row.part;
    if (row.kind != RowKind::kMuscle) continue;
    seen.push_back(row.index);
    EXPECT_EQ(rig.primitives[static_cast<std::size_t>(row.index)].group, part);
  }
  EXPECT_EQ(seen.size(), rig.primitives.size());
  EXPECT_FALSE(shown("outliner/muscle/" + rig.primitives[0].name)) << "all groups are folded";
}

TEST_F(OutlinerParts, MuscleNamedAfterItsBoneIsRenamedWhenReparented) {
  const auto indexOf = [&](const char* name) { return findPrimitive(state.document.rig(), name); };
  const Skeleton& skeleton = state.character().skeleton;
  const int thigh = skeleton.findBone("thigh.L").value_or(-1);
  const int calf = skeleton.findBone("shin.L").value_or(-1);
  ASSERT_TRUE(thigh >= 0 && calf >= 0);
  addMuscle(state, thigh);
  const std::size_t before = steps();
  ASSERT_GE(indexOf("thigh.L muscle"), 0);
  const bool twins = indexOf("thigh.R muscle") >= 0;
  reparentMuscles(state, {indexOf("thigh.L muscle")}, calf);
  EXPECT_GE(indexOf("shin.L muscle"), 0);
  EXPECT_EQ(indexOf("shin.R muscle") >= 0, twins);
  EXPECT_EQ(steps(), before + 1);
  const int moved = indexOf("shin.L muscle");
  EXPECT_EQ(state.document.rig().primitives[static_cast<std::size_t>(moved)].bone, "shin.L");
  undo(state);
  EXPECT_GE(indexOf("thigh.L muscle"), 0);
}

}  // namespace
}  // namespace sinew::app
