// tests/files/atomic_file_test.cpp: a file has its old or new content, never anything in between.
#include "core/files/disk/atomic_file.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <thread>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/temporary_folder.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

class AtomicFile : public ::testing::Test {
 protected:
  [[nodiscard]] std::size_t filesInFolder() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  [[nodiscard]] std::string contentOf(const fs::path& file) const { return readWholeFile(file, 1 << 20).value(); }

  const test::TemporaryFolder own_;
  const fs::path folder_ = own_.path();
};

/// While alive, limits files of this process to `bytes`: simulates a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    rlimit tight = before_;
    tight.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &tight);
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

TEST_F(AtomicFile, WritesAnyBytesAndReplacesThem) {
  const fs::path file = folder_ / "name with spaces";
  const std::string bytes("a\0b\xff\n", 5);
  ASSERT_TRUE(writeFileAtomically(file, bytes).ok());
  EXPECT_EQ(contentOf(file), bytes);
  ASSERT_TRUE(writeFileAtomically(file, "").ok());
  EXPECT_EQ(contentOf(file), "");
  EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(AtomicFile, FullDiskKeepsTheOldFile) {
  const fs::path file = folder_ / "kept";
  ASSERT_TRUE(writeFileAtomically(file, "old").ok());
  {
    const FileSizeLimit limit(1000);
    const auto written = writeFileAtomically(file, std::string(100000, 'x'));
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.error().file, file.string());
    EXPECT_FALSE(written.error().reason.empty());
  }
  EXPECT_EQ(contentOf(file), "old");
  EXPECT_EQ(filesInFolder(), 1u) << "nothing half written stays behind";
}

TEST_F(AtomicFile, FullDeviceIsReported) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "left out: this system has no /dev/full";
  EXPECT_FALSE(writeFileAtomically("/dev/full", "text").ok());
  EXPECT_TRUE(fs::is_character_file("/dev/full")) << "a device must not be replaced by a file";
  EXPECT_TRUE(writeFileAtomically("/dev/null", "text").ok());
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(AtomicFile, ImpossiblePathsAreErrors) {
  ASSERT_TRUE(writeFileAtomically(folder_ / "file", "old").ok());
  EXPECT_FALSE(writeFileAtomically(folder_ / "file" / "below", "x").ok());
  EXPECT_FALSE(writeFileAtomically(folder_ / "absent" / "file", "x").ok());
  EXPECT_FALSE(writeFileAtomically(folder_, "x").ok());
  EXPECT_FALSE(writeFileAtomically("", "x").ok());
  EXPECT_EQ(contentOf(folder_ / "file"), "old");
  EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(AtomicFile, ReadOnlyFolderKeepsTheOldFile) {
  if (::geteuid() == 0) GTEST_SKIP() << "left out: the superuser writes anywhere";
  const fs::path file = folder_ / "file";
  ASSERT_TRUE(writeFileAtomically(file, "old").ok());
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_FALSE(writeFileAtomically(file, "new").ok());
  fs::permissions(folder_, fs::perms::owner_all);
  EXPECT_EQ(contentOf(file), "old");
}

TEST_F(AtomicFile, ModeIsKeptAndNewFilesObeyTheUmask) {
  const fs::path file = folder_ / "file";
  const mode_t mask = ::umask(027);
  ASSERT_TRUE(writeFileAtomically(file, "1").ok());
  ::umask(mask);
  EXPECT_EQ(fs::status(file).permissions(), fs::perms(0640));
  fs::permissions(file, fs::perms(0604));
  ASSERT_TRUE(writeFileAtomically(file, "2").ok());
  EXPECT_EQ(fs::status(file).permissions(), fs::perms(0604));
}

TEST_F(AtomicFile, SymbolicLinkIsKept) {
  ASSERT_TRUE(writeFileAtomically(folder_ / "real", "old").ok());
  fs::create_symlink("real", folder_ / "link");
  ASSERT_TRUE(writeFileAtomically(folder_ / "link", "new").ok());
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(contentOf(folder_ / "real"), "new");
}

TEST_F(AtomicFile, FileGroupsAreWrittenAllOrNone) {
  const fs::path first = folder_ / "a.bin";
  const fs::path second = folder_ / "a.gltf";
  ASSERT_TRUE(writeFilesAtomically({{first, "old bytes"}, {second, "old text"}}).ok());
  EXPECT_EQ(contentOf(first), "old bytes");
  EXPECT_EQ(contentOf(second), "old text");
  {
    const FileSizeLimit full(4);
    const auto written = writeFilesAtomically({{first, "new"}, {second, "new text"}});
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.error().file, second.string());
  }
  for (const fs::path& taken : {folder_, fs::path("/dev/full"), folder_ / "absent" / "c"}) {
    const auto written = writeFilesAtomically({{first, "new"}, {taken, "new"}});
    ASSERT_FALSE(written.ok());
    EXPECT_EQ(written.error().file, taken.string());
  }
  EXPECT_EQ(contentOf(first), "old bytes");
  EXPECT_EQ(contentOf(second), "old text");
  EXPECT_EQ(filesInFolder(), 2U);
}

TEST_F(AtomicFile, PreviousVersionIsKeptOncePerRun) {
  const fs::path file = folder_ / "work.rig.json";
  const fs::path kept = folder_ / "work.rig.json~";
  own_.write("work.rig.json", "before this run");
  ASSERT_TRUE(writeFileAtomically(file, "before this run").ok());
  EXPECT_FALSE(fs::exists(kept)) << "nothing has changed";
  ASSERT_TRUE(writeFileAtomically(file, "first").ok());
  EXPECT_EQ(contentOf(kept), "before this run");
  ASSERT_TRUE(writeFileAtomically(file, "second").ok());
  EXPECT_EQ(contentOf(file), "second");
  EXPECT_EQ(contentOf(kept), "before this run");
  EXPECT_EQ(filesInFolder(), 2U);
}

TEST_F(AtomicFile, InternalFilesKeepNoPreviousVersion) {
  own_.write("view.json", "old");
  ASSERT_TRUE(writeFileAtomically(folder_ / "view.json", "new", Previous::kReplaced).ok());
  EXPECT_EQ(contentOf(folder_ / "view.json"), "new");
  EXPECT_EQ(filesInFolder(), 1U);
}

TEST_F(AtomicFile, OlderPreviousVersionIsReplacedButAFolderIsNot) {
  own_.write("a", "old");
  own_.write("a~", "older");
  ASSERT_TRUE(writeFileAtomically(folder_ / "a", "new").ok());
  EXPECT_EQ(contentOf(folder_ / "a~"), "old");
  own_.write("b", "old");
  fs::create_directory(folder_ / "b~");
  ASSERT_TRUE(writeFileAtomically(folder_ / "b", "new").ok());
  EXPECT_EQ(contentOf(folder_ / "b"), "new");
  EXPECT_TRUE(fs::is_directory(folder_ / "b~"));
  EXPECT_EQ(filesInFolder(), 4U);
}

TEST_F(AtomicFile, PreviousVersionMayBeAHardLinkToTheFile) {
  // As left by a process that was killed after it kept the previous version and before it renamed the new one.
  own_.write("a", "old");
  fs::create_hard_link(folder_ / "a", folder_ / "a~");
  ASSERT_TRUE(writeFileAtomically(folder_ / "a", "new").ok());
  EXPECT_EQ(contentOf(folder_ / "a"), "new");
  EXPECT_EQ(contentOf(folder_ / "a~"), "old");
  EXPECT_EQ(filesInFolder(), 2U);
}

TEST_F(AtomicFile, FileMadeByAnotherProgramIsMovedIntoPlace) {
  own_.write("film.gif", "old");
  const fs::path made = own_.write(".film.part.gif", "new");
  ASSERT_TRUE(putFileAtomically(made, folder_ / "film.gif").ok());
  EXPECT_EQ(contentOf(folder_ / "film.gif"), "new");
  EXPECT_EQ(contentOf(folder_ / "film.gif~"), "old");
  EXPECT_EQ(filesInFolder(), 2U);
  EXPECT_FALSE(putFileAtomically(folder_ / "absent", folder_ / "film.gif").ok());
  EXPECT_EQ(contentOf(folder_ / "film.gif"), "new");
}

// Pipes -----------------------------------------------------------------------------------------------------------

TEST_F(AtomicFile, UnreadPipeIsAnErrorAfterATimeout) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const auto written = writeFileAtomically(pipe, "text");
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().reason, "cannot be written: it is a pipe that no program reads");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(AtomicFile, LateReaderOfAPipeGetsEveryByte) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::string text(300'000, 'x');  // More than a pipe holds.
  std::string read;
  std::thread reader([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
    std::ifstream in(pipe, std::ios::binary);
    read.assign(std::istreambuf_iterator<char>(in), {});
  });
  const auto written = writeFileAtomically(pipe, text);
  reader.join();
  EXPECT_TRUE(written.ok());
  EXPECT_EQ(read, text);
}

TEST_F(AtomicFile, ReaderThatLeavesIsAnError) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread reader([&] {
    std::ifstream in(pipe, std::ios::binary);
    in.get();
  });
  const auto written = writeFileAtomically(pipe, std::string(300'000, 'x'));
  reader.join();
  ASSERT_FALSE(written.ok());
  EXPECT_NE(written.error().reason.find("cannot be written"), std::string::npos);
}

// Killed at any time ----------------------------------------------------------------------------------------------

/// Whether it is a single complete version.
bool isOneVersion(const std::string& bytes, std::size_t size) {
  return bytes.size() == size && bytes.find_first_not_of(bytes.front()) == std::string::npos;
}

/// Writes versions as fast as possible until killed. Closes `started` once each file has been replaced.
[[noreturn]] void writeForEver(const fs::path& folder, std::size_t size, int started) {
  for (char version = 'a';; version = version == 'z' ? 'a' : static_cast<char>(version + 1)) {
    const std::string bytes(size, version);
    static_cast<void>(writeFileAtomically(folder / "one", bytes));
    static_cast<void>(writeFilesAtomically({{folder / "two.bin", bytes}, {folder / "two.gltf", bytes}}));
    if (started >= 0) ::close(started);
    started = -1;
  }
}

/// Starts a writer process. Every second one is returned at once, the others after their first round, so that both the
/// first and a later write are interrupted, however slow the machine is.
pid_t startWriter(const fs::path& folder, std::size_t size, bool afterRound) {
  std::array<int, 2> started{};
  if (::pipe(started.data()) != 0) return -1;
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(started[0]);
    writeForEver(folder, size, started[1]);
  }
  ::close(started[1]);
  char none = 0;
  if (child > 0 && afterRound) static_cast<void>(::read(started[0], &none, 1));  // Nothing is written: its end.
  ::close(started[0]);
  return child;
}

/// Environment: SINEW_KILLS, number of kills (40).
TEST_F(AtomicFile, KilledProcessLeavesWholeFiles) {
  constexpr std::size_t kSize = 200'000;
  const char* const asked = std::getenv("SINEW_KILLS");
  const int kills = asked == nullptr ? 40 : std::atoi(asked);
  const std::vector<std::string> names{"one", "two.bin", "two.gltf"};
  for (const std::string& name : names) own_.write(name, std::string(kSize, '0'));
  std::mt19937 random(7);
  int previous = 0;
  for (int kill = 0; kill < kills; ++kill) {
    const pid_t child = startWriter(folder_, kSize, kill % 2 == 1);
    ASSERT_GT(child, 0);
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 8000));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    ASSERT_EQ(::waitpid(child, nullptr, 0), child);
    for (const std::string& name : names) {
      ASSERT_TRUE(isOneVersion(contentOf(folder_ / name), kSize)) << name << " after kill " << kill;
      const fs::path kept = folder_ / (name + "~");
      if (!fs::exists(kept)) continue;
      ++previous;
      ASSERT_TRUE(isOneVersion(contentOf(kept), kSize)) << kept << " after kill " << kill;
    }
  }
  EXPECT_GT(previous, 0) << "no version was kept";
  // A version that is not in place yet briefly has its own name; it is complete too.
  for (const auto& each : fs::directory_iterator(folder_)) {
    EXPECT_TRUE(isOneVersion(contentOf(each.path()), kSize)) << each.path();
  }
}

TEST_F(AtomicFile, ReadingRefusesNonFilesAndLargeFiles) {
  const fs::path file = folder_ / "ten";
  ASSERT_TRUE(writeFileAtomically(file, "0123456789").ok());
  EXPECT_TRUE(readWholeFile(file, 10).ok());
  const auto large = readWholeFile(file, 9);
  ASSERT_FALSE(large.ok());
  EXPECT_EQ(large.error().file, file.string());
  EXPECT_FALSE(readWholeFile(folder_, 100).ok());
  EXPECT_FALSE(readWholeFile(folder_ / "absent", 100).ok());
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_FALSE(readWholeFile(folder_ / "pipe", 100).ok()) << "and it must not wait for a writer";
}

}  // namespace
}  // namespace sinew
