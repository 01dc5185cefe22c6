// tests/panels/second_look_test.cpp: positions that must not move: rows under the pointer, the flex slider in small
// windows; messages that move aside; keys that a list consumes.

#include <algorithm>

#include "app/editor/edit.h"
#include "core/files/disk/atomic_file.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/editor/muscles_named.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

constexpr int kDown = 264;
constexpr int kUp = 265;
constexpr int kKeyK = 75;

class PanelDetails : public HeadlessEditor {
 protected:
  void open(const char* asset) {
    ASSERT_TRUE(openFile(state, fs::path(SINEW_SOURCE_DIR) / "assets" / asset));
    chooseClip(state.open.transport, 0, state.character());
    state.open.transport.playing = false;
    state.session.messages.clear();
    settle();
  }
  void pointAt(const std::string& id) {
    queue.move(center(id));
    settle();
    settle();
  }
  /// Top and height.
  [[nodiscard]] glm::vec2 level(const std::string& id) const { return {place(id).y, place(id).w}; }
  [[nodiscard]] glm::vec4 place(const std::string& id) const { return widgets().rectangles().at(id); }
  [[nodiscard]] bool said(const std::string& words) const {
    return std::ranges::any_of(state.session.messages,
                               [&](const Message& message) { return message.text.find(words) != std::string::npos; });
  }
};

TEST_F(PanelDetails, ArrowKeysInTheTreeDoNotPoseJoints) {
  open("demo.rig.json");
  click("outliner/muscle/glute L");
  for (const int key : {kDown, kUp, kUp}) {
    state.session.toast.reset();
    press(key);
    EXPECT_FALSE(state.session.toast) << state.session.toast->text;
  }
  // Elsewhere the same key is still the shortcut.
  clickAt({640.0f, 500.0f});
  state.session.toast.reset();
  press(kDown);
  EXPECT_TRUE(state.session.toast);
}

TEST_F(PanelDetails, AddingKeysKeepsTheTimelineInPlace) {
  open("demo.rig.json");
  select(state.document, {"biceps L"});
  settle();
  const glm::vec2 scrub = level("timeline/scrub");
  const glm::vec4 clip = place("timeline/clip");
  const glm::vec4 reach = place("inspector/reach");
  pointAt("inspector/reach");
  press(kKeyK);
  const std::string first = "timeline/row/reach of biceps L";
  ASSERT_TRUE(shown(first));
  EXPECT_EQ(level("timeline/scrub"), scrub);
  EXPECT_EQ(place("timeline/clip"), clip);
  EXPECT_EQ(place("inspector/reach"), reach);
  EXPECT_LT(place(first).y, clip.y);
  const glm::vec4 row = place(first);
  pointAt("inspector/amount");
  press(kKeyK);
  EXPECT_EQ(level("timeline/scrub"), scrub);
  EXPECT_TRUE(place(first) == row || place("timeline/row/amount of biceps L") == row) << "one of them is lowest";
}

TEST_F(PanelDetails, FlexSliderIsShownInSmallWindows) {
  open("humanoid-flex.rig.json");
  for (const ImVec2 size : {ImVec2{1280.0f, 800.0f}, ImVec2{900.0f, 600.0f}, ImVec2{640.0f, 480.0f}}) {
    ImGui::GetIO().DisplaySize = size;
    settle();
    ASSERT_TRUE(shown("view/flex-slider")) << size.x;
    const glm::vec4 slider = place("view/flex-slider");
    EXPECT_LE(slider.x + slider.z, state.frame.viewport.x + state.frame.viewport.z) << size.x;
    EXPECT_GE(slider.z, 60.0f) << size.x;
    if (!shown("overlay/numbers")) continue;
    const glm::vec4 numbers = place("overlay/numbers");
    EXPECT_TRUE(slider.x + slider.z < numbers.x || slider.y > numbers.y + numbers.w) << size.x;
  }
}

TEST_F(PanelDetails, MessagesFoldAfterAClickInTheViewport) {
  addMessage(state.session, MessageKind::kWarning, "look here");
  settle();
  click("messages/copy/0");
  EXPECT_TRUE(shown("messages/copy/0")) << "a press on them is not work";
  clickAt({state.frame.viewport.x + state.frame.viewport.z - 60.0f, state.frame.viewport.y + 250.0f});
  EXPECT_FALSE(shown("messages/copy/0"));
  EXPECT_TRUE(shown("status/messages")) << "still counted";
  EXPECT_EQ(state.session.messages.size(), 1u);
}

TEST_F(PanelDetails, SaveDialogListsCharactersAndNamesTheRigAfterTheChosenOne) {
  const test::TemporaryFolder own;
  fs::copy_file(fs::path(SINEW_SOURCE_DIR) / "assets" / "demo.glb", own.path() / "lizard.glb");
  addOne();
  showSaveDialog(state, {});
  state.dialogs.file.folder = own.path();
  settle();
  click("dialog/entry/lizard.glb");
  EXPECT_EQ(state.dialogs.file.text, "lizard.rig.json");
  click("dialog/ok");
  EXPECT_EQ(state.document.rigFile.filename(), "lizard.rig.json");
  EXPECT_TRUE(fs::exists(own.path() / "lizard.glb"));
}

TEST_F(PanelDetails, CharacterWithoutASkinGetsAMessage) {
  const test::TemporaryFolder own;
  test::Post post = test::makePost();
  post.file.json["nodes"][0].erase("skin");
  post.file.json.erase("skins");
  post.attributes().erase("JOINTS_0");
  post.attributes().erase("WEIGHTS_0");
  ASSERT_TRUE(writeFileAtomically(own.path() / "stiff.glb", post.file.glb()).ok());
  ASSERT_TRUE(openFile(state, own.path() / "stiff.glb"));
  EXPECT_TRUE(said("stiff.glb has no skin")) << state.session.messages.size();
  ASSERT_TRUE(openFile(state, fs::path(SINEW_SOURCE_DIR) / "assets" / "humanoid.glb"));
  EXPECT_FALSE(said("no skin"));
}

TEST_F(PanelDetails, ContextMenuResetsALineNumber) {
  open("humanoid-flex.rig.json");
  select(state.document, {"triceps L"});
  settle();
  click("inspector/line/rest", 1);
  click("context/reset");
  const int line = findLine(state.document.rig(), "triceps L");
  EXPECT_EQ(state.document.rig().lines.at(static_cast<std::size_t>(line)).settings.rest, 1.0f);
  click("inspector/line/pivot", 1);
  EXPECT_TRUE(shown("context/copy")) << "though nothing can animate it";
}

}  // namespace
}  // namespace sinew::app
