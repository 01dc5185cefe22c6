// tests/editor/toast_test.cpp: toasts after edits: text, duration and frequency.

#include "app/editor/editor_state.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "app/editor/commands.h"
#include "app/editor/edit.h"
#include "app/editor/open_file.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

TEST(Toast, IsOpaqueThenFadesThenDisappears) {
  const Toast toast{"Saved arm.rig.json", false, 100.0};
  float before = 1.0f;
  bool faded = false;
  for (double now = 100.0; now < 110.0; now += 0.01) {
    const float shown = opacity(toast, now);
    EXPECT_LE(shown, before);
    EXPECT_TRUE(now >= 102.0 || shown == 1.0f) << now;
    faded = faded || (shown > 0.0f && shown < 1.0f);
    before = shown;
  }
  EXPECT_TRUE(faded);
  EXPECT_EQ(before, 0.0f);
}

TEST(Toast, RequestedWakeUpsShowItUntilItIsGone) {
  for (const char* text :
       {"", "Saved", "Muscle \"biceps L\", radius Y: expected a number > 0, got -1, and so on and on"}) {
    for (const bool refusal : {false, true}) {
      const Toast toast{text, refusal, 7.0};
      double now = 7.0;
      int frames = 0;
      while (const auto change = secondsToChange(toast, now)) {
        ASSERT_GT(*change, 0.0);
        ASSERT_LT(++frames, 60) << "that is no sleep";
        now += *change;
      }
      EXPECT_NEAR(opacity(toast, now), 0.0f, 1e-6f);
      EXPECT_GT(now, 9.0);
      EXPECT_LT(now, 18.0);
    }
  }
}

TEST(Toast, RefusalStaysLonger) {
  double now = 0.0;
  const Toast done{"text", false, 0.0};
  const Toast refused{"text", true, 0.0};
  while (opacity(done, now) > 0.0f) now += 0.1;
  EXPECT_EQ(opacity(refused, now), 1.0f);
}

class EditorMessages : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(openFile(state, std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "demo.glb"));
    state.session.messages.clear();
    state.frame.now = 50.0;
  }
  [[nodiscard]] std::string toast() const { return state.session.toast ? state.session.toast->text : ""; }

  EditorState state;
};

TEST_F(EditorMessages, UndoAndRedoNameTheStep) {
  addMuscle(state, 0);
  const std::string label = state.document.commands.label(1);
  undo(state);
  EXPECT_EQ(toast(), "Undone: " + label);
  EXPECT_EQ(state.session.toast->since, 50.0);
  redo(state);
  EXPECT_EQ(toast(), "Redone: " + label);
  state.session.toast.reset();
  redo(state);
  EXPECT_EQ(toast(), "") << "nothing was redone";
}

TEST_F(EditorMessages, SavingNamesTheFile) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(saveTo(state, folder.path() / "arm.rig.json"), "");
  EXPECT_EQ(toast(), "Saved arm.rig.json");
}

TEST_F(EditorMessages, DragRefusedInEveryFrameIsOneMessage) {
  addMuscle(state, 0);
  Placement flat = state.document.rig().primitives[0].placement;
  flat.radii.y = -1.0f;
  for (int frame = 0; frame < 30; ++frame) {
    state.frame.now += 1.0;
    edit(state, "Scale", setPlacement(state.document.rig(), 0, flat));
  }
  ASSERT_EQ(state.session.messages.size(), 1u);
  EXPECT_EQ(state.session.messages[0].count, 1);
  const std::string name = state.document.rig().primitives[0].name;
  EXPECT_EQ(toast(), "Muscle \"" + name + "\", radius Y: expected a number > 0, got -1");
  EXPECT_TRUE(state.session.toast->refusal);
  EXPECT_EQ(state.session.toast->since, state.frame.now) << "shown as long as it goes on";
  EXPECT_FALSE(state.session.messagesShown);
}

TEST_F(EditorMessages, RepeatedMessageIsCountedAndMovesToTheEnd) {
  addMessage(state.session, MessageKind::kNote, "a");
  addMessage(state.session, MessageKind::kNote, "b");
  addMessage(state.session, MessageKind::kNote, "a");
  ASSERT_EQ(state.session.messages.size(), 2u);
  EXPECT_EQ(state.session.messages.back().text, "a");
  EXPECT_EQ(state.session.messages.back().count, 2);
  addMessage(state.session, MessageKind::kError, "a");
  EXPECT_EQ(state.session.messages.size(), 3u) << "another kind is another message";
}

TEST_F(EditorMessages, OpeningADocumentClearsOnlyDocumentMessages) {
  addMessage(state.session, MessageKind::kWarning, "of the document");
  addMessage(state.session, MessageKind::kWarning, "of the program", MessageAbout::kProgram);
  const test::TemporaryFolder folder;
  const auto glb = folder.path() / "demo.glb";
  std::filesystem::copy_file(std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "demo.glb", glb);
  const auto rig = folder.write("x.rig.json", R"({"format": "sinew-rig", "version": 1, "character": "demo.glb",
    "groups": [{"name": "g"}], "primitives": [{"name": "biceps L", "bone": "no such bone", "group": "g",
    "center": [0, 0, 0], "radii": [1, 1, 1]}]})");
  ASSERT_TRUE(openFile(state, rig));
  ASSERT_EQ(state.session.messages.size(), 2u);
  EXPECT_EQ(state.session.messages[0].text, "of the program");
  EXPECT_EQ(state.session.messages[1].text,
            "Muscle \"biceps L\": this character has no bone \"no such bone\"; it is kept, but has no effect");
  EXPECT_FALSE(openFile(state, folder.path() / "none.glb"));
  EXPECT_EQ(state.session.messages.size(), 3u) << "a file that did not open takes nothing away";
}

}  // namespace
}  // namespace sinew::app
