// tests/editor/symmetry_commands_test.cpp: twins, multiple selection and the clipboard, through buttons and shortcuts.

#include "app/editor/symmetry_commands.h"

#include <gtest/gtest.h>

#include "core/rig/twins.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/editor/muscles_named.h"

namespace sinew::app {
namespace {

/// The bundled character with a pair of muscles on its thighs and one in the middle.
struct SymmetryCommands : HeadlessEditor {
  void SetUp() override {
    HeadlessEditor::SetUp();
    ASSERT_TRUE(state.document.symmetry);
    const MirrorPlan& plan = *state.document.mirror;
    int left = -1;
    for (std::size_t i = 0; i < plan.twinOf.size() && left < 0; ++i) {
      if (plan.twinOf[i] > static_cast<int>(i)) left = static_cast<int>(i);
    }
    ASSERT_GE(left, 0);
    addMuscle(state, left);
    name = state.document.activeName();
    ASSERT_EQ(rig().primitives.size(), 2u);
    settle();
  }
  [[nodiscard]] const Rig& rig() const { return state.document.rig(); }
  std::string name;
};

TEST_F(SymmetryCommands, InspectorShowsTheTwinAndUnlinksIt) {
  EXPECT_TRUE(shown("inspector/twin"));
  click("inspector/unlink");
  EXPECT_EQ(rig().primitives[0].mirror, "");
  EXPECT_EQ(rig().primitives[1].mirror, "");
  EXPECT_TRUE(shown("inspector/mirror"));
  EXPECT_FALSE(shown("inspector/unlink"));
  select(state.document, {rig().primitives[1].name, rig().primitives[0].name});
  linkSelection(state);
  EXPECT_EQ(twinOf(rig(), 0), 1);
}

TEST_F(SymmetryCommands, SymmetryButtonDecidesWhetherDeleteIncludesTheTwin) {
  click("toolstrip/symmetry");
  EXPECT_FALSE(state.document.symmetry);
  EXPECT_EQ(editedIndices(state.document), std::vector<int>{0});
  click("toolstrip/symmetry");
  EXPECT_EQ(editedIndices(state.document), (std::vector<int>{0, 1}));
  deleteSelection(state);
  EXPECT_TRUE(rig().primitives.empty());
  undo(state);
  EXPECT_EQ(rig().primitives.size(), 2u);
}

TEST_F(SymmetryCommands, DuplicateAndPasteKeepPairsAndSelectTheCopies) {
  duplicateSelection(state);
  ASSERT_EQ(rig().primitives.size(), 4u);
  EXPECT_EQ(twinOf(rig(), 2), 3);
  EXPECT_EQ(selectedNames(state.document), std::vector<std::string>{rig().primitives[2].name});
  copySelection(state.document);
  pasteMuscles(state, false);
  ASSERT_EQ(rig().primitives.size(), 6u);
  EXPECT_EQ(twinOf(rig(), 4), 5);
  EXPECT_EQ(state.document.selection.primitives.size(), 2u);
  cutSelection(state);
  EXPECT_EQ(rig().primitives.size(), 4u);
  ImGui::SetClipboardText("no rig");
  const std::size_t told = state.session.messages.size();
  pasteMuscles(state, false);
  EXPECT_EQ(state.session.messages.size(), told + 1);
  EXPECT_EQ(rig().primitives.size(), 4u);
}

TEST_F(SymmetryCommands, RenamedPairKeepsMatchingNames) {
  EXPECT_TRUE(rename(state, idOf(state.document, name), "quad L"));
  EXPECT_EQ(rig().primitives[1].name, "quad R");
  EXPECT_EQ(state.document.activeName(), "quad L");
  EXPECT_EQ(state.document.commands.label(state.document.commands.position()), "Rename " + name);
}

TEST_F(SymmetryCommands, SelectTwinInvertAllAndOnBoneWork) {
  selectTwins(state.document);
  EXPECT_EQ(state.document.activeName(), rig().primitives[1].name);
  invertSelection(state.document);
  EXPECT_EQ(selectedNames(state.document), std::vector<std::string>{name});
  selectAll(state.document);
  EXPECT_EQ(state.document.selection.primitives.size(), 2u);
  EXPECT_EQ(state.document.activeName(), name);
  selectOnBone(state.document);
  EXPECT_EQ(state.document.selection.primitives.size(), 2u);
  select(state.document, {name});
  selectOnBone(state.document);
  EXPECT_EQ(selectedNames(state.document), std::vector<std::string>{name});
}

TEST_F(SymmetryCommands, MirroringBothOfAPairMirrorsTheFirst) {
  toggleSymmetry(state.document);
  Rig wider = rig();
  wider.primitives[0].placement.radii.x *= 2.0f;
  const glm::vec3 radii = wider.primitives[0].placement.radii;
  state.document.commands = CommandStack(wider);  // As a file may have it: the pair is not exact.
  selectAll(state.document);
  mirrorSelection(state);
  EXPECT_EQ(rig().primitives.size(), 2u);
  EXPECT_EQ(rig().primitives[1].placement.radii, radii);
  EXPECT_EQ(state.document.commands.label(state.document.commands.position()), "Mirror " + name);
}

}  // namespace
}  // namespace sinew::app
