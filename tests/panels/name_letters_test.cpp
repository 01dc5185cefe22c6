// tests/panels/name_letters_test.cpp: names with letters that no font has, in panels and messages.

#include "app/window/editor_window.h"

#include <algorithm>

#include "app/viewport/tools/select.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/temporary_folder.h"

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

TEST(LettersOfNames, AreThoseOfBonesClipsAndMuscles) {
  const test::TemporaryFolder folder;
  test::Post post = test::makePost();
  post.file.json["nodes"][1]["name"] = "腰";
  post.file.json["animations"][0]["name"] = "歩く";
  EditorState state;
  ASSERT_TRUE(openFile(state, folder.write("post.glb", post.file.glb())));
  const std::u32string letters = lettersOfNames(state);
  for (const char32_t letter : U"腰歩く") {
    EXPECT_TRUE(letter == 0 || letters.find(letter) != std::u32string::npos) << static_cast<unsigned>(letter);
  }
}

}  // namespace
}  // namespace sinew::app
