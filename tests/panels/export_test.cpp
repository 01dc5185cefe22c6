// tests/panels/export_test.cpp: File > Export through its dialogs, background jobs, and quitting during an export.

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <optional>
#include <thread>

#include "app/editor/export_commands.h"
#include "core/files/disk/atomic_file.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/temporary_folder.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargest = 1 << 28;
constexpr std::size_t kSkinned = 1;  // Index into exportKinds(): the fastest.

class ExportDialogs : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    for (const char* name : {"demo.glb", "demo.rig.json"}) {
      fs::copy_file(fs::path(SINEW_SOURCE_DIR) / "assets" / name, folder / name);
    }
    openRig("demo.rig.json");
  }
  void openRig(const std::string& name) {
    ASSERT_TRUE(openFile(state, folder / name));
    state.open.transport.playing = false;
    settle();
  }
  void openDialog() {
    run(action("file/export-character"), state);
    chooseKind(state.dialogs, kSkinned);
    settle();
    ASSERT_TRUE(shown("export/ok"));
  }
  /// Selects an export that takes an instant.
  void chooseQuick() {
    state.dialogs.exporting.settings.detail.depth = 1;
    state.dialogs.exporting.settings.weights = ExportWeights::kTransferred;
    settle();
  }
  /// Selects an export that takes seconds.
  void chooseLong() {
    state.dialogs.exporting.settings.detail.depth = 12;
    settle();
  }
  void chooseName(const std::string& name) {
    click("export/place");
    press(kKeyA, true);
    type(name);
    settle();
  }
  void start(const std::string& name, bool isLong) {
    openDialog();
    if (isLong) chooseLong();
    else chooseQuick();
    chooseName(name);
    click("export/ok");
    ASSERT_FALSE(shown("export/ok")) << state.dialogs.exporting.error;
  }
  /// Runs frames until no export is running.
  void finish() {
    while (!state.session.exports.empty()) {
      frame();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    settle();
  }
  void finishAfter(const std::function<bool()>& happens) {
    while (!happens() && !state.session.exports.empty()) {
      frame();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  [[nodiscard]] double share() const {
    const auto stands = state.session.exports.stands();
    return stands.empty() ? 1.0 : stands.front().share;
  }
  [[nodiscard]] std::string bytesOf(const fs::path& file) const { return readWholeFile(file, kLargest).value(); }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder)) all.push_back(entry.path().filename().string());
    std::ranges::sort(all);
    return all;
  }
  [[nodiscard]] std::string lastMessage() const {
    return state.session.messages.empty() ? "" : state.session.messages.back().text;
  }
  /// Runs the program in the folder.
  [[nodiscard]] int commandLine(const std::string& arguments) const {
    return std::system(("cd '" + folder.string() + "' && '" SINEW_PROGRAM "' " + arguments + " >/dev/null").c_str());
  }

  const test::TemporaryFolder own;
  const fs::path folder = own.path();
};

TEST_F(ExportDialogs, DefaultsToMuscleJointsAndMatchesTheCommandLine) {
  run(action("file/export-character"), state);
  state.dialogs.exporting.settings.detail.depth = 1;
  state.dialogs.exporting.settings.helpers = 3;
  settle();
  EXPECT_STREQ(chosenKind(state.dialogs).word, "helpers");
  click("export/advanced");
  settle();
  click("export/scale/uniform");
  EXPECT_FALSE(shown("export/weights/transferred")) << "helpers need fitted weights";
  click("export/ok");
  finish();
  ASSERT_EQ(commandLine("export demo.rig.json --depth 1 --joints 3 --joint-scale uniform -o cli.glb"), 0);
  EXPECT_EQ(bytesOf(folder / "demo_muscled.glb"), bytesOf(folder / "cli.glb"));
}

TEST_F(ExportDialogs, BakingOneClipMatchesTheCommandLine) {
  fs::create_directory(folder / "cli");  // USD names its root prim after the file.
  const auto kinds = exportKinds();
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    if (!kinds[kind].fields.oneClip) continue;
    run(action("file/export-character"), state);
    chooseKind(state.dialogs, kind);
    state.dialogs.exporting.settings.detail.depth = 1;
    settle();
    EXPECT_FALSE(shown("export/clips/chosen"));
    click("export/one-clip");
    click("export/one-clip/" + std::to_string(exportableClips(kinds[kind], state.character()).size() - 1));
    ASSERT_EQ(chosenSettings(state).clips.size(), 1u);
    click("export/ok");
    finish();
    const std::string ending = usualEnding(kinds[kind]);
    const std::string clip = exportableClips(kinds[kind], state.character()).back();
    ASSERT_TRUE(fs::exists(folder / ("demo_muscled" + ending))) << lastMessage();
    ASSERT_EQ(
        commandLine("export demo.rig.json --as baked --depth 1 --clip '" + clip + "' -o cli/demo_muscled" + ending), 0);
    EXPECT_EQ(bytesOf(folder / ("demo_muscled" + ending)), bytesOf(folder / "cli" / ("demo_muscled" + ending)));
  }
}

TEST_F(ExportDialogs, MatchesTheCommandLineAndReportsTheError) {
  start("quick", false);
  finish();
  ASSERT_TRUE(fs::exists(folder / "quick.glb")) << lastMessage();
  ASSERT_EQ(commandLine("export demo.rig.json --as skinned --depth 1 --weights transferred -o cli.glb"), 0);
  EXPECT_EQ(bytesOf(folder / "quick.glb"), bytesOf(folder / "cli.glb"));
  for (const char* word : {"quick.glb: RMS ", "% of the height, largest ", " joints; ", " KB"}) {
    EXPECT_NE(lastMessage().find(word), std::string::npos) << lastMessage();
  }
  EXPECT_FALSE(state.session.messagesShown) << "the toast has it";
  ASSERT_TRUE(state.session.toast);
  EXPECT_TRUE(state.session.toast->text.starts_with("Exported quick.glb: RMS ")) << state.session.toast->text;
}

TEST_F(ExportDialogs, RangeOfMotionIsNotExportedAsAClip) {
  run(action("play/range-of-motion"), state);
  state.open.transport.playing = false;
  start("shown", false);
  finish();
  ASSERT_EQ(commandLine("export demo.rig.json --as skinned --depth 1 --weights transferred -o cli.glb"), 0);
  EXPECT_EQ(bytesOf(folder / "shown.glb"), bytesOf(folder / "cli.glb"));
}

TEST_F(ExportDialogs, RangeOfMotionBakedToPointsMatchesTheCommandLine) {
  run(action("play/range-of-motion"), state);
  state.open.transport.playing = false;
  const auto kinds = exportKinds();
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    if (!kinds[kind].fields.oneClip) continue;
    run(action("file/export-character"), state);
    chooseKind(state.dialogs, kind);
    state.dialogs.exporting.settings.detail.depth = 1;
    state.dialogs.exporting.settings.framesPerSecond = 5.0;
    settle();
    const bool arePoints = kinds[kind].form != ExportForm::kTargets;
    EXPECT_EQ(chosenOneClip(state) == "Range of motion", arePoints) << "no glTF holds it: " << kinds[kind].title;
    if (kinds[kind].form != ExportForm::kCache) {
      press(kEscape);
      continue;
    }
    click("export/ok");
    finish();
    ASSERT_EQ(commandLine("export demo.rig.json --as baked --depth 1 --fps 5 --clip 'Range of motion' -o cli.pc2"), 0);
    EXPECT_EQ(bytesOf(folder / "demo_muscled.pc2"), bytesOf(folder / "cli.pc2"));
  }
}

TEST_F(ExportDialogs, UnsavedEditsAreExportedAndLaterEditsAreNot) {
  state.document.selection.set(state.document.idAt(0));
  deleteSelection(state);
  ASSERT_TRUE(state.document.commands.modified());
  start("edited", false);
  undo(state);
  finish();
  redo(state);
  ASSERT_TRUE(saveDocument(state.document, folder / "less.rig.json"));
  ASSERT_EQ(commandLine("export less.rig.json --as skinned --depth 1 --weights transferred -o cli.glb"), 0);
  EXPECT_EQ(bytesOf(folder / "edited.glb"), bytesOf(folder / "cli.glb"));
}

TEST_F(ExportDialogs, StartsInTheFolderOfTheRigAndRemembersChoices) {
  openDialog();
  EXPECT_EQ(state.dialogs.exporting.place.name, "demo_muscled.glb");
  EXPECT_EQ(state.dialogs.exporting.place.folder, folder);
  click("export/mesh/original");
  EXPECT_FALSE(shown("export/depth") || shown("export/tolerance")) << "nothing is divided";
  click("export/advanced");
  click("export/weights/transferred");
  chooseName("mine.glb");
  click("export/cancel");
  EXPECT_FALSE(shown("export/ok"));
  openDialog();
  EXPECT_EQ(state.dialogs.exporting.settings.mesh, ExportMesh::kOriginal);
  EXPECT_EQ(state.dialogs.exporting.settings.weights, ExportWeights::kTransferred);
  EXPECT_EQ(state.dialogs.exporting.place.name, "mine.glb");
  press(kEscape);
  fs::copy_file(folder / "demo.rig.json", folder / "other.rig.json");
  openRig("other.rig.json");
  openDialog();
  EXPECT_EQ(state.dialogs.exporting.settings.mesh, ExportMesh::kOriginal);
  EXPECT_EQ(state.dialogs.exporting.place.name, "other_muscled.glb") << "another document, another place";
}

TEST_F(ExportDialogs, ClipsAreChosenIndividuallyAndChoosingNoneIsRefused) {
  openDialog();
  chooseQuick();
  click("export/clips/chosen");
  ASSERT_EQ(chosenSettings(state).clips.size(), 1U) << "the one that is shown";
  click("export/clip/0");
  click("export/ok");
  ASSERT_TRUE(shown("export/complaint"));
  EXPECT_EQ(state.dialogs.exporting.error, "Choose a clip, or all clips");
  click("export/clip/1");
  EXPECT_FALSE(shown("export/complaint"));
  const std::string clip = chosenSettings(state).clips.at(0);
  EXPECT_EQ(clip, state.character().clips.at(1).name);
  click("export/ok");
  finish();
  ASSERT_EQ(
      commandLine("export demo.rig.json --as skinned --depth 1 --weights transferred --clip '" + clip + "' -o cli.glb"),
      0);
  EXPECT_EQ(bytesOf(folder / "demo_muscled.glb"), bytesOf(folder / "cli.glb"));
}

TEST_F(ExportDialogs, ExistingFilesAreReplacedOnlyAfterConfirmation) {
  own.write("taken.bin", "mine");
  openDialog();
  chooseQuick();
  chooseName("taken.gltf");
  click("export/ok");
  ASSERT_TRUE(shown("export/complaint")) << "the file beside it would be replaced";
  press(kEscape);
  ASSERT_TRUE(shown("export/ok")) << "Esc keeps the file, and the dialog";
  EXPECT_FALSE(shown("export/complaint"));
  EXPECT_EQ(bytesOf(folder / "taken.bin"), "mine");
  click("export/ok");
  click("export/ok");
  finish();
  EXPECT_TRUE(fs::exists(folder / "taken.gltf"));
  EXPECT_NE(bytesOf(folder / "taken.bin"), "mine");
  openDialog();
  click("export/ok");
  ASSERT_TRUE(shown("export/complaint"));
  press(kEscape);
  press(kEscape);
  EXPECT_FALSE(shown("export/ok"));
}

TEST_F(ExportDialogs, PathDialogSetsFolderAndName) {
  fs::create_directory(folder / "sub");
  openDialog();
  chooseQuick();
  click("export/place-browse");
  ASSERT_TRUE(shown("dialog/path"));
  EXPECT_FALSE(shown("export/ok"));
  press(kKeyA, true);
  type("sub/there");
  press(kEnter);
  ASSERT_TRUE(shown("export/ok"));
  EXPECT_EQ(state.dialogs.exporting.place.folder, folder / "sub");
  EXPECT_EQ(state.dialogs.exporting.place.name, "there.glb");
  click("export/place-browse");
  press(kEscape);
  ASSERT_TRUE(shown("export/ok")) << "back where one was";
  press(kEnter);
  finish();
  EXPECT_TRUE(fs::exists(folder / "sub" / "there.glb"));
}

TEST_F(ExportDialogs, EnterInANumberFieldDoesNotStartTheExport) {
  openDialog();
  typeInto("export/depth", "7");
  EXPECT_TRUE(shown("export/ok"));
  EXPECT_EQ(state.dialogs.exporting.settings.detail.depth, 7);
  EXPECT_TRUE(state.session.exports.empty());
  for (int i = 0; i < 30; ++i) frame();  // Long enough not to count as a double click.
  typeInto("export/depth", std::to_string(state.document.rig().smoothing.depth));
  EXPECT_EQ(state.dialogs.exporting.settings.detail.depth, std::nullopt) << "as in the rig";
}

TEST_F(ExportDialogs, MissingFoldersAreReportedInTheDialog) {
  openDialog();
  chooseName("absent/out.glb");
  click("export/ok");
  EXPECT_EQ(state.dialogs.exporting.error, "There is no folder " + (folder / "absent").string());
  chooseName("");
  press(kDelete);
  click("export/ok");
  EXPECT_EQ(state.dialogs.exporting.error, "It needs a name");
  EXPECT_TRUE(state.session.exports.empty());
}

TEST_F(ExportDialogs, CanceledExportLeavesNoFile) {
  const auto before = names();
  start("long.glb", true);
  finishAfter([&] { return share() > 0.05; });
  ASSERT_TRUE(shown("status/export-cancel")) << "it was done too soon for this test";
  click("status/export-cancel");
  finish();
  EXPECT_EQ(names(), before);
  EXPECT_EQ(state.session.toast->text, "Cancelled: long.glb was not written");
  EXPECT_FALSE(shown("status/export"));
}

TEST_F(ExportDialogs, ExportsRunInOrderWhileTheEditorIsUsed) {
  start("long.glb", true);
  start("next.glb", false);
  EXPECT_EQ(state.session.toast->text, "next.glb is exported next");
  const auto stands = state.session.exports.stands();
  ASSERT_EQ(stands.size(), 2U);
  EXPECT_TRUE(stands[0].running);
  EXPECT_FALSE(stands[1].running);
  const std::size_t before = steps();
  addMuscle(state, 0);
  EXPECT_EQ(steps(), before + 1);
  ASSERT_TRUE(openFile(state, fs::path(SINEW_SOURCE_DIR) / "assets" / "humanoid.rig.json"));
  settle();
  state.session.exports.cancel();
  finish();
  EXPECT_FALSE(fs::exists(folder / "long.glb"));
  ASSERT_EQ(commandLine("export demo.rig.json --as skinned --depth 1 --weights transferred -o cli.glb"), 0);
  EXPECT_EQ(bytesOf(folder / "next.glb"), bytesOf(folder / "cli.glb"));
  EXPECT_EQ(state.document.name(), "humanoid.rig.json");
}

TEST_F(ExportDialogs, QuittingPromptsAndLeavesNoFile) {
  const auto before = names();
  start("long.glb", true);
  run(action("file/quit"), state);
  settle();
  ASSERT_TRUE(shown("export-question/now"));
  click("export-question/cancel");
  EXPECT_FALSE(state.session.quit);
  EXPECT_FALSE(state.session.exports.empty());
  run(action("file/quit"), state);
  settle();
  click("export-question/now");
  EXPECT_TRUE(state.session.quit);
  state.session.exports = {};  // As the editor does on exit.
  EXPECT_EQ(names(), before);
}

TEST_F(ExportDialogs, QuittingWhenDonePromptsOnlyAboutLaterEdits) {
  for (const bool edits : {false, true}) {
    state.session.quit = false;
    start(edits ? "b.glb" : "a.glb", false);
    quitAfterExports(state);
    if (edits) addMuscle(state, 0);
    EXPECT_FALSE(state.session.quit);
    finish();
    EXPECT_EQ(state.session.quit, !edits);
    EXPECT_EQ(shown("unsaved/save"), edits);
  }
  EXPECT_TRUE(fs::exists(folder / "a.glb"));
  EXPECT_TRUE(fs::exists(folder / "b.glb"));
}

TEST_F(ExportDialogs, CharacterReplacedOnDiskIsRefused) {
  fs::copy_file(fs::path(SINEW_SOURCE_DIR) / "assets" / "horse.glb", folder / "demo.glb",
                fs::copy_options::overwrite_existing);
  start("out.glb", false);
  quitAfterExports(state);
  finish();
  EXPECT_FALSE(fs::exists(folder / "out.glb"));
  EXPECT_TRUE(lastMessage().starts_with("Not exported: ")) << lastMessage();
  EXPECT_NE(lastMessage().find("has changed since it was opened"), std::string::npos) << lastMessage();
  EXPECT_TRUE(state.session.messagesShown);
  EXPECT_FALSE(state.session.quit) << "the error is to be read";
}

}  // namespace
}  // namespace sinew::app
