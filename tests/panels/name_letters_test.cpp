// tests/panels/name_letters_test.cpp: names with letters that no font has, in panels and messages.

#include "app/window/editor_window.h"

#include <algorithm>

#include "app/viewport/tools/select.h"
#include "tests/support/editor/headless_editor.h"

namespace sinew::app {
namespace {

bool latinAlone(char32_t c) { return c < 0x250; }

class UndisplayableNames : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    addOne();
    rename(state, muscle().id(), "上腕");
    settle();
    ASSERT_EQ(muscle().name, "上腕");
  }
  void TearDown() override {
    setGlyphs({});
    HeadlessEditor::TearDown();
  }
};

TEST_F(UndisplayableNames, MessageNamesMissingLettersAndTheFontPackage) {
  const std::u32string letters = lettersOfNames(state);
  EXPECT_EQ(letters, U"上腕");
  EXPECT_EQ(missingLetters(letters, [](char32_t) { return true; }), "");
  EXPECT_NE(missingLetters(letters, latinAlone).find("fonts-noto-cjk"), std::string::npos);
  const std::string other = missingLetters(U"እ", latinAlone);
  EXPECT_NE(other.find("by number"), std::string::npos);
  EXPECT_EQ(other.find("fonts-noto-cjk"), std::string::npos);
}

TEST_F(UndisplayableNames, StatusShowsTheNumberAndTheRigKeepsTheName) {
  ViewportHover hover;
  hover.primitive = 0;
  EXPECT_TRUE(describe(hover, state.document).starts_with("上腕 on "));
  setGlyphs(latinAlone);
  settle();
  EXPECT_TRUE(describe(hover, state.document).starts_with("muscle 1 on "));
  EXPECT_EQ(muscle().name, "上腕");
  EXPECT_TRUE(shown("outliner/muscle/上腕")) << "rows are called after the file's names";
}

}  // namespace
}  // namespace sinew::app
