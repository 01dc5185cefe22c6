// tests/panels/farm_job_test.cpp: File > Export > As a farm job writes the same file as the command line.

#include <cstdlib>

#include "app/editor/export_commands.h"
#include "core/files/disk/atomic_file.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kQuickest = 1;  // Index into exportKinds(): the fastest.

class FarmJobs : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    for (const char* name : {"demo.glb", "demo.rig.json"}) {
      fs::copy_file(fs::path(SINEW_SOURCE_DIR) / "assets" / name, folder / name);
    }
    for (const char* name : {"a b.rig.json", "#c.rig.json", "-d.rig.json", "it's.rig.json"}) {
      fs::copy_file(folder / "demo.rig.json", folder / name);
    }
    open("demo.rig.json");
  }
  void open(const std::string& name) {
    ASSERT_TRUE(openFile(state, folder / name));
    state.open.transport.playing = false;
    settle();
  }
  void openDialog() {
    run(action("file/export-farm"), state);
    settle();
    ASSERT_TRUE(shown("farm/job"));
  }
  /// Output of `sinew farm`, run in the rigs' folder.
  [[nodiscard]] std::string written(const std::string& arguments) const {
    const fs::path job = folder / "by-hand.job";
    const std::string command = "cd '" + folder.string() + "' && '" SINEW_PROGRAM "' farm " + arguments +
                                " --program '" + thisProgram() + "' --job '" + job.string() + "' >/dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    const std::string text = readWholeFile(job, 1 << 20).value();
    fs::remove(job);
    return text;
  }
  [[nodiscard]] std::string textOf(const std::string& name) const {
    return readWholeFile(folder / name, 1 << 20).value();
  }

  const test::TemporaryFolder own;
  const fs::path folder = own.path();
};

TEST_F(FarmJobs, JobForOneRigMatchesTheCommandLineForEveryFarm) {
  for (const FarmTarget& target : farmTargets()) {
    openDialog();
    EXPECT_FALSE(shown("farm/tasks")) << "one rig is one task";
    chooseTarget(state.dialogs, target);
    settle();
    click("export/ok");
    ASSERT_FALSE(shown("farm/job")) << state.dialogs.exporting.error;
    const std::string name = std::string("demo_export") + target.ending;
    EXPECT_EQ(
        textOf(name),
        written(std::string("export demo.rig.json --as helpers -o demo_muscled.glb --tasks 1 --to ") + target.word));
    EXPECT_TRUE(state.session.toast->text.starts_with("Farm job written: " + (folder / name).string()));
    fs::remove(folder / name);
  }
}

TEST_F(FarmJobs, JobContainsTheChosenSettings) {
  openDialog();
  chooseKind(state.dialogs, kQuickest);
  settle();
  click("export/mesh/original");
  click("export/clips/chosen");
  state.dialogs.exporting.settings.weights = ExportWeights::kTransferred;
  const std::string clip = chosenSettings(state).clips.at(0);
  click("export/ok");
  EXPECT_EQ(textOf("demo_export.sh"),
            written("export demo.rig.json --as skinned --mesh original --weights transferred --clip=" + clip +
                    " -o demo_muscled.glb --tasks 1 --to slurm"));
}

TEST_F(FarmJobs, JobThatReplacesFilesDoesNotResume) {
  fs::copy_file(folder / "demo.glb", folder / "demo_muscled.glb");
  openDialog();
  click("export/ok");
  ASSERT_TRUE(shown("farm/job")) << "asked first";
  click("export/ok");
  ASSERT_FALSE(shown("farm/job")) << state.dialogs.exporting.error;
  EXPECT_EQ(textOf("demo_export.sh").find("--resume"), std::string::npos);
  EXPECT_NE(state.session.toast->text.find("replaces"), std::string::npos);
}

TEST_F(FarmJobs, WholeFolderBecomesAListThatTheProgramReads) {
  openDialog();
  chooseKind(state.dialogs, kQuickest);
  settle();
  click("farm/rigs/all 5 in its folder");
  EXPECT_FALSE(shown("export/clips/chosen")) << "other rigs, other clips";
  state.dialogs.exporting.settings.detail.depth = 1;
  state.dialogs.exporting.settings.weights = ExportWeights::kTransferred;
  typeInto("farm/tasks", "2");
  chooseTarget(state.dialogs, *findFarmTarget("commands"));
  settle();
  click("export/ok");
  ASSERT_FALSE(shown("farm/job")) << state.dialogs.exporting.error;
  EXPECT_EQ(textOf("demo_export.list.txt"),
            "./#c.rig.json\n./-d.rig.json\na b.rig.json\ndemo.rig.json\nit's.rig.json\n");
  EXPECT_EQ(textOf("demo_export.txt"),
            written("export --list demo_export.list.txt --as skinned --depth 1 --weights transferred -o "
                    "'{name}_muscled.glb' --tasks 2 --to commands"));
  const std::string run = "sed \"s|'" + thisProgram() + "'|" SINEW_PROGRAM "|; s|" + thisProgram() +
                          "|" SINEW_PROGRAM "|\" '" + (folder / "demo_export.txt").string() + "' | sh >/dev/null 2>&1";
  ASSERT_EQ(std::system(run.c_str()), 0) << run;
  for (const char* name : {"#c", "-d", "a b", "demo", "it's"}) {
    EXPECT_TRUE(fs::exists(folder / (std::string(name) + "_muscled.glb"))) << name;
  }
}

TEST_F(FarmJobs, UnexportableRigIsRefused) {
  own.write("broken.rig.json", "{}");
  openDialog();
  chooseKind(state.dialogs, kQuickest);
  settle();
  click("farm/rigs/all 6 in its folder");
  click("export/ok");
  EXPECT_NE(state.dialogs.exporting.error.find("broken.rig.json"), std::string::npos) << state.dialogs.exporting.error;
  EXPECT_FALSE(fs::exists(folder / "demo_export.sh"));
}

TEST_F(FarmJobs, PatternNeedsTheNameAndExistingFilesNeedConfirmation) {
  own.write("demo_export.list.txt", "mine");
  openDialog();
  chooseKind(state.dialogs, kQuickest);
  settle();
  click("farm/rigs/all 5 in its folder");
  state.dialogs.exporting.pattern.name = "all.glb";
  click("export/ok");
  EXPECT_NE(state.dialogs.exporting.error.find("{name}"), std::string::npos);
  state.dialogs.exporting.pattern.name = "{name}_x.glb";
  click("export/ok");
  ASSERT_TRUE(state.dialogs.exporting.overwriteAsked);
  EXPECT_EQ(textOf("demo_export.list.txt"), "mine");
  click("export/ok");
  EXPECT_NE(textOf("demo_export.list.txt"), "mine");
}

TEST_F(FarmJobs, UnsavedRigHasNoJob) {
  EXPECT_TRUE(action("file/export-farm").enabled(state));
  state.document.selection.set(state.document.idAt(0));
  deleteSelection(state);
  EXPECT_STREQ(action("file/export-farm").enabled(state).reason(), "Save the rig first");
  undo(state);
  EXPECT_TRUE(action("file/export-farm").enabled(state));
  open("demo.glb");
  EXPECT_FALSE(action("file/export-farm").enabled(state));
}

}  // namespace
}  // namespace sinew::app
