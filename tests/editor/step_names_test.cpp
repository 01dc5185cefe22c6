// tests/editor/step_names_test.cpp: history names of steps, and name fields of new groups.

#include <gtest/gtest.h>

#include "app/editor/blending_edit.h"
#include "app/editor/symmetry_commands.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/editor/muscles_named.h"

namespace sinew::app {
namespace {

struct StepNames : HeadlessEditor {
  void SetUp() override {
    HeadlessEditor::SetUp();
    state.document.symmetry = false;
    addMuscle(state, 0);
    addMuscle(state, 1);
    addMuscle(state, 2);
    rename(state, state.document.idAt(0), "biceps");
    select(state.document, {"biceps"});
    settle();
  }
  [[nodiscard]] std::string last() const { return state.document.commands.label(steps()); }
};

TEST_F(StepNames, FieldEditsNameTheMuscle) {
  const auto expect = [&](const std::string& number) {
    EXPECT_TRUE(last().starts_with(number + " ") && last().ends_with(" on biceps")) << last();
  };
  drag("inspector/center.x", {30.0f, 0.0f});
  expect("Centre X");
  drag("inspector/radius.y", {30.0f, 0.0f});
  expect("Radius Y");
  drag("inspector/rotation.z", {30.0f, 0.0f});
  expect("Rotation Z");
  click("inspector/carves");
  EXPECT_EQ(last(), "Carve with biceps");
}

TEST_F(StepNames, TypedNumberIsNamedWithBothValues) {
  const auto typed = [&](const std::string& id, const std::string& text) {
    ImGui::GetIO().DeltaTime = 1.0f;  // Later, so that clicks count as two double clicks, not as four clicks.
    frame();
    ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
    doubleClick(id);
    press(kKeyA, true);
    type(text);
    press(kEnter);
  };
  typed("inspector/reach", "1.5");
  typed("inspector/reach", "2.25");
  EXPECT_EQ(last(), "Reach 1.500 to 2.250 on biceps");
  typed("surface/iso", "0.3");
  typed("surface/iso", "0.4");
  EXPECT_EQ(last(), "Tightness 0.300 to 0.400");
  typed("smoothing/tolerance", "0.2");
  typed("smoothing/tolerance", "0.3");
  EXPECT_EQ(last(), "Tolerance 0.20 % to 0.30 %");
  selectAll(state.document);
  settle();
  typed("inspector/reach", "1.75");
  EXPECT_EQ(last(), "Reach of 3 muscles") << "they had different ones";
  typed("inspector/reach", "2");
  EXPECT_EQ(last(), "Reach 1.750 to 2.000 on 3 muscles");
}

TEST_F(StepNames, SeveralMusclesAreCounted) {
  selectAll(state.document);
  settle();
  Rig rig = state.document.rig();
  rig.primitives[0].placement.center.x += 0.01f;
  state.document.commands.apply("Apart", rig);
  settle();
  drag("inspector/center.x", {30.0f, 0.0f});
  EXPECT_EQ(last(), "Move 3 muscles");
  duplicateSelection(state);
  EXPECT_EQ(last(), "Duplicate 3 muscles");
  deleteSelection(state);
  EXPECT_EQ(last(), "Delete 3 muscles");
}

TEST_F(StepNames, AddNamesTheNewMuscle) {
  addMuscle(state, 3);
  EXPECT_EQ(last(), "Add " + state.document.activeName());
  duplicateSelection(state);
  EXPECT_TRUE(last().starts_with("Duplicate ")) << last();
}

TEST_F(StepNames, NewGroupIsRenamedInTheGroupList) {
  ASSERT_EQ(state.view.outliner.tab, LeftTab::kMuscles);
  groupSelection(state);
  EXPECT_EQ(last(), "Group biceps");
  settle();
  EXPECT_EQ(state.view.outliner.tab, LeftTab::kGroups);
  ASSERT_TRUE(shown("blending/rename"));
  press(kKeyA, true);
  type("Legs");
  press(kEnter);
  EXPECT_GE(findGroup(state.document.rig(), "Legs"), 0);
  EXPECT_TRUE(last().starts_with("Rename group ")) << last();
  renameGroupTo(state, state.document.rig().groups.back().id(), "Arms");
  EXPECT_EQ(last(), "Rename group Legs to Arms");
}

}  // namespace
}  // namespace sinew::app
