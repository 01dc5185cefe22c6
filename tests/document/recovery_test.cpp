// tests/document/recovery_test.cpp: unsaved work with and without a crash.

#include "app/document/recovery.h"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <utility>

#include "sinew/files/rig_json.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

class Recovery : public testing::Test {
 protected:
  void SetUp() override {
    fs::copy_file(fs::path(SINEW_SOURCE_DIR) / "assets" / "demo.glb", folder / "lizard.glb");
    state = folder / "state" / "recovery";
  }

  /// The lizard with one more muscle than in its file.
  [[nodiscard]] Document changed(bool saved) const {
    Document document = openDocument(folder / "lizard.glb").value();
    if (saved) {
      document.commands.apply("First", withMuscle(document, "first"));
      EXPECT_TRUE(saveDocument(document, folder / "lizard.rig.json").ok());
    }
    document.commands.apply("Second", withMuscle(document, "second"));
    return document;
  }
  static Rig withMuscle(const Document& document, const std::string& name) {
    Primitive primitive;
    primitive.name = name;
    primitive.bone = document.character->skeleton.fileName(0);
    primitive.placement.center = {0.1f, 0.123456789f, -3e-7f};
    primitive.placement.radii = {0.1f, 0.2f, 0.3f};
    return addPrimitive(document.rig(), primitive).value();
  }
  /// Another process writes its work and dies as in a crash.
  void crash(const Document& document) const {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      Result<RecoveryFile> mine = RecoveryFile::claim(state);
      if (mine) static_cast<void>(mine.value().write(document));
      ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
  }
  [[nodiscard]] std::size_t filesLeft() const {
    std::error_code failed;
    const fs::directory_iterator all(state, failed);
    return failed ? 0 : static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }

  const test::TemporaryFolder own;
  const fs::path folder = own.path();
  fs::path state;
};

TEST_F(Recovery, CrashedWorkIsOfferedAndRecoveredAsModifiedWithItsPath) {
  const Document before = changed(true);
  const std::string onDisk = rigToJson(loadRig(folder / "lizard.rig.json").value());
  crash(before);
  const std::vector<LeftBehind> left = findLeftBehind(state);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].name(), "lizard.rig.json");
  EXPECT_EQ(left[0].primitives, 2);
  Result<Document> recovered = recoverDocument(left[0]);
  ASSERT_TRUE(recovered.ok()) << recovered.error().text();
  EXPECT_NE(recovered->mirror, nullptr) << "twins follow each other in it too";
  EXPECT_EQ(rigToJson(recovered->rig()), rigToJson(before.rig()));
  EXPECT_EQ(recovered->rigFile, folder / "lizard.rig.json");
  EXPECT_TRUE(recovered->commands.modified());
  EXPECT_EQ(rigToJson(loadRig(folder / "lizard.rig.json").value()), onDisk) << "the rig file was touched";
  recovered.value().commands.undo();
  EXPECT_EQ(rigToJson(recovered->rig()), onDisk);
  EXPECT_FALSE(recovered->commands.modified());
  EXPECT_EQ(findLeftBehind(state).size(), 1u) << "kept until it is thrown away";
  discardLeftBehind(left[0]);
  EXPECT_EQ(filesLeft(), 0u);
}

TEST_F(Recovery, UnsavedWorkIsRecoveredWithoutAPath) {
  const Document before = changed(false);
  crash(before);
  const std::vector<LeftBehind> left = findLeftBehind(state);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].name(), "lizard.glb");
  const Result<Document> recovered = recoverDocument(left[0]);
  ASSERT_TRUE(recovered.ok()) << recovered.error().text();
  EXPECT_TRUE(recovered->rigFile.empty());
  EXPECT_TRUE(recovered->commands.modified());
  EXPECT_EQ(recovered->rig().primitives.size(), 1u);
}

TEST_F(Recovery, WorkOfARunningEditorIsNotOffered) {
  Result<RecoveryFile> mine = RecoveryFile::claim(state);
  ASSERT_TRUE(mine.ok());
  ASSERT_TRUE(mine.value().write(changed(true)).ok());
  EXPECT_TRUE(findLeftBehind(state).empty());
  Result<RecoveryFile> other = RecoveryFile::claim(state);
  ASSERT_TRUE(other.ok());
  EXPECT_NE(mine->file(), other->file());
  ASSERT_TRUE(other.value().write(changed(true)).ok());
  EXPECT_TRUE(findLeftBehind(state).empty());
  LeftBehind guessed;
  guessed.file = mine->file();
  EXPECT_FALSE(recoverDocument(guessed).ok()) << "stolen from a living editor";
  mine.value().finish();
  other.value().finish();
  EXPECT_EQ(filesLeft(), 0u);
}

TEST_F(Recovery, CleanExitLeavesNothing) {
  Result<RecoveryFile> mine = RecoveryFile::claim(state);
  ASSERT_TRUE(mine.ok());
  ASSERT_TRUE(mine.value().write(changed(true)).ok());
  EXPECT_EQ(filesLeft(), 2u);  // Work file and lock.
  mine.value().remove();
  EXPECT_EQ(filesLeft(), 1u);
  mine.value().finish();
  EXPECT_EQ(filesLeft(), 0u);
}

TEST_F(Recovery, CrashWithoutChangesLeavesNothingToOffer) {
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const Result<RecoveryFile> mine = RecoveryFile::claim(state);
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(filesLeft(), 1u);
  EXPECT_TRUE(findLeftBehind(state).empty());
  EXPECT_EQ(filesLeft(), 0u) << "the lock of the dead stays";
}

TEST_F(Recovery, DamagedWorkIsNotOffered) {
  fs::create_directories(state);
  for (const char* text : {"", "{", "[]", "{ \"format\": \"sinew-recovery\" }", "{ \"format\": \"other\" }"}) {
    std::ofstream(state / "7-0.json", std::ios::binary | std::ios::trunc) << text;
    EXPECT_TRUE(findLeftBehind(state).empty()) << text;
  }
  std::ofstream(state / "7-0.json", std::ios::trunc)
      << R"({ "format": "sinew-recovery", "character_file": "/nowhere/x.glb", "rig": { "version": 4 } })";
  const std::vector<LeftBehind> left = findLeftBehind(state);
  ASSERT_EQ(left.size(), 1u);
  EXPECT_FALSE(recoverDocument(left[0]).ok());
  EXPECT_TRUE(fs::exists(left[0].file));
}

TEST_F(Recovery, NewestWorkComesFirst) {
  crash(changed(false));
  const fs::path older = findLeftBehind(state).at(0).file;
  crash(changed(true));
  fs::last_write_time(older, fs::file_time_type::clock::now() - std::chrono::hours(3));
  const std::vector<LeftBehind> left = findLeftBehind(state);
  ASSERT_EQ(left.size(), 2u);
  EXPECT_EQ(left[0].name(), "lizard.rig.json");
  EXPECT_EQ(left[1].file, older);
}

TEST_F(Recovery, UncreatableFolderIsAnError) {
  EXPECT_FALSE(RecoveryFile::claim("/proc/sinew-test/recovery").ok());
  EXPECT_TRUE(findLeftBehind("/proc/sinew-test/recovery").empty());
}

TEST(RecoveryAge, IsGivenInTheLargestUnit) {
  using namespace std::chrono_literals;
  const auto now = fs::file_time_type::clock::now();
  EXPECT_EQ(ageText(now, now), "just now");
  EXPECT_EQ(ageText(now + 5s, now), "just now");
  EXPECT_EQ(ageText(now - 61s, now), "1 minute ago");
  EXPECT_EQ(ageText(now - 59min, now), "59 minutes ago");
  EXPECT_EQ(ageText(now - 25h, now), "1 day ago");
  EXPECT_EQ(ageText(now - 50h, now), "2 days ago");
  EXPECT_EQ(ageText(now - 3h, now), "3 hours ago");
}

// Schedule --------------------------------------------------------------------------------------------------------

class Autosave : public testing::Test {
 protected:
  using Deed = AutosaveClock::Deed;
  void change(const std::string& name) {
    Rig rig = commands.rig();
    rig.character = name;
    commands.apply("Change", rig);
  }
  Deed look(double now, int clip = 0) {
    const Deed deed = clock.look(now, 30.0, commands, document, clip);
    if (deed == Deed::kWrite) clock.wrote(commands.revision());
    return deed;
  }

  CommandStack commands{Rig{}};
  AutosaveClock clock;
  std::size_t document = 1;
};

TEST_F(Autosave, UnchangedDocumentIsNotWritten) {
  for (const double now : {0.0, 100.0, 1000.0}) EXPECT_EQ(look(now), Deed::kNothing);
  EXPECT_EQ(look(1001.0, 3), Deed::kNothing) << "another clip";
}

TEST_F(Autosave, NoChangeWaitsLongerThanTheInterval) {
  look(0.0);
  change("a");
  EXPECT_EQ(look(10.0), Deed::kNothing);
  change("b");  // A later change does not postpone it.
  EXPECT_EQ(look(39.0), Deed::kNothing);
  EXPECT_EQ(clock.secondsLeft(39.0, 30.0), 1.0);
  EXPECT_EQ(look(40.0), Deed::kWrite);
  EXPECT_EQ(look(100.0), Deed::kNothing) << "nothing new";
  change("c");
  EXPECT_EQ(look(101.0), Deed::kNothing);
  EXPECT_EQ(look(131.0), Deed::kWrite);
}

TEST_F(Autosave, LongDragIsWrittenWhileItLasts) {
  look(0.0);
  commands.beginGesture("Drag");
  Deed deed = Deed::kNothing;
  int writes = 0;
  for (double now = 0.0; now < 95.0; now += 0.5) {
    Rig rig = commands.rig();
    rig.character = std::to_string(now);
    commands.updateGesture(rig);
    deed = look(now);
    writes += deed == Deed::kWrite;
  }
  EXPECT_EQ(writes, 3);
}

TEST_F(Autosave, ClipChangeWritesUnsavedWorkImmediately) {
  look(0.0, 0);
  change("a");
  EXPECT_EQ(look(1.0, 0), Deed::kNothing);
  EXPECT_EQ(look(1.1, 1), Deed::kWrite);
  EXPECT_EQ(look(1.2, 2), Deed::kNothing) << "nothing new since";
}

TEST_F(Autosave, HurryWritesUnwrittenWorkOnceAtTheNextCheck) {
  look(0.0);
  clock.hurry();
  EXPECT_EQ(look(0.1), Deed::kNothing) << "nothing has changed";
  change("a");
  EXPECT_EQ(look(1.0), Deed::kNothing) << "the hurry before the change is over";
  clock.hurry();
  EXPECT_EQ(look(1.1), Deed::kWrite);
  clock.hurry();
  EXPECT_EQ(look(1.2), Deed::kNothing) << "it is written";
  change("b");
  EXPECT_EQ(look(1.3), Deed::kNothing);
  EXPECT_EQ(look(31.3), Deed::kWrite) << "the interval is as before";
}

TEST_F(Autosave, FailedHurriedWriteIsRetriedAfterAnInterval) {
  change("a");
  EXPECT_EQ(look(0.0), Deed::kNothing);
  clock.hurry();
  EXPECT_EQ(clock.look(1.0, 30.0, commands, document, 0), Deed::kWrite);  // wrote() is not called.
  EXPECT_EQ(look(2.0), Deed::kNothing);
  EXPECT_EQ(look(31.9), Deed::kNothing);
  EXPECT_EQ(look(32.0), Deed::kWrite);
}

TEST_F(Autosave, SavingOrUndoingRemovesTheFile) {
  look(0.0);
  change("a");
  look(1.0);
  EXPECT_EQ(look(31.0), Deed::kWrite);
  commands.markSaved();
  EXPECT_EQ(look(32.0), Deed::kRemove);
  EXPECT_EQ(look(33.0), Deed::kNothing);
  change("b");
  look(40.0);
  EXPECT_EQ(look(70.0), Deed::kWrite);
  commands.undo();
  EXPECT_EQ(look(71.0), Deed::kRemove);
}

TEST_F(Autosave, OpeningAnotherDocumentRemovesTheFile) {
  look(0.0);
  change("a");
  look(1.0);
  EXPECT_EQ(look(31.0), Deed::kWrite);
  commands = CommandStack(Rig{});
  document = 2;
  EXPECT_EQ(look(32.0, 5), Deed::kRemove);
  change("b");
  EXPECT_EQ(look(33.0, 5), Deed::kNothing);
  EXPECT_EQ(look(63.0, 5), Deed::kWrite);
}

TEST_F(Autosave, FailedWriteIsRetriedAfterAnInterval) {
  look(0.0);
  change("a");
  EXPECT_EQ(clock.look(1.0, 30.0, commands, document, 0), Deed::kNothing);
  EXPECT_EQ(clock.look(31.0, 30.0, commands, document, 0), Deed::kWrite);
  EXPECT_EQ(clock.look(32.0, 30.0, commands, document, 0), Deed::kNothing);
  EXPECT_EQ(clock.look(62.0, 30.0, commands, document, 0), Deed::kWrite);
}

TEST_F(Recovery, ClipFilesAreFoundFromTheRecoveredDocumentsFolder) {
  Document before = changed(true);
  Rig rig = before.rig();
  rig.clipFiles = {"walk.glb", "/far/run.glb"};
  before.commands.apply("Clips", rig);
  before.clipFiles.folder = folder / "clips";
  crash(before);
  const std::vector<LeftBehind> left = findLeftBehind(state);
  ASSERT_EQ(left.size(), 1u);
  const Result<Document> recovered = recoverDocument(left[0]);
  ASSERT_TRUE(recovered.ok()) << recovered.error().text();
  EXPECT_EQ(recovered->rig().clipFiles, (std::vector<std::string>{"clips/walk.glb", "/far/run.glb"}));
}

}  // namespace
}  // namespace sinew::app
