// tests/files/part_files_test.cpp: temporary files of killed programs are deleted, files being written stay.
#include "core/files/disk/atomic_file.h"

#include <chrono>
#include <csignal>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "tests/support/temporary_folder.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;
using std::chrono::seconds;

class PartFiles : public testing::Test {
 protected:
  [[nodiscard]] bool has(const std::string& name) const { return fs::exists(fs::symlink_status(folder_ / name)); }
  fs::path makeAged(const std::string& name, seconds age) const {
    fs::path file = own_.write(name, "left");
    fs::last_write_time(file, fs::file_time_type::clock::now() - age);
    return file;
  }
  /// Cleans up as if it were that much later.
  void clear(seconds later = seconds{0}) const { clearStrayParts(folder_, std::time(nullptr) + later.count()); }

  const test::TemporaryFolder own_;
  const fs::path folder_ = own_.path();
};

/// Another program, killed at the end of the scope at the latest.
class Program {
 public:
  template <class Work>
  explicit Program(Work work) : id_(::fork()) {
    if (id_ == 0) {
      work();
      ::_exit(0);
    }
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() { kill(); }
  void kill() {
    if (id_ <= 0) return;
    ::kill(id_, SIGKILL);
    ::waitpid(id_, nullptr, 0);
    id_ = 0;
  }

 private:
  pid_t id_;
};

constexpr seconds kOld = kStrayAge + seconds(60);
constexpr seconds kYoung = kStrayAge - seconds(60);

TEST_F(PartFiles, FirstWriteIntoAFolderRemovesOldOnes) {
  makeAged(".sinew-17-0.part", kOld);
  makeAged(".sinew-18-12.part", kYoung);
  ASSERT_TRUE(writeFileAtomically(folder_ / "file", "text").ok());
  EXPECT_FALSE(has(".sinew-17-0.part"));
  EXPECT_TRUE(has(".sinew-18-12.part")) << "it may be in use where there are no locks";
  EXPECT_TRUE(has("file"));
}

TEST_F(PartFiles, OtherNamesAreKept) {
  const std::vector<std::string> names{
      ".sinew-1-2.part.bak", "x.sinew-1-2.part", ".sinew-1.part", ".sinew--1.part", ".sinew-1-.part", ".sinew-a-2.part",
      ".sinew-1-2-3.part",   ".sinew-1-2.PART",  ".sinew-.part",  ".sinew-1-2",     "sinew-1-2.part"};
  for (const std::string& name : names) makeAged(name, 100 * kOld);
  clear();
  for (const std::string& name : names) EXPECT_TRUE(has(name)) << name;
}

TEST_F(PartFiles, LinksAndFoldersAreKept) {
  fs::create_directory(folder_ / ".sinew-1-1.part");
  const fs::path aimed = makeAged("work.rig.json", kOld);
  fs::create_symlink(aimed, folder_ / ".sinew-1-2.part");
  clear(100 * kOld);
  EXPECT_TRUE(has(".sinew-1-1.part"));
  EXPECT_TRUE(has(".sinew-1-2.part"));
  EXPECT_TRUE(has("work.rig.json"));
}

TEST_F(PartFiles, HardLinkAgeIsThatOfTheLink) {
  // As left by a program killed while it kept the previous version.
  const fs::path work = makeAged("work.rig.json", 1000 * kOld);
  fs::create_hard_link(work, folder_ / ".sinew-1-0.part");
  clear();
  EXPECT_TRUE(has(".sinew-1-0.part")) << "it has had this name for a moment only";
  clear(kOld);
  EXPECT_FALSE(has(".sinew-1-0.part"));
  EXPECT_EQ(readWholeFile(work, 100).value(), "left");
}

TEST_F(PartFiles, LockedFilesAreKeptUntilTheirProcessEnds) {
  makeAged(".sinew-1-0.part", 100 * kOld);
  const fs::path previous = own_.write("work.rig.json", "left");
  fs::create_hard_link(previous, folder_ / ".sinew-1-1.part");
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  Program other([&] {
    const Descriptor written(::open((folder_ / ".sinew-1-0.part").c_str(), O_WRONLY));
    lockPart(written);
    const Descriptor kept = lockShared(previous);
    static_cast<void>(!::write(ready[1], "!", 1));
    for (;;) ::pause();
  });
  char told = 0;
  ASSERT_EQ(::read(ready[0], &told, 1), 1);
  clear(100 * kOld);
  EXPECT_TRUE(has(".sinew-1-0.part"));
  EXPECT_TRUE(has(".sinew-1-1.part"));
  other.kill();
  clear(100 * kOld);
  EXPECT_FALSE(has(".sinew-1-0.part"));
  EXPECT_FALSE(has(".sinew-1-1.part"));
  EXPECT_TRUE(has("work.rig.json"));
  ::close(ready[0]);
  ::close(ready[1]);
}

TEST_F(PartFiles, NamesAreUnique) {
  EXPECT_NE(freshPart(folder_), freshPart(folder_));
  EXPECT_EQ(freshPart(folder_).parent_path(), folder_);
}

TEST_F(PartFiles, WritesSucceedWhileOtherProcessesClear) {
  const auto clearForEver = [this] {
    for (;;) clear(100 * kOld);
  };
  const Program one(clearForEver);
  const Program two(clearForEver);
  for (int i = 0; i < 60; ++i) {
    const std::string bytes = std::to_string(i);
    const auto single = writeFileAtomically(folder_ / "one", bytes);
    ASSERT_TRUE(single.ok()) << single.error().text();
    const auto pair = writeFilesAtomically({{folder_ / "two.bin", bytes}, {folder_ / "two.gltf", bytes}});
    ASSERT_TRUE(pair.ok()) << pair.error().text();
    ASSERT_EQ(readWholeFile(folder_ / "one", 100).value(), bytes);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 3);
}

}  // namespace
}  // namespace sinew
