// tests/panels/dialogs_test.cpp: palette, key sheet, preferences, recovery, messages and files, by mouse and keyboard.

#include "app/editor/edit.h"
#include "tests/support/editor/headless_editor.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cstdlib>
#include <fstream>

#include "app/editor/session.h"
#include "app/ui/data_files.h"
#include "tests/support/editor/muscles_named.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

class DialogBoxes : public HeadlessEditor {
 protected:
  void palette(const std::string& query) {
    press(GLFW_KEY_P, true);
    ASSERT_TRUE(shown("palette/query"));
    type(query);
  }
  /// Drops the messages so far, so that only new ones count.
  void quiet() {
    state.session.messages.clear();
    settle();
  }
  const test::TemporaryFolder own;
  const fs::path folder = own.path();
};

TEST_F(DialogBoxes, PaletteRunsTheTypedActionFromTheKeyboard) {
  const bool wire = state.view.display.wire;
  palette("wire");
  EXPECT_TRUE(shown("palette/view/wire"));
  press(kEnter);
  EXPECT_FALSE(state.dialogs.palette.shown);
  EXPECT_NE(state.view.display.wire, wire);
  EXPECT_EQ(state.session.preferences.recentActions.front(), "view/wire");
  palette("");
  press(kEnter);
  EXPECT_EQ(state.view.display.wire, wire) << "what was used last comes first";
}

TEST_F(DialogBoxes, ArrowKeysMoveThroughThePaletteAndEscapeCancels) {
  palette("frame");
  EXPECT_EQ(state.dialogs.palette.chosen, -1) << "none by hand";
  press(GLFW_KEY_DOWN);
  EXPECT_EQ(state.dialogs.palette.chosen, 1) << "the one after the best";
  press(GLFW_KEY_UP);
  press(GLFW_KEY_UP);
  EXPECT_GT(state.dialogs.palette.chosen, 1) << "round to the last";
  press(kEscape);
  EXPECT_FALSE(state.dialogs.palette.shown);
  EXPECT_TRUE(state.session.preferences.recentActions.empty());
}

TEST_F(DialogBoxes, PaletteJumpsToMusclesBonesAndSamples) {
  addOne();
  const std::string name = muscle().name;
  state.document.selection.clear();
  palette(name);
  press(kEnter);
  EXPECT_EQ(state.document.activeName(), name);
  const std::string bone = state.character().skeleton.bones[3].name;
  palette(bone + " bone");
  press(kEnter);
  EXPECT_GE(state.document.selection.bone, 0);
  state.document.commands.markSaved();
  palette("lizard sample");
  press(kEnter);
  EXPECT_EQ(state.document.rigFile.filename(), "demo.rig.json");
}

TEST_F(DialogBoxes, UnavailableActionLeavesThePaletteOpen) {
  palette("undo");
  press(kEnter);
  EXPECT_TRUE(state.dialogs.palette.shown);
  type("x");
  EXPECT_NE(state.dialogs.palette.query.find('x'), std::string::npos) << "the field listens on";
  press(kEscape);
  EXPECT_FALSE(state.dialogs.palette.shown);
}

TEST_F(DialogBoxes, KeySheetShowsAndChangesTheKeymap) {
  press(GLFW_KEY_F1);
  ASSERT_TRUE(shown("keys/close"));
  click("keys/blender");
  EXPECT_EQ(state.session.preferences.keymap, Keymap::kBlender);
  press(GLFW_KEY_F1);
  EXPECT_FALSE(state.dialogs.keySheet);
  addOne();
  press(GLFW_KEY_X);
  EXPECT_TRUE(state.document.rig().primitives.empty());
}

TEST_F(DialogBoxes, PreferencesAreSetAndEscapeClosesTheListFirst) {
  press(GLFW_KEY_COMMA, true);
  ASSERT_TRUE(shown("preferences/close"));
  click("preferences/keymap/blender");
  EXPECT_EQ(state.session.preferences.keymap, Keymap::kBlender);
  click("preferences/surface/graphics card");
  EXPECT_EQ(state.session.preferences.surfaceBy, SurfaceBy::kCard);
  click("preferences/scale");
  ASSERT_TRUE(shown("preferences/scale/3"));
  press(kEscape);
  EXPECT_TRUE(state.dialogs.preferences);
  click("preferences/scale");
  click("preferences/scale/3");
  EXPECT_EQ(state.session.preferences.scale, 1.5f);
  drag("preferences/autosave", {-60.0f, 0.0f});
  EXPECT_LT(state.session.preferences.autosaveSeconds, 30.0);
  state.view.layout.left = 400.0f;
  click("preferences/reset-layout");
  EXPECT_EQ(state.view.layout.left, LayoutState{}.left);
  press(kEscape);
  EXPECT_FALSE(state.dialogs.preferences);
}

TEST_F(DialogBoxes, PanelsAreResizedHiddenAndRestored) {
  const float before = state.view.layout.bottom;
  drag("layout/bottom", {0.0f, -50.0f});
  EXPECT_NEAR(state.view.layout.bottom, before + 50.0f, 1.0f);
  drag("layout/left", {40.0f, 0.0f});
  EXPECT_GT(state.view.layout.left, LayoutState{}.left);
  press(GLFW_KEY_T);
  EXPECT_FALSE(shown("outliner/search"));
  EXPECT_FALSE(shown("layout/left"));
  EXPECT_EQ(state.frame.viewport.x, 0.0f);
  press(GLFW_KEY_SPACE, true);
  EXPECT_FALSE(state.view.layout.rightShown || state.view.layout.bottomShown || state.view.layout.leftShown);
  EXPECT_EQ(state.frame.viewport.z, 1280.0f);
  press(GLFW_KEY_SPACE, true);
  EXPECT_TRUE(state.view.layout.rightShown && state.view.layout.bottomShown && state.view.layout.leftShown);
  click("surface/header");
  EXPECT_FALSE(shown("surface/mode"));
  EXPECT_EQ(state.view.layout.folded, std::vector<std::string>{"surface"});
  click("surface/header");
  EXPECT_TRUE(shown("surface/mode"));
  EXPECT_TRUE(state.view.layout.folded.empty());
}

TEST_F(DialogBoxes, MessagesStayUntilDismissedAndAreCountedInTheStatusBar) {
  quiet();
  EXPECT_FALSE(shown("status/messages"));
  addMessage(state.session, MessageKind::kNote, "left out");
  addMessage(state.session, MessageKind::kError, "not saved");
  settle();
  EXPECT_TRUE(shown("messages/dismiss/1") && shown("status/messages"));
  click("messages/hide");
  EXPECT_FALSE(shown("messages/dismiss/0"));
  EXPECT_TRUE(shown("status/messages"));
  EXPECT_EQ(state.session.messages.size(), 2u);
  click("status/messages");
  click("messages/copy/1");
  EXPECT_STREQ(ImGui::GetClipboardText(), "not saved");
  click("messages/copy-all");
  EXPECT_STREQ(ImGui::GetClipboardText(), "note: left out\nerror: not saved\n");
  click("messages/dismiss/0");
  EXPECT_EQ(state.session.messages.size(), 1u);
  click("messages/hide");
  addMessage(state.session, MessageKind::kWarning, "another");
  settle();
  EXPECT_TRUE(shown("messages/dismiss/0")) << "a new one shows itself";
  click("messages/dismiss-all");
  EXPECT_TRUE(state.session.messages.empty());
}

TEST_F(DialogBoxes, RecoveryIsOfferedAndLaterKeepsTheFile) {
  Document lost = openDocument(fs::path(SINEW_SOURCE_DIR) / "assets" / "demo.rig.json").value();
  Rig rig = lost.rig();
  rig.primitives.pop_back();
  lost.commands.apply("Lost", rig);
  {
    Result<RecoveryFile> crashed = RecoveryFile::claim(folder);
    ASSERT_TRUE(crashed.ok() && crashed.value().write(lost).ok());
  }
  state.session.leftBehind = findLeftBehind(folder);
  ASSERT_EQ(state.session.leftBehind.size(), 1u);
  state.dialogs.recovery = true;
  settle();
  click("recovery/later");
  EXPECT_FALSE(state.dialogs.recovery);
  EXPECT_EQ(findLeftBehind(folder).size(), 1u);
  state.dialogs.recovery = true;
  settle();
  click("recovery/recover/0");
  EXPECT_FALSE(state.dialogs.recovery);
  EXPECT_TRUE(state.document.commands.modified());
  EXPECT_EQ(state.document.rig().primitives.size(), rig.primitives.size());
  EXPECT_EQ(state.document.rigFile.filename(), "demo.rig.json");
}

TEST_F(DialogBoxes, RecoveryPromptsBeforeDiscardingUnsavedChanges) {
  {
    Document lost = openDocument(fs::path(SINEW_SOURCE_DIR) / "assets" / "demo.glb").value();
    Result<RecoveryFile> crashed = RecoveryFile::claim(folder);
    ASSERT_TRUE(crashed.ok() && crashed.value().write(lost).ok());
  }
  addOne();
  state.session.leftBehind = findLeftBehind(folder);
  state.dialogs.recovery = true;
  settle();
  click("recovery/recover/0");
  ASSERT_TRUE(shown("unsaved/cancel"));
  click("unsaved/cancel");
  EXPECT_EQ(state.document.rig().primitives.size(), 1u);
  EXPECT_EQ(state.session.leftBehind.size(), 1u);
}

TEST_F(DialogBoxes, FilesAreFoundFromTheKeyboard) {
  fs::create_directory(folder / "animals");
  fs::copy_file(fs::path(SINEW_SOURCE_DIR) / "assets" / "demo.glb", folder / "animals" / "lizard.glb");
  showOpenDialog(state);
  state.dialogs.file.folder = folder;
  settle();
  type("an");
  press(GLFW_KEY_TAB);
  EXPECT_EQ(state.dialogs.file.text, "animals/");
  press(kEnter);
  EXPECT_EQ(state.dialogs.file.folder, folder / "animals");
  press(GLFW_KEY_DOWN);
  EXPECT_EQ(state.dialogs.file.text, "lizard.glb");
  press(kEnter);
  EXPECT_EQ(state.dialogs.file.kind, DialogKind::kNone);
  EXPECT_EQ(state.document.characterFile, folder / "animals" / "lizard.glb");
}

TEST_F(DialogBoxes, FileBrowserGoesBackForwardAndUp) {
  fs::create_directory(folder / "animals");
  showOpenDialog(state);
  state.dialogs.file.folder = folder;
  settle();
  click("dialog/entry/animals");
  EXPECT_EQ(state.dialogs.file.folder, folder / "animals");
  click("dialog/back");
  EXPECT_EQ(state.dialogs.file.folder, folder);
  click("dialog/forward");
  EXPECT_EQ(state.dialogs.file.folder, folder / "animals");
  click("dialog/up");
  EXPECT_EQ(state.dialogs.file.folder, folder);
  click("dialog/place/root");
  EXPECT_EQ(state.dialogs.file.folder, "/");
  click("dialog/new-folder");
  ASSERT_TRUE(shown("dialog/new-folder-name"));
  press(kEscape);
  EXPECT_EQ(state.dialogs.file.kind, DialogKind::kOpen) << "Esc ends the naming alone";
  press(kEscape);
  EXPECT_EQ(state.dialogs.file.kind, DialogKind::kNone);
}

TEST_F(DialogBoxes, NewFolderIsCreatedAndEntered) {
  showOpenDialog(state);
  state.dialogs.file.folder = folder;
  settle();
  click("dialog/new-folder");
  type("rigs");
  press(kEnter);
  EXPECT_TRUE(fs::is_directory(folder / "rigs"));
  EXPECT_EQ(state.dialogs.file.folder, folder / "rigs");
}

TEST_F(DialogBoxes, ExistingFileIsReplacedOnlyAfterConfirmation) {
  addOne();
  std::ofstream(folder / "old.rig.json") << "precious";
  showSaveDialog(state, {});
  state.dialogs.file.folder = folder;
  state.dialogs.file.text = "old";
  settle();
  click("dialog/ok");
  EXPECT_TRUE(state.dialogs.file.overwriteAsked);
  EXPECT_EQ(fs::file_size(folder / "old.rig.json"), 8u);
  click("dialog/cancel");
  EXPECT_FALSE(state.dialogs.file.overwriteAsked);
  EXPECT_EQ(state.dialogs.file.kind, DialogKind::kSaveAs);
  click("dialog/ok");
  click("dialog/ok");
  EXPECT_EQ(state.dialogs.file.kind, DialogKind::kNone);
  EXPECT_EQ(state.document.rigFile, folder / "old.rig.json");
  EXPECT_FALSE(state.document.commands.modified());
}

TEST_F(DialogBoxes, FailedSaveKeepsTheDocumentModified) {
  addOne();
  quiet();
  EXPECT_NE(saveTo(state, "/proc/sinew-test.rig.json"), "");
  EXPECT_TRUE(state.document.commands.modified());
  ASSERT_EQ(state.session.messages.size(), 1u);
  EXPECT_EQ(state.session.messages[0].kind, MessageKind::kError);
}

TEST_F(DialogBoxes, RecentFilesAndSamplesAreInTheMenu) {
  fs::copy_file(fs::path(SINEW_SOURCE_DIR) / "assets" / "demo.glb", folder / "lizard.glb");
  state.session.preferences.recentFiles = {folder / "lizard.glb", folder / "gone.glb"};
  click("menu/file");
  click("file/recent");
  ASSERT_TRUE(shown("file/recent/0") && shown("file/recent/1"));
  click("file/recent/1");
  EXPECT_NE(state.document.characterFile, folder / "gone.glb");
  click("file/recent/0");
  EXPECT_EQ(state.document.characterFile, folder / "lizard.glb");
  click("menu/file");
  click("file/samples");
  EXPECT_TRUE(shown("file/samples/0"));
  click("file/samples/0");
  EXPECT_TRUE(isSample(state.document.rigFile.empty() ? state.document.characterFile : state.document.rigFile));
}

TEST_F(DialogBoxes, AutoDepthIsToggledInTheOverlay) {
  const bool before = state.document.rig().smoothing.autoDepth;
  EXPECT_FALSE(shown("overlay/auto-depth")) << "the numbers begin with the few that say most";
  click("overlay/fold");
  EXPECT_TRUE(state.view.layout.stages);
  click("overlay/auto-depth");
  EXPECT_NE(state.document.rig().smoothing.autoDepth, before);
  press(kKeyZ, true);
  EXPECT_EQ(state.document.rig().smoothing.autoDepth, before);
}

}  // namespace
}  // namespace sinew::app
