// tests/panels/pictures_test.cpp: File > Export > Turntable or contact sheet: its `sinew render` options, its dialog
// and the written file.

#include "app/editor/picture_commands.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>

#include "app/document/farm_job.h"
#include "app/editor/actions.h"
#include "app/editor/export_commands.h"
#include "app/ui/offscreen.h"
#include "core/files/disk/atomic_file.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

class PicturesDialog : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    const fs::path assets = fs::path(SINEW_SOURCE_DIR) / "assets";
    for (const char* name : {"demo.glb", "demo.rig.json"}) fs::copy_file(assets / name, folder / name);
    ASSERT_TRUE(openFile(state, folder / "demo.rig.json"));
    state.open.transport.playing = false;
    state.open.transport.time = 0.25;
    settle();
    run(action("file/export-pictures"), state);
    settle();
    ASSERT_TRUE(shown("pictures/ok"));
    state.dialogs.pictures.size = {64, 48};
  }
  [[nodiscard]] std::string words() const {
    std::string all;
    for (const std::string& word : pictureArguments(state)) all += shellWord(word) + ' ';
    return all;
  }
  [[nodiscard]] bool says(const std::string& part) const { return words().find(part + ' ') != std::string::npos; }
  [[nodiscard]] std::string bytes(const fs::path& file) const {
    const auto read = readWholeFile(file, 1u << 26);
    return read ? read.value() : "";
  }
  /// Waits until nothing is being drawn.
  void wait() {
    for (int i = 0; i < 600 && !state.session.exports.empty(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      frame();
    }
    ASSERT_TRUE(state.session.exports.empty());
  }
  /// File that the command line makes of the saved rig.
  [[nodiscard]] std::string fromCommandLine(const std::string& name) const {
    const fs::path file = folder / name;
    const std::string command = shellWord(SINEW_PROGRAM) + " render " + shellWord((folder / "demo.rig.json").string()) +
                                ' ' + words() + "-o " + shellWord(file.string()) + " > /dev/null 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    return bytes(file);
  }
  static bool canDraw() { return OffscreenContext::create().ok(); }

  const test::TemporaryFolder own;
  const fs::path folder = own.path();
};

TEST_F(PicturesDialog, CommandMatchesTheCurrentView) {
  const std::string clip = state.character().clips[static_cast<std::size_t>(state.open.transport.clip)].name;
  EXPECT_TRUE(says("--clip " + shellWord(clip) + " --time 0.25 --fps 24 --turntable 72 --size 64x48")) << words();
  EXPECT_TRUE(says("--shading textured")) << words();
  state.view.display.anatomy = state.view.display.wire = true;
  state.view.display.glass = 0.5f;
  state.view.display.ground = false;
  state.view.tools.camera.transition.reset();
  state.view.tools.camera.stand.yaw = -0.5f;
  state.view.tools.camera.orthographic = true;
  EXPECT_TRUE(says("--show muscles,wire --glass 0.5 --no-ground")) << words();
  EXPECT_TRUE(says("--orthographic")) << words();
  EXPECT_NE(words().find("--view=-28.6,"), std::string::npos) << words();
  state.open.transport.clip = -1;
  EXPECT_FALSE(says("--clip")) << words();
  state.dialogs.pictures.plays = true;
  EXPECT_TRUE(says("--turntable 72")) << "nothing plays in the bind pose: " << words();
}

TEST_F(PicturesDialog, ShowsThePictureCountBeforeRendering) {
  typeInto("pictures/turns", "36");
  typeInto("pictures/rate", "12");
  EXPECT_EQ(pictureCount(state), 36);
  EXPECT_EQ(turntableSeconds(state), 3.0);
  click("pictures/motion/clip plays");
  const auto& clip = state.character().clips[static_cast<std::size_t>(state.open.transport.clip)];
  EXPECT_EQ(pictureCount(state), static_cast<int>(double{clip.duration} * 12.0 + 1e-3) + 1);
  EXPECT_FALSE(shown("pictures/turns"));
  EXPECT_TRUE(says("--turntable " + std::to_string(pictureCount(state)))) << words();
  click("pictures/what/contact sheet");
  typeInto("pictures/columns", "5");
  typeInto("pictures/rows", "3");
  EXPECT_TRUE(says("--sheet 5x3")) << words();
  EXPECT_TRUE(says("--time 0.25")) << "of all sides: " << words();
  click("pictures/shows/the clip");
  EXPECT_FALSE(says("--time 0.25")) << "of the clip: " << words();
  EXPECT_EQ(state.dialogs.pictures.sheetPlace.name, "demo_sheet.png");
}

TEST_F(PicturesDialog, NamesFollowTheFormat) {
  PicturesDialogState& dialog = state.dialogs.pictures;
  EXPECT_EQ(picturesFile(dialog), folder / "demo_turntable.webp");
  click("pictures/format/.gif");
  EXPECT_EQ(picturesFile(dialog), folder / "demo_turntable.gif");
  dialog.turntable.name = "around";
  EXPECT_EQ(picturesFile(dialog), folder / "around.gif");
  click("pictures/place-browse");
  ASSERT_TRUE(shown("dialog/path"));
  press(kKeyA, true);
  type("other.webp");
  press(kEnter);
  ASSERT_TRUE(shown("pictures/ok"));
  EXPECT_EQ(picturesFile(dialog), folder / "other.webp");
  EXPECT_EQ(dialog.ending, ".webp");
}

TEST_F(PicturesDialog, ReportsErrorsAndConfirmsBeforeReplacing) {
  PicturesDialogState& dialog = state.dialogs.pictures;
  dialog.turntable.name = "nowhere/x.webp";
  click("pictures/ok");
  EXPECT_TRUE(shown("pictures/complaint"));
  EXPECT_NE(dialog.error.find("no folder"), std::string::npos) << dialog.error;
  dialog.turntable.name = "";
  click("pictures/ok");
  EXPECT_NE(dialog.error.find("name"), std::string::npos) << dialog.error;
  dialog.turntable.name = "there.webp";
  ASSERT_TRUE(writeFileAtomically(folder / "there.webp", "before"));
  click("pictures/ok");
  EXPECT_TRUE(dialog.overwriteAsked);
  click("pictures/cancel");
  EXPECT_FALSE(dialog.overwriteAsked);
  EXPECT_TRUE(dialog.shown) << "it was Keep";
  dialog.sheet = true;
  dialog.size = {4096, 64};
  dialog.cells = {5, 1};
  settle();
  click("pictures/ok");
  EXPECT_NE(dialog.error.find("16,384 pixels wide"), std::string::npos) << dialog.error;
  press(kEscape);
  EXPECT_FALSE(dialog.shown);
  EXPECT_TRUE(state.session.exports.empty());
  EXPECT_EQ(bytes(folder / "there.webp"), "before");
}

TEST_F(PicturesDialog, SheetMatchesTheCommandLineDespiteLaterEdits) {
  if (!canDraw()) GTEST_SKIP() << "left out: no OpenGL";
  state.dialogs.pictures.sheet = true;
  state.dialogs.pictures.cells = {2, 2};
  settle();
  const std::string expected = fromCommandLine("cli.png");
  ASSERT_FALSE(expected.empty());
  click("pictures/ok");
  EXPECT_FALSE(state.dialogs.pictures.shown);
  ASSERT_EQ(state.session.exports.stands().size(), 1u);
  addMuscle(state, 0);
  wait();
  EXPECT_EQ(bytes(folder / "demo_sheet.png"), expected);
  ASSERT_TRUE(state.session.toast);
  EXPECT_NE(state.session.toast->text.find("demo_sheet.png"), std::string::npos);
}

TEST_F(PicturesDialog, TurntableIsRenderedAndCanBeCanceled) {
  if (!canDraw()) GTEST_SKIP() << "left out: no OpenGL";
  state.dialogs.pictures.turns = 3;
  const std::string expected = fromCommandLine("cli.webp");
  click("pictures/ok");
  wait();
  EXPECT_EQ(bytes(folder / "demo_turntable.webp"), expected);
  run(action("file/export-pictures"), state);
  settle();
  state.dialogs.pictures.turns = kMostTurntable;
  state.dialogs.pictures.turntable.name = "long.webp";
  settle();
  click("pictures/ok");
  state.session.exports.cancel();
  wait();
  EXPECT_FALSE(fs::exists(folder / "long.webp"));
  ASSERT_TRUE(state.session.toast);
  EXPECT_NE(state.session.toast->text.find("long.webp was not written"), std::string::npos)
      << state.session.toast->text;
}

TEST(PictureJob, FailureIsOneLineAndLeavesNoFiles) {
  const test::TemporaryFolder folder;
  fs::path gone;
  {
    const auto made = JobFolder::make();
    ASSERT_TRUE(made);
    gone = made.value()->path();
    ASSERT_TRUE(writeFileAtomically(gone / "bad.rig.json", "{ not json"));
    const PictureJob job{made.value(), SINEW_PROGRAM, "bad.rig.json", {"--sheet", "2x2"}};
    const auto go = [](double) { return true; };
    const Result<void> failed = runPictureJob(job, folder.path() / "x.png", go);
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().file, (folder.path() / "x.png").string());
    EXPECT_TRUE(failed.error().reason.starts_with("bad.rig.json: ")) << failed.error().reason;
    EXPECT_EQ(failed.error().reason.find('\n'), std::string::npos);
    const PictureJob missing{made.value(), "/no/such/program", "bad.rig.json", {}};
    EXPECT_FALSE(runPictureJob(missing, folder.path() / "x.png", go));
    const PictureJob canceled{made.value(), SINEW_PROGRAM, "bad.rig.json", {}};
    const Result<void> stopped = runPictureJob(canceled, folder.path() / "x.png", [](double) { return false; });
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().reason, kCanceled);
  }
  EXPECT_FALSE(fs::exists(gone));
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace
}  // namespace sinew::app
