// tests/editor/session_test.cpp: state kept from one session to the next, after a clean exit and after a crash.

#include "app/editor/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <optional>

#include "app/editor/commands.h"
#include "app/editor/open_file.h"
#include "app/window/session_keeper.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/editor/muscles_named.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

constexpr WindowPlace kPlace{10, 20, 1280, 800, false};

class Session : public testing::Test {
 protected:
  void SetUp() override {
    fs::copy_file(fs::path(SINEW_SOURCE_DIR) / "assets" / "demo.glb", folder / "lizard.glb");
    fs::copy_file(fs::path(SINEW_SOURCE_DIR) / "assets" / "demo.glb", folder / "other.glb");
  }

  [[nodiscard]] SessionKeeper keeper() const { return {folder / "preferences.json", folder / "recovery"}; }
  [[nodiscard]] Preferences onDisk() const { return loadPreferences(folder / "preferences.json").preferences; }
  void open(EditorState& state, const char* name) const { ASSERT_TRUE(openFile(state, folder / name)); }
  static void change(EditorState& state) { addMuscle(state, 0); }
  [[nodiscard]] std::size_t filesOfRecovery() const {
    const fs::directory_iterator files(folder / "recovery");
    return static_cast<std::size_t>(
        std::count_if(begin(files), end(files), [](const auto& each) { return each.path().extension() == ".json"; }));
  }

  const test::TemporaryFolder own;
  const fs::path folder = own.path();
};

TEST_F(Session, SettingsAreRestoredAtTheNextStart) {
  EditorState first;
  SessionKeeper one = keeper();
  one.start(first);
  open(first, "lizard.glb");
  first.view.layout.left = 333.0f;
  first.session.preferences.keymap = Keymap::kBlender;
  one.tick(first, 0.0, kPlace);
  EXPECT_EQ(onDisk(), Preferences{}) << "written before it rests";
  one.tick(first, 2.0, kPlace);
  EXPECT_EQ(onDisk().layout.left, 333.0f);
  first.view.layout.right = 222.0f;
  one.finish(first, kPlace);
  EditorState second;
  keeper().start(second);
  EXPECT_EQ(second.view.layout.left, 333.0f);
  EXPECT_EQ(second.view.layout.right, 222.0f) << "set right before the end";
  EXPECT_EQ(second.session.preferences.keymap, Keymap::kBlender);
  EXPECT_EQ(second.session.preferences.window, kPlace);
  EXPECT_EQ(second.session.preferences.recentFiles, std::vector<fs::path>{folder / "lizard.glb"});
  EXPECT_FALSE(second.dialogs.recovery);
  EXPECT_TRUE(second.session.messages.empty());
}

TEST_F(Session, DamagedPreferencesGiveAMessageAndDefaults) {
  std::ofstream(folder / "preferences.json") << "{ broken";
  EditorState state;
  keeper().start(state);
  ASSERT_EQ(state.session.messages.size(), 1u);
  EXPECT_NE(state.session.messages[0].text.find("preferences.json.bad"), std::string::npos)
      << state.session.messages[0].text;
  EXPECT_EQ(state.view.layout, LayoutState{});
  EXPECT_TRUE(fs::exists(folder / "preferences.json.bad"));
}

TEST_F(Session, RecentFilesOfTwoEditorsAreMerged) {
  EditorState first;
  EditorState second;
  SessionKeeper one = keeper();
  SessionKeeper two = keeper();
  one.start(first);
  two.start(second);
  open(first, "lizard.glb");
  one.tick(first, 0.0, kPlace);
  one.tick(first, 2.0, kPlace);
  open(second, "other.glb");
  two.tick(second, 3.0, kPlace);
  two.tick(second, 5.0, kPlace);
  EXPECT_EQ(onDisk().recentFiles, (std::vector<fs::path>{folder / "other.glb", folder / "lizard.glb"}));
}

TEST_F(Session, TwoWindowsKeepEachOthersSettings) {
  EditorState first;
  EditorState second;
  SessionKeeper one = keeper();
  SessionKeeper two = keeper();
  one.start(first);
  two.start(second);
  open(first, "lizard.glb");
  open(second, "other.glb");
  second.session.preferences.keymap = Keymap::kBlender;
  two.tick(second, 0.0, kPlace);
  two.tick(second, 2.0, kPlace);
  first.view.layout.left = 333.0f;  // It knows neither the keymap nor the other file.
  one.tick(first, 3.0, kPlace);
  one.tick(first, 5.0, kPlace);
  second.view.layout.left = 264.0f;
  two.finish(second, kPlace);
  one.finish(first, kPlace);
  EXPECT_EQ(onDisk().keymap, Keymap::kBlender);
  EXPECT_EQ(onDisk().layout.left, 333.0f);
  EXPECT_EQ(onDisk().recentFiles, (std::vector<fs::path>{folder / "lizard.glb", folder / "other.glb"}));
}

TEST_F(Session, TwoWindowsOnOneRigLeaveTwoRecoveryFiles) {
  {
    EditorState first;
    EditorState second;
    SessionKeeper one = keeper();
    SessionKeeper two = keeper();
    one.start(first);
    two.start(second);
    open(first, "lizard.glb");
    ASSERT_EQ(saveTo(first, folder / "arm.rig.json"), "");
    open(second, "arm.rig.json");
    change(first);
    change(second);
    change(second);
    for (double now = 0.0; now < 70.0; now += 10.0) {
      one.tick(first, now, kPlace);
      two.tick(second, now, kPlace);
    }
  }
  std::vector<LeftBehind> left = findLeftBehind(folder / "recovery");
  ASSERT_EQ(left.size(), 2u);
  std::vector<int> muscles{left[0].primitives, left[1].primitives};
  std::ranges::sort(muscles);
  EXPECT_EQ(muscles, (std::vector<int>{1, 2}));
}

TEST_F(Session, SavingRecoveredWorkPromptsIfTheFileChangedSince) {
  {
    EditorState lost;
    SessionKeeper one = keeper();
    one.start(lost);
    open(lost, "lizard.glb");
    ASSERT_EQ(saveTo(lost, folder / "arm.rig.json"), "");
    change(lost);
    one.tick(lost, 0.0, kPlace);
    one.tick(lost, 31.0, kPlace);
  }
  EditorState other;
  open(other, "arm.rig.json");
  EditorState state;
  SessionKeeper two = keeper();
  two.start(state);
  ASSERT_EQ(state.session.leftBehind.size(), 1u);
  const fs::path left = state.session.leftBehind[0].file;
  change(other);
  change(other);
  ASSERT_TRUE(save(other, {}));  // After the crash, before the recovery.
  request(state, {IntentKind::kRecover, left});
  EXPECT_FALSE(save(state, {}));
  EXPECT_EQ(state.dialogs.conflict.found, OnDisk::kChanged);
}

TEST_F(Session, SaveAsRemembersTheNewFileButSamplesAreNotRemembered) {
  EditorState state;
  SessionKeeper one = keeper();
  one.start(state);
  ASSERT_TRUE(openFile(state, fs::path(SINEW_SOURCE_DIR) / "assets" / "demo.rig.json"));
  one.tick(state, 0.0, kPlace);
  EXPECT_TRUE(state.session.preferences.recentFiles.empty());
  ASSERT_EQ(saveTo(state, folder / "mine.rig.json"), "");
  one.tick(state, 1.0, kPlace);
  EXPECT_EQ(state.session.preferences.recentFiles, std::vector<fs::path>{folder / "mine.rig.json"});
}

TEST_F(Session, CrashedWorkIsOfferedAndProtectedOnceRecovered) {
  {
    EditorState lost;
    SessionKeeper one = keeper();
    one.start(lost);
    open(lost, "lizard.glb");
    change(lost);
    one.tick(lost, 100.0, kPlace);
    one.tick(lost, 131.0, kPlace);
  }  // Destroyed without finish(), as a killed process would be.
  EditorState state;
  SessionKeeper two = keeper();
  two.start(state);
  ASSERT_TRUE(state.dialogs.recovery);
  ASSERT_EQ(state.session.leftBehind.size(), 1u);
  const fs::path left = state.session.leftBehind[0].file;
  request(state, {IntentKind::kRecover, left});
  ASSERT_TRUE(state.hasCharacter());
  EXPECT_EQ(state.document.rig().primitives.size(), 1u);
  EXPECT_TRUE(state.document.commands.modified());
  EXPECT_TRUE(fs::exists(left)) << "thrown away before there is another copy";
  two.tick(state, 200.0, kPlace);
  EXPECT_FALSE(fs::exists(left));
  EXPECT_FALSE(state.session.recovered.has_value());
  {
    EditorState third;  // A second instance: nothing to recover, since the owner of the work is alive.
    keeper().start(third);
    EXPECT_FALSE(third.dialogs.recovery);
  }
  two.finish(state, kPlace);
  EXPECT_TRUE(findLeftBehind(folder / "recovery").empty());
}

TEST_F(Session, SavedWorkIsNotOffered) {
  {
    EditorState state;
    SessionKeeper one = keeper();
    one.start(state);
    open(state, "lizard.glb");
    change(state);
    one.tick(state, 100.0, kPlace);
    one.tick(state, 131.0, kPlace);
    ASSERT_EQ(saveTo(state, folder / "saved.rig.json"), "");
    one.tick(state, 132.0, kPlace);
  }
  EditorState next;
  keeper().start(next);
  EXPECT_FALSE(next.dialogs.recovery);
}

TEST_F(Session, FailedSaveWritesTheRecoveryFileImmediately) {
  fs::create_directory(folder / "taken.rig.json");
  Rig unsaved;
  {
    EditorState lost;
    SessionKeeper one = keeper();
    one.start(lost);
    open(lost, "lizard.glb");
    ASSERT_EQ(saveTo(lost, folder / "arm.rig.json"), "");
    change(lost);
    one.tick(lost, 100.0, kPlace);
    EXPECT_EQ(filesOfRecovery(), 0U) << "the interval is not over";
    EXPECT_NE(saveTo(lost, folder / "taken.rig.json"), "") << "a folder has that name";
    one.tick(lost, 100.0, kPlace);
    EXPECT_EQ(filesOfRecovery(), 1U);
    unsaved = lost.document.rig();
    change(lost);
    one.tick(lost, 101.0, kPlace);  // From here on at every interval: this change is not in the file yet.
  }
  const std::vector<LeftBehind> left = findLeftBehind(folder / "recovery");
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].rigFile, folder / "arm.rig.json");
  const Result<Document> recovered = recoverDocument(left[0]);
  ASSERT_TRUE(recovered.ok());
  EXPECT_EQ(recovered->rig(), unsaved);
}

TEST_F(Session, FailedSaveOfUnmodifiedWorkWritesNoRecoveryFile) {
  EditorState state;
  SessionKeeper one = keeper();
  one.start(state);
  open(state, "lizard.glb");
  ASSERT_EQ(saveTo(state, folder / "arm.rig.json"), "");
  EXPECT_NE(saveTo(state, folder / "absent" / "arm.rig.json"), "");
  one.tick(state, 0.0, kPlace);
  EXPECT_EQ(filesOfRecovery(), 0U);
  change(state);
  one.tick(state, 1.0, kPlace);
  EXPECT_EQ(filesOfRecovery(), 0U) << "what is changed later waits for its interval";
}

TEST_F(Session, DiscardedWorkIsRemoved) {
  {
    EditorState lost;
    SessionKeeper one = keeper();
    one.start(lost);
    open(lost, "lizard.glb");
    change(lost);
    one.tick(lost, 0.0, kPlace);
    lost.open.transport.clip = -1;  // Selecting another clip writes at once.
    one.tick(lost, 0.1, kPlace);
  }
  EditorState state;
  SessionKeeper two = keeper();
  two.start(state);
  ASSERT_EQ(state.session.leftBehind.size(), 1u);
  discardRecovery(state, state.session.leftBehind[0].file);
  EXPECT_TRUE(state.session.leftBehind.empty());
  EXPECT_TRUE(findLeftBehind(folder / "recovery").empty());
}

TEST_F(Session, UnwritablePathsAreReportedAndTheEditorContinues) {
  EditorState state;
  SessionKeeper one("/proc/sinew-test/preferences.json", "/proc/sinew-test/recovery");
  one.start(state);
  EXPECT_EQ(state.session.messages.size(), 1u);
  open(state, "lizard.glb");
  change(state);
  for (double now = 0.0; now < 100.0; now += 1.0) one.tick(state, now, kPlace);
  EXPECT_EQ(state.session.messages.size(), 2u);
  one.finish(state, kPlace);
}

TEST(Samples, HaveReadableUniqueNames) {
  const std::vector<Sample> all = samples();
  const auto lizard = std::ranges::find(all, "Lizard", &Sample::name);
  ASSERT_NE(lizard, all.end());
  EXPECT_EQ(lizard->file.filename(), "demo.rig.json");
  for (const Sample& sample : all) {
    EXPECT_TRUE(isSample(sample.file)) << sample.name;
    EXPECT_EQ(std::ranges::count(all, sample.name, &Sample::name), 1) << sample.name;
    EXPECT_EQ(sample.name.find('_'), std::string::npos) << sample.name;
  }
  EXPECT_TRUE(fs::is_regular_file(firstSample()));
  EXPECT_FALSE(isSample("/tmp/demo.rig.json"));
  EXPECT_FALSE(isSample(""));
}

TEST_F(Session, JumpSelectsAndIgnoresMissingNames) {
  EditorState state;
  open(state, "lizard.glb");
  state.frame.viewportPixels = {800, 600};
  change(state);
  const std::string muscle = state.document.rig().primitives[0].name;
  jumpToBone(state, 2);
  EXPECT_EQ(state.document.selection.bone, 2);
  EXPECT_TRUE(state.document.selection.primitives.empty());
  jumpToMuscle(state, state.document.idAt(0));
  EXPECT_EQ(state.document.activeName(), muscle);
  jumpToMuscle(state, PrimitiveId{999});
  jumpToBone(state, 100000);
  jumpToBone(state, -1);
  EXPECT_EQ(state.document.activeName(), muscle);
}

}  // namespace
}  // namespace sinew::app
