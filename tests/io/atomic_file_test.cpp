// tests/io/atomic_file_test.cpp: a file is old or new, never in between.
#include "core/io/files/atomic_file.h"

#include <csignal>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
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

/// No file of this process grows past `bytes` while this lives: a full disk that needs no disk.
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

TEST_F(AtomicFile, AFullDiskLeavesTheOldFileWhole) {
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

TEST_F(AtomicFile, ADeviceThatIsFullIsToldOf) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "left out: this system has no /dev/full";
  EXPECT_FALSE(writeFileAtomically("/dev/full", "text").ok());
  EXPECT_TRUE(fs::is_character_file("/dev/full")) << "a device must not be replaced by a file";
  EXPECT_TRUE(writeFileAtomically("/dev/null", "text").ok());
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(AtomicFile, WhereNoFileCanBeIsAnError) {
  ASSERT_TRUE(writeFileAtomically(folder_ / "file", "old").ok());
  EXPECT_FALSE(writeFileAtomically(folder_ / "file" / "below", "x").ok());
  EXPECT_FALSE(writeFileAtomically(folder_ / "absent" / "file", "x").ok());
  EXPECT_FALSE(writeFileAtomically(folder_, "x").ok());
  EXPECT_FALSE(writeFileAtomically("", "x").ok());
  EXPECT_EQ(contentOf(folder_ / "file"), "old");
  EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(AtomicFile, AReadOnlyFolderKeepsTheOldFile) {
  if (::geteuid() == 0) GTEST_SKIP() << "left out: the superuser writes anywhere";
  const fs::path file = folder_ / "file";
  ASSERT_TRUE(writeFileAtomically(file, "old").ok());
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_FALSE(writeFileAtomically(file, "new").ok());
  fs::permissions(folder_, fs::perms::owner_all);
  EXPECT_EQ(contentOf(file), "old");
}

TEST_F(AtomicFile, ModeIsKeptAndNewFilesObeyTheMask) {
  const fs::path file = folder_ / "file";
  const mode_t mask = ::umask(027);
  ASSERT_TRUE(writeFileAtomically(file, "1").ok());
  ::umask(mask);
  EXPECT_EQ(fs::status(file).permissions(), fs::perms(0640));
  fs::permissions(file, fs::perms(0604));
  ASSERT_TRUE(writeFileAtomically(file, "2").ok());
  EXPECT_EQ(fs::status(file).permissions(), fs::perms(0604));
}

TEST_F(AtomicFile, ALinkStaysALink) {
  ASSERT_TRUE(writeFileAtomically(folder_ / "real", "old").ok());
  fs::create_symlink("real", folder_ / "link");
  ASSERT_TRUE(writeFileAtomically(folder_ / "link", "new").ok());
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(contentOf(folder_ / "real"), "new");
}

TEST_F(AtomicFile, FilesThatBelongTogetherAreAllNewOrAllOld) {
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

TEST_F(AtomicFile, ReadingRefusesWhatIsNoFileOrTooLarge) {
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
