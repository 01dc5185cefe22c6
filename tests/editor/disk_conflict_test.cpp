// tests/editor/disk_conflict_test.cpp: two windows on one rig: no version is overwritten without consent.

#include "app/editor/open_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

#include "app/editor/commands.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

std::string bytesOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

class DiskConflict : public testing::Test {
 protected:
  void SetUp() override {
    fs::copy_file(fs::path(SINEW_SOURCE_DIR) / "assets" / "demo.glb", folder / "lizard.glb");
    EditorState first;
    ASSERT_TRUE(openFile(first, folder / "lizard.glb"));
    addMuscle(first, 0);
    ASSERT_EQ(saveTo(first, rig), "");
    ASSERT_TRUE(openFile(mine, rig));
    ASSERT_TRUE(openFile(theirs, rig));
  }
  /// Both windows edited the rig, and the other saved first.
  void theyWereFaster() {
    addMuscle(theirs, 1);
    ASSERT_TRUE(save(theirs, {}));
    addMuscle(mine, 0);
    addMuscle(mine, 2);
  }
  [[nodiscard]] static std::size_t muscles(const EditorState& state) { return state.document.rig().primitives.size(); }
  [[nodiscard]] static std::size_t musclesIn(const fs::path& file) {
    EditorState reader;
    return openFile(reader, file) ? muscles(reader) : 0;
  }

  const test::TemporaryFolder own;
  const fs::path folder = own.path();
  const fs::path rig = folder / "arm.rig.json";
  EditorState mine;
  EditorState theirs;
};

TEST_F(DiskConflict, SavingOverAnotherWindowsChangesPrompts) {
  theyWereFaster();
  const std::string before = bytesOf(rig);
  EXPECT_FALSE(save(mine, {}));
  EXPECT_EQ(mine.dialogs.conflict.found, OnDisk::kChanged);
  EXPECT_EQ(bytesOf(rig), before) << "written before it was answered";
  leaveUnsaved(mine);
  EXPECT_EQ(mine.dialogs.conflict.found, OnDisk::kSame);
  EXPECT_TRUE(mine.document.commands.modified());
  EXPECT_EQ(bytesOf(rig), before);
}

TEST_F(DiskConflict, BothVersionsCanBeKept) {
  theyWereFaster();
  const std::string before = bytesOf(rig);
  ASSERT_FALSE(save(mine, {}));
  saveBeside(mine);
  EXPECT_EQ(bytesOf(rig), before);
  EXPECT_EQ(mine.document.rigFile, folder / "arm 2.rig.json");
  EXPECT_EQ(musclesIn(mine.document.rigFile), muscles(mine));
  EXPECT_FALSE(mine.document.commands.modified());
  addMuscle(mine, 1);
  EXPECT_TRUE(save(mine, {})) << "the new file is this window's own";
}

TEST_F(DiskConflict, OtherVersionCanBeLoaded) {
  theyWereFaster();
  ASSERT_FALSE(save(mine, {}));
  discardForDisk(mine);
  EXPECT_EQ(muscles(mine), muscles(theirs));
  EXPECT_FALSE(mine.document.commands.modified());
  addMuscle(mine, 1);
  EXPECT_TRUE(save(mine, {}));
}

TEST_F(DiskConflict, OverwritingIsPossibleAndThenPromptsInTheOtherWindow) {
  theyWereFaster();
  ASSERT_FALSE(save(mine, {}));
  saveOverDisk(mine);
  EXPECT_EQ(musclesIn(rig), muscles(mine));
  addMuscle(theirs, 0);
  EXPECT_FALSE(save(theirs, {}));
}

TEST_F(DiskConflict, PendingQuitContinuesAfterTheChoiceButNotAfterCancel) {
  theyWereFaster();
  ASSERT_FALSE(save(mine, {IntentKind::kQuit, {}}));
  leaveUnsaved(mine);
  EXPECT_FALSE(mine.session.quit);
  ASSERT_FALSE(save(mine, {IntentKind::kQuit, {}}));
  saveBeside(mine);
  EXPECT_TRUE(mine.session.quit);
  EXPECT_TRUE(fs::exists(folder / "arm 2.rig.json"));
}

TEST_F(DiskConflict, DiscardOnQuitLeavesTheFileUntouched) {
  theyWereFaster();
  const std::string before = bytesOf(rig);
  ASSERT_FALSE(save(mine, {IntentKind::kQuit, {}}));
  discardForDisk(mine);
  EXPECT_TRUE(mine.session.quit);
  EXPECT_EQ(bytesOf(rig), before);
}

TEST_F(DiskConflict, DeletedFilePromptsAndCanBeWrittenAgain) {
  fs::remove(rig);
  addMuscle(mine, 0);
  EXPECT_FALSE(save(mine, {}));
  EXPECT_EQ(mine.dialogs.conflict.found, OnDisk::kGone);
  EXPECT_FALSE(fs::exists(rig));
  saveOverDisk(mine);
  EXPECT_EQ(musclesIn(rig), muscles(mine));
}

TEST_F(DiskConflict, ComparesContentNotDate) {
  addMuscle(mine, 0);
  const std::string same = bytesOf(rig);
  std::ofstream(rig, std::ios::binary) << same;
  fs::last_write_time(rig, fs::last_write_time(rig) + std::chrono::hours(1));
  EXPECT_TRUE(save(mine, {})) << "rewritten with the same bytes";
  const fs::file_time_type when = fs::last_write_time(rig);
  std::string other = bytesOf(rig);
  std::ranges::replace(other, '1', '2');  // Same length.
  std::ofstream(rig, std::ios::binary) << other;
  fs::last_write_time(rig, when);
  addMuscle(mine, 0);
  EXPECT_FALSE(save(mine, {})) << "changed without a new date";
}

TEST_F(DiskConflict, ExternalChangeIsReportedOnceBeforeSaving) {
  watchDisk(mine);
  EXPECT_TRUE(mine.session.messages.empty());
  addMuscle(theirs, 1);
  ASSERT_TRUE(save(theirs, {}));
  fs::last_write_time(rig, fs::last_write_time(rig) + std::chrono::seconds(2));
  watchDisk(mine);
  watchDisk(mine);
  ASSERT_EQ(mine.session.messages.size(), 1u);
  EXPECT_EQ(mine.session.messages[0].count, 1);
  EXPECT_NE(mine.session.messages[0].text.find("Reopen"), std::string::npos) << mine.session.messages[0].text;
  watchDisk(theirs);
  EXPECT_TRUE(theirs.session.messages.empty()) << "its own save is no news";
  perform(mine, {IntentKind::kReopen, {}});
  watchDisk(mine);
  EXPECT_TRUE(mine.session.messages.empty());
  fs::remove(rig);
  watchDisk(mine);
  ASSERT_EQ(mine.session.messages.size(), 1u);
  EXPECT_NE(mine.session.messages[0].text.find("no longer on disk"), std::string::npos);
}

/// Windows edit and save in random order and answer anything but "overwrite": every saved version remains the content
/// of a file, or was replaced by a window that had seen it.
TEST_F(DiskConflict, SaveNeverReplacesContentUnknownToItsWindow) {
  std::mt19937 random(11);
  std::array<EditorState*, 2> windows{&mine, &theirs};
  std::array<std::string, 2> seen{bytesOf(rig), bytesOf(rig)};
  int asked = 0;
  for (int round = 0; round < 90; ++round) {
    const std::size_t w = random() % 2;
    EditorState& window = *windows[w];
    if (random() % 3 != 0) {
      addMuscle(window, static_cast<int>(random() % 3));
      continue;
    }
    const std::string before = bytesOf(window.document.rigFile);
    if (save(window, {})) {
      EXPECT_EQ(before, seen[w]) << "round " << round << ": written over what it had not seen";
    } else {
      ++asked;
      EXPECT_NE(before, seen[w]) << "round " << round << ": asked without a reason";
      EXPECT_EQ(bytesOf(window.document.rigFile), before);
      discardForDisk(window);
    }
    seen[w] = bytesOf(window.document.rigFile);
  }
  EXPECT_GT(asked, 5);
}

}  // namespace
}  // namespace sinew::app
