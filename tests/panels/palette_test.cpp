// tests/panels/palette_test.cpp: palette results: buttons of panels, clips, synonyms; no hidden bones.

#include <algorithm>

#include "app/panels/palette_entries.h"
#include "tests/panels/palette_editor.h"
#include "tests/support/editor/muscles_named.h"

namespace sinew::app {
namespace {

class Palette : public PaletteEditor {
 protected:
  void SetUp() override {
    PaletteEditor::SetUp();
    openFlexing();
  }
};

TEST_F(Palette, PanelButtonsAreFoundAndRun) {
  select(state.document, {"biceps L"});
  settle();
  ask("via point");
  ASSERT_TRUE(shown("palette/panel/via-add"));
  click("palette/panel/via-add");
  const int line = findLine(state.document.rig(), "biceps L");
  EXPECT_TRUE(state.document.rig().lines.at(static_cast<std::size_t>(line)).via);
  ask("learn");
  press(kEnter);
  EXPECT_EQ(steps(), 2u);
}

TEST_F(Palette, ButtonWithoutASelectionDoesNothing) {
  state.document.selection.clear();
  ask("learn");
  ASSERT_TRUE(shown("palette/panel/learn"));
  press(kEnter);
  EXPECT_EQ(steps(), 0u);
}

TEST_F(Palette, ClipIsChosen) {
  ask("dance");
  ASSERT_TRUE(shown("palette/clip/Dance"));
  click("palette/clip/Dance");
  const int clip = state.open.transport.clip;
  ASSERT_GE(clip, 0);
  EXPECT_EQ(state.character().clips.at(static_cast<std::size_t>(clip)).name, "Dance");
}

TEST_F(Palette, SynonymsFindActions) {
  for (const auto& [words, id] : {std::pair{"clone", "edit/duplicate"}, std::pair{"wireframe", "view/wire"},
                                  std::pair{"deselect", "edit/select-none"}, std::pair{"keyframe", "edit/key"}}) {
    ask(words);
    EXPECT_TRUE(shown(std::string("palette/") + id)) << words;
    press(kEscape);
  }
}

TEST_F(Palette, SynonymsBelongToExistingActions) {
  for (const char* id : {"edit/duplicate", "edit/mirror", "tool/add-muscle", "view/wire", "view/numbers",
                         "file/export-character", "file/export-farm", "view/primitives", "view/before"}) {
    EXPECT_FALSE(synonymsOf(id).empty()) << id;
    EXPECT_TRUE(std::ranges::any_of(actions(), [&](const Action& each) { return std::string_view(each.id) == id; }))
        << id;
  }
}

TEST_F(Palette, ActionsComeBeforeEquallyMatchingSamples) {
  ask("flex");
  EXPECT_LT(rank("palette/view/flex"), 1e6f);
  for (const auto& [id, box] : widgets().rectangles()) {
    if (!id.starts_with("palette/sample/")) continue;
    EXPECT_GT(box.y, rank("palette/view/flex") - box.w) << id;
  }
}

}  // namespace
}  // namespace sinew::app
