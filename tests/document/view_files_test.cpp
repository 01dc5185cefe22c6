// tests/document/view_files_test.cpp: stored views of files: found again, never confused, limited in number.

#include "app/document/view_files.h"

#include <chrono>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

class ViewFiles : public testing::Test {
 protected:
  [[nodiscard]] fs::path made(const std::string& name) const {
    fs::create_directories((folder / name).parent_path());
    std::ofstream(folder / name) << "rig";
    return folder / name;
  }
  void keep(const fs::path& file, int mark) const {
    const Result<void> stored = storeView(views, file, Json::object().set("mark", mark));
    ASSERT_TRUE(stored.ok()) << stored.error().text();
  }
  [[nodiscard]] int found(const fs::path& file) const {
    const std::optional<Json> view = loadView(views, file);
    return view ? static_cast<int>(view->at("mark").number(-2)) : -1;
  }
  [[nodiscard]] std::vector<fs::path> files() const {
    return {fs::directory_iterator(views), fs::directory_iterator()};
  }

  const test::TemporaryFolder own;
  const fs::path folder = own.path();
  const fs::path views = folder / "state" / "views";
};

TEST_F(ViewFiles, EachFileKeepsItsLatestView) {
  const fs::path a = made("a.rig.json"), b = made("b.rig.json");
  EXPECT_EQ(found(a), -1);
  keep(a, 1);
  keep(b, 2);
  keep(a, 3);
  EXPECT_EQ(found(a), 3);
  EXPECT_EQ(found(b), 2);
  EXPECT_EQ(files().size(), 2u);
}

TEST_F(ViewFiles, DifferentPathsToAFileShareItsView) {
  const fs::path file = made("deep/a.rig.json");
  fs::create_directory_symlink(folder / "deep", folder / "link");
  keep(file, 5);
  EXPECT_EQ(found(folder / "deep" / ".." / "deep" / "a.rig.json"), 5);
  EXPECT_EQ(found(folder / "link" / "a.rig.json"), 5);
  EXPECT_EQ(found(made("a.rig.json")), -1) << "the same name in another folder";
}

TEST_F(ViewFiles, InvalidFileGivesNoView) {
  const fs::path file = made("a.rig.json");
  keep(file, 1);
  const fs::path kept = files().at(0);
  for (const char* text :
       {"", "{", "[]", "3", "{\"format\": \"sinew-view\"}", "\xff\xfe", "{\"format\": \"other\", \"file\": \"x\"}"}) {
    std::ofstream(kept, std::ios::trunc) << text;
    EXPECT_EQ(found(file), -1) << text;
  }
  fs::remove(kept);
  fs::create_directory(kept);
  EXPECT_EQ(found(file), -1);
}

// Two paths with the same hash share a file name: the path stored inside identifies the owner.
TEST_F(ViewFiles, ViewOfAnotherFileWithTheSameHashIsIgnored) {
  const fs::path a = made("a.rig.json"), b = made("b.rig.json");
  keep(a, 1);
  const fs::path ofA = files().at(0);
  keep(b, 2);
  fs::copy_file(ofA, files().at(files().at(0) == ofA ? 1 : 0), fs::copy_options::overwrite_existing);
  EXPECT_EQ(found(b), -1);
}

TEST_F(ViewFiles, OldestViewsAreRemovedAndForeignFilesKept) {
  const fs::path first = made("first.rig.json");
  keep(first, 1);
  std::ofstream(views / "notes.json") << "mine";
  std::ofstream(views / "0123456789abcdef.txt") << "mine";
  for (std::size_t i = 0; i < kMostViews; ++i) {
    keep(folder / ("f" + std::to_string(i) + ".rig.json"), static_cast<int>(i));
  }
  std::size_t count = 0;
  for (const fs::path& view : files()) count += view.extension() == ".json" && view.filename() != "notes.json";
  EXPECT_EQ(count, kMostViews);
  EXPECT_EQ(found(folder / ("f" + std::to_string(kMostViews - 1) + ".rig.json")), static_cast<int>(kMostViews) - 1);
  EXPECT_TRUE(fs::exists(views / "notes.json"));
  EXPECT_TRUE(fs::exists(views / "0123456789abcdef.txt"));
}

TEST_F(ViewFiles, LeastRecentlyWrittenViewIsRemovedFirst) {
  std::vector<fs::path> all;
  for (std::size_t i = 0; i < kMostViews; ++i) {
    all.push_back(folder / ("f" + std::to_string(i) + ".rig.json"));
    keep(all.back(), static_cast<int>(i));
  }
  // Make the view of all[7] the oldest, found by its contents.
  for (const fs::path& view : files()) {
    std::ifstream stream(view);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (text.find("/f7.rig.json") != std::string::npos) {
      fs::last_write_time(view, fs::file_time_type::clock::now() - std::chrono::hours(1));
    }
  }
  keep(made("new.rig.json"), 1000);
  EXPECT_EQ(found(all[7]), -1);
  EXPECT_EQ(found(all[6]), 6);
  EXPECT_EQ(found(folder / "new.rig.json"), 1000);
  EXPECT_EQ(files().size(), kMostViews);
}

TEST_F(ViewFiles, UnwritableFolderIsAnError) {
  EXPECT_FALSE(storeView("/proc/sinew-test/views", made("a.rig.json"), Json::object()).ok());
  EXPECT_FALSE(loadView("/proc/sinew-test/views", folder / "a.rig.json").has_value());
}

}  // namespace
}  // namespace sinew::app
