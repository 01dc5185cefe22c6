// tests/document/folder_listing_test.cpp: entries, completion and names in the file browser.

#include "app/document/folder_listing.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

class FolderList : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* made : {"Zebra", "animals", ".secret"}) fs::create_directory(folder / made);
    for (const char* made : {"fox.glb", "Fox.rig.json", "boar.gltf", "notes.txt", "data.json", ".hidden.glb"}) {
      std::ofstream(folder / made) << made;
    }
  }

  [[nodiscard]] std::vector<std::string> names(const ListingOptions& options) const {
    std::vector<std::string> all;
    for (const FolderEntry& entry : listFolder(folder, options)) all.push_back(entry.name);
    return all;
  }
  using Names = std::vector<std::string>;
  const test::TemporaryFolder own;
  const fs::path folder = own.path();
};

TEST_F(FolderList, FoldersComeFirstThenFilesIgnoringCase) {
  EXPECT_EQ(names({}), (Names{"animals", "Zebra", "boar.gltf", "fox.glb", "Fox.rig.json"}));
}

TEST_F(FolderList, FiltersByKindAndHidesDotFiles) {
  EXPECT_EQ(names({FileFilter::kRigs, false, false}), (Names{"animals", "Zebra", "Fox.rig.json"}));
  EXPECT_EQ(names({FileFilter::kCharacters, false, false}), (Names{"animals", "Zebra", "boar.gltf", "fox.glb"}));
  EXPECT_EQ(names({FileFilter::kCharacters, true, false}),
            (Names{".secret", "animals", "Zebra", ".hidden.glb", "boar.gltf", "fox.glb"}));
}

TEST_F(FolderList, SortsNewestFirstWithinFoldersAndFiles) {
  const auto now = fs::file_time_type::clock::now();
  fs::last_write_time(folder / "boar.gltf", now - std::chrono::hours(2));
  fs::last_write_time(folder / "fox.glb", now - std::chrono::hours(1));
  fs::last_write_time(folder / "Fox.rig.json", now - std::chrono::hours(3));
  fs::last_write_time(folder / "animals", now - std::chrono::hours(9));
  fs::last_write_time(folder / "Zebra", now);
  EXPECT_EQ(names({FileFilter::kAll, false, true}),
            (Names{"Zebra", "animals", "fox.glb", "boar.gltf", "Fox.rig.json"}));
}

TEST_F(FolderList, UnreadableFolderIsEmpty) {
  EXPECT_TRUE(listFolder(folder / "nowhere", {}).empty());
  EXPECT_TRUE(listFolder(folder / "fox.glb", {}).empty());
}

TEST_F(FolderList, IsRefreshedWhenTheFolderChanges) {
  FolderListing listing;
  refresh(listing, folder, {});
  EXPECT_EQ(listing.entries.size(), 5u);
  std::ofstream(folder / "new.glb") << "x";
  fs::last_write_time(folder, fs::file_time_type::clock::now() + std::chrono::seconds(5));
  refresh(listing, folder, {});
  EXPECT_EQ(listing.entries.size(), 6u);
  refresh(listing, folder / "animals", {});
  EXPECT_TRUE(listing.entries.empty());
}

TEST_F(FolderList, CompletesTheUnambiguousPrefix) {
  EXPECT_EQ(completePath(folder, "b", {}), "boar.gltf");
  EXPECT_EQ(completePath(folder, "fo", {}), "fox.glb") << "the case as typed goes first";
  EXPECT_EQ(completePath(folder, "Fo", {}), "Fox.rig.json");
  EXPECT_EQ(completePath(folder, "FO", {}).size(), 4u) << "fox. whatever the case";
  EXPECT_EQ(completePath(folder, "an", {}), "animals/");
  EXPECT_EQ(completePath(folder, "nothing", {}), "nothing");
  EXPECT_EQ(completePath(folder, ".s", {}), ".secret/");
  EXPECT_EQ(completePath("/", folder.string() + "/z", {}), folder.string() + "/Zebra/");
}

TEST_F(FolderList, TypedPathsAreRelativeToTheFolder) {
  EXPECT_EQ(resolveTyped("/a/b", "c.glb"), "/a/b/c.glb");
  EXPECT_EQ(resolveTyped("/a/b", "../c.glb"), "/a/c.glb");
  EXPECT_EQ(resolveTyped("/a/b", "/x/c.glb"), "/x/c.glb");
  EXPECT_EQ(withRigEnding("a/b"), "a/b.rig.json");
  EXPECT_EQ(withRigEnding("a/b.JSON"), "a/b.JSON");
  EXPECT_EQ(withRigEnding("a/horse.glb"), "a/horse.rig.json");
  EXPECT_EQ(withRigEnding("a/horse.v2.GLTF"), "a/horse.v2.rig.json");
}

TEST_F(FolderList, PlacesExistAndAreUnique) {
  const char* before = std::getenv("HOME");
  const std::string kept = before != nullptr ? before : "";
  setenv("HOME", folder.c_str(), 1);
  fs::create_directory(folder / "Documents");
  const std::vector<fs::path> recent{folder / "animals" / "a.glb", folder / "animals" / "b.glb", "/nowhere/c.glb",
                                     folder / "d.glb"};
  const std::vector<Place> all = places(recent, folder / "Zebra");
  before != nullptr ? setenv("HOME", kept.c_str(), 1) : unsetenv("HOME");
  std::vector<std::string> ids;
  for (const Place& place : all) ids.push_back(place.id);
  EXPECT_EQ(ids, (Names{"home", "documents", "samples", "recent/0", "root"}));
  EXPECT_EQ(all[3].folder, folder / "animals");
}

TEST(FileSizeText, SizesAreReadable) {
  EXPECT_EQ(sizeText(812), "812 B");
  EXPECT_EQ(sizeText(34 * 1024), "34 KB");
  EXPECT_EQ(sizeText(1258291), "1.2 MB");
  EXPECT_EQ(dateText(fs::file_time_type::clock::now()).size(), 16u);
}

}  // namespace
}  // namespace sinew::app
