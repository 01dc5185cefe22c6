// tests/panels/inspector_sheet_test.cpp: a sheet in the outliner, the inspector and the history.

#include <algorithm>

#include "app/document/listed_muscles.h"
#include "app/editor/muscle_set_commands.h"
#include "app/editor/outliner.h"
#include "app/editor/sheet_commands.h"
#include "app/editor/symmetry_commands.h"
#include "app/panels/blending.h"
#include "app/panels/palette_entries.h"
#include "core/rig/sheet_edit.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/editor/muscles_named.h"
#include "tests/support/rigs/sheet_on_skin.h"

namespace sinew::app {
namespace {

constexpr std::size_t kBellies = 9;

/// The bundled character with a sheet on the left leg, selected.
class SheetPanels : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    ImGui::GetIO().DisplaySize = {1280.0f, 1600.0f};
    state.document.symmetry = false;
    state.document.commands.apply(
        "Add sheet", addSheet(state.document.rig(),
                              test::sheetBetweenBones(state.document.character, "quads L", "thigh.L", "shin.L"))
                         .value());
    ASSERT_EQ(state.document.rig().primitives.size(), kBellies);
    selectMuscle(state.document, 0);
    settle();
  }
  [[nodiscard]] const MuscleSheet& sheet(std::size_t index = 0) const { return state.document.rig().sheets.at(index); }
  [[nodiscard]] std::string last() const { return state.document.commands.label(steps()); }
  /// A second double click must not join with the first.
  void typed(const std::string& id, const std::string& text) {
    ImGui::GetIO().DeltaTime = 1.0f;
    frame();
    ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
    typeInto(id, text);
  }
  [[nodiscard]] std::vector<std::string> rowsOf(const std::string& begin) const {
    std::vector<std::string> rows;
    for (const auto& [id, box] : widgets().rectangles()) {
      if (id.starts_with(begin)) rows.push_back(id);
    }
    return rows;
  }
};

TEST_F(SheetPanels, TheOutlinerHasOneRow) {
  EXPECT_EQ(rowsOf("outliner/muscle/"), std::vector<std::string>{"outliner/muscle/quads L"});
  state.document.selection.clear();
  click("outliner/muscle/quads L");
  EXPECT_EQ(state.document.selection.primitives.size(), kBellies);
  click("outliner/eye/quads L");
  EXPECT_EQ(hiddenPrimitives(state.document.visibility, state.document.rig(), state.character().skeleton).size(),
            kBellies);
  EXPECT_EQ(hiddenText(state.document), "1 of 1 muscles hidden");
  click("outliner/eye/quads L");
  EXPECT_FALSE(anythingHidden(state.document));
  for (const OutlinerOrder order : {OutlinerOrder::kRegions, OutlinerOrder::kGroups}) {
    state.view.outliner.order = order;
    settle();
    EXPECT_EQ(rowsOf("outliner/muscle/").size(), 1u);
  }
  state.view.outlinerFilter = "quads L 1.1";
  settle();
  EXPECT_TRUE(rowsOf("outliner/muscle/").empty()) << "bellies have no names of their own in the list";
}

TEST_F(SheetPanels, RenamesTheSheetInTheListAndInTheInspector) {
  doubleClick("outliner/muscle/quads L");
  press(kKeyA, true);
  type("front L");
  press(kEnter);
  EXPECT_EQ(sheet().name, "front L");
  EXPECT_EQ(last(), "Rename quads L");
  EXPECT_EQ(state.document.selection.primitives.size(), kBellies);
  EXPECT_EQ(state.document.activeName(), "front L");
}

TEST_F(SheetPanels, FieldsChangeTheSheetAndTheHistoryNamesIt) {
  EXPECT_FALSE(shown("inspector/center.x"));
  EXPECT_FALSE(shown("inspector/bone"));
  typed("inspector/sheet/strips", "4");
  EXPECT_EQ(sheet().strips, 4);
  EXPECT_EQ(last(), "Strips of quads L 3 to 4");
  EXPECT_EQ(state.document.selection.primitives.size(), 12u);
  typed("inspector/sheet/crest", "2");
  EXPECT_FLOAT_EQ(sheet().crest, 0.02f);
  EXPECT_EQ(last(), "Crest of quads L 1.50 % to 2.00 %");
  const std::size_t before = steps();
  drag("inspector/sheet/bellies", {60.0f, 0.0f});
  EXPECT_GT(sheet().bellies, 3);
  EXPECT_EQ(steps(), before + 1) << "a drag is one step";
  typed("inspector/sheet/soft", "100");
  EXPECT_FLOAT_EQ(sheet().across.front().y, 0.0f);
  EXPECT_FLOAT_EQ(sheet().across.back().y, 0.0f);
  EXPECT_FLOAT_EQ(sheet().across[1].y, 1.0f);
  typed("inspector/sheet/thickness", "900");
  EXPECT_FLOAT_EQ(sheet().thickness, MuscleSheet{}.thickness) << "refused";
}

TEST_F(SheetPanels, ASingleStripHasAWidth) {
  EXPECT_FALSE(shown("inspector/sheet/width"));
  typed("inspector/sheet/strips", "1");
  EXPECT_EQ(sheet().strips, 1);
  EXPECT_GT(sheet().width, 0.0f);
  typed("inspector/sheet/width", "3");
  EXPECT_FLOAT_EQ(sheet().width, 0.03f);
  typed("inspector/sheet/strips", "2");
  EXPECT_EQ(sheet().width, 0.0f);
}

TEST_F(SheetPanels, MoreShowsTheRest) {
  EXPECT_FALSE(shown("inspector/sheet/sunk"));
  click("inspector/sheet/more");
  typed("inspector/sheet/sunk", "-1");
  EXPECT_FLOAT_EQ(sheet().sunk, -0.01f);
  typed("inspector/sheet/reach", "1.7");
  EXPECT_FLOAT_EQ(sheet().reach, 1.7f);
  typed("inspector/sheet/spacing", "0.9");
  EXPECT_FLOAT_EQ(sheet().spacing, 0.9f);
}

TEST_F(SheetPanels, LinesComeAndGo) {
  EXPECT_TRUE(state.document.rig().lines.empty());
  EXPECT_FALSE(shown("inspector/line/volume"));
  click("inspector/sheet/on-lines");
  EXPECT_EQ(last(), "Put quads L on lines");
  EXPECT_EQ(state.document.rig().lines.size(), 3u);
  typed("inspector/line/volume", "0.8");
  ASSERT_TRUE(sheet().line);
  EXPECT_FLOAT_EQ(sheet().line->volume, 0.8f);
  EXPECT_FLOAT_EQ(state.document.rig().lines[2].settings.volume, 0.8f);
  EXPECT_FALSE(shown("inspector/line/via")) << "its lines are not edited one by one";
  click("inspector/sheet/on-lines");
  EXPECT_TRUE(state.document.rig().lines.empty());
}

TEST_F(SheetPanels, ProfilesAreEditedByTheirPoints) {
  const Profile before = sheet().across;
  const std::size_t first = steps();
  drag("inspector/sheet/across/1", {0.0f, 30.0f});
  EXPECT_EQ(steps(), first + 1);
  EXPECT_LT(sheet().across[1].y, before[1].y);
  EXPECT_EQ(sheet().across[2], before[2]);
  EXPECT_EQ(last(), "Profile across quads L");
  click("inspector/sheet/along/1", 1);
  EXPECT_EQ(sheet().along.size(), 3u) << "a right click removes a point";
  // Delete removes the point under the pointer, not the muscle.
  queue.move(center("inspector/sheet/along/1"));
  settle();
  press(kDelete);
  EXPECT_EQ(sheet().along.size(), 2u);
  EXPECT_EQ(state.document.rig().sheets.size(), 1u);
}

TEST_F(SheetPanels, TwoSheetsAreEditedTogether) {
  state.document.commands.apply(
      "Add sheet",
      addSheet(state.document.rig(), test::sheetBetweenBones(state.document.character, "quads R", "thigh.R", "shin.R"))
          .value());
  selectMuscle(state.document, 0);
  toggleMuscle(state.document, 9);
  settle();
  typed("inspector/sheet/crest", "2.5");
  EXPECT_FLOAT_EQ(sheet(0).crest, 0.025f);
  EXPECT_FLOAT_EQ(sheet(1).crest, 0.025f);
  EXPECT_EQ(last(), "Crest of 2 sheets 1.50 % to 2.50 %");
  EXPECT_TRUE(twoSelected(state.document));
}

TEST_F(SheetPanels, GroupAndSignHoldForTheSheet) {
  click("inspector/carves");
  EXPECT_EQ(sheet().sign, -1);
  EXPECT_EQ(last(), "Carve with quads L");
  EXPECT_TRUE(std::ranges::all_of(state.document.rig().primitives, [](const Primitive& p) { return p.sign == -1; }));
  groupSelection(state);
  EXPECT_EQ(last(), "Group quads L");
  EXPECT_EQ(sheet().group, "group");
  EXPECT_EQ(groupText(state.document.rig(), findGroup(state.document.rig(), "group")), "group: 1 muscle");
}

TEST_F(SheetPanels, HistoryNamesTheSheet) {
  duplicateSelection(state);
  EXPECT_EQ(last(), "Duplicate quads L");
  ASSERT_EQ(state.document.rig().sheets.size(), 2u);
  EXPECT_EQ(state.document.activeName(), sheet(1).name);
  EXPECT_EQ(selectedSheets(state.document), std::vector<int>{1});
  deleteSelection(state);
  EXPECT_TRUE(last().starts_with("Delete quads L")) << last();
  EXPECT_EQ(state.document.rig().sheets.size(), 1u);
  selectMuscle(state.document, 0);
  mirrorSelection(state);
  EXPECT_EQ(last(), "Mirror quads L");
  ASSERT_EQ(state.document.rig().sheets.size(), 2u);
  selectTwins(state.document);
  EXPECT_EQ(state.document.activeName(), "quads R");
  selectMuscle(state.document, 0);
  settle();
  EXPECT_TRUE(shown("inspector/twin"));
  unlinkSelection(state);
  EXPECT_EQ(last(), "Unlink quads L");
  EXPECT_TRUE(sheet(0).mirror.empty());
}

TEST_F(SheetPanels, BreaksIntoStrips) {
  click("inspector/sheet/break");
  EXPECT_EQ(last(), "Break quads L into strips");
  EXPECT_TRUE(state.document.rig().sheets.empty());
  ASSERT_EQ(state.document.rig().primitives.size(), kBellies);
  EXPECT_EQ(rowsOf("outliner/muscle/").size(), kBellies);
  EXPECT_EQ(state.document.selection.primitives.size(), kBellies) << "all stay selected";
  EXPECT_FALSE(action("edit/break-sheet").enabled(state));
  undo(state);
  settle();
  EXPECT_EQ(rowsOf("outliner/muscle/").size(), 1u);
  click("outliner/muscle/quads L", 1);
  EXPECT_FALSE(shown("context/tool/territory")) << "it has the territory of the skin that it lies on";
  click("context/edit/break-sheet");
  EXPECT_TRUE(state.document.rig().sheets.empty());
}

TEST_F(SheetPanels, ThePaletteAndTheCheckListHaveItOnce) {
  const PaletteEntries all = gatherEntries(state);
  EXPECT_EQ(std::ranges::count_if(all.entries, [](const PaletteEntry& e) { return e.id.starts_with("muscle/"); }), 1);
  checkMuscles(state);
  std::set<std::pair<int, FindingKind>> seen;
  for (const Finding& finding : state.open.check.findings) {
    EXPECT_TRUE(seen.emplace(leadOf(state.document.rig(), finding.primitive), finding.kind).second);
  }
}

TEST_F(SheetPanels, DoesNotMoveToAnotherBone) {
  const Rig before = state.document.rig();
  reparentMuscles(state, selectedIndices(state.document), 2);
  EXPECT_EQ(state.document.rig(), before);
  ASSERT_TRUE(state.session.toast);
  EXPECT_TRUE(state.session.toast->refusal);
}

TEST_F(SheetPanels, MusclesAddedBesideASheetAreSelected) {
  addMuscle(state, 3);
  EXPECT_EQ(last(), "Add " + state.document.activeName());
  EXPECT_TRUE(muscle().sheet.empty());
  EXPECT_EQ(state.document.activePrimitive(), 0);
}

}  // namespace
}  // namespace sinew::app
