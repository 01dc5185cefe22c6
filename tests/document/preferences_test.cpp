// tests/document/preferences_test.cpp: preferences survive a restart; damaged files do no harm.

#include "app/document/preferences.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <thread>

#include "core/files/disk/atomic_file.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

class PreferencesFile : public testing::Test {
 protected:
  void SetUp() override { file = folder / "deeper" / "preferences.json"; }

  void write(const std::string& text) const {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
  }

  const test::TemporaryFolder own;
  const fs::path folder = own.path();
  fs::path file;
};

Preferences unlikeTheDefaults() {
  Preferences p;
  p.keymap = Keymap::kBlender;
  p.keys[0] = {{"edit/duplicate", {"Shift+D", "K"}}, {"view/frame", {}}};
  p.keys[1] = {{"edit/undo", {"U"}}};
  p.scale = 1.75f;
  p.autosaveSeconds = 12.5;
  p.recentFiles = {"/a/fox.glb", "/b/with space \xc3\xa9.rig.json"};
  p.recentActions = {"view/wire", "edit/undo"};
  p.hiddenFiles = p.newestFirst = true;
  p.look = {LightPreset::kRim, Backdrop::kLight, true};
  p.fullWhileMoving = true;
  p.surfaceBy = SurfaceBy::kCard;
  p.pictureFolder = "/a/pictures";
  p.window = {-5, 17, 1900, 1000, true};
  p.layout.left = 311.25f;
  p.layout.right = 222.0f;
  p.layout.history = 99.0f;
  p.layout.bottom = 140.0f;
  p.layout.stages = true;
  p.layout.overlay = p.layout.leftShown = p.layout.rightShown = p.layout.bottomShown = false;
  p.layout.folded = {"surface", "smoothing"};
  return p;
}

TEST_F(PreferencesFile, EverythingRoundTrips) {
  const Preferences written = unlikeTheDefaults();
  ASSERT_TRUE(savePreferences(written, file).ok());
  const LoadedPreferences read = loadPreferences(file);
  EXPECT_EQ(read.complaint, "");
  EXPECT_EQ(read.preferences, written);
  EXPECT_EQ(preferencesToJson(read.preferences), preferencesToJson(written));
}

TEST_F(PreferencesFile, MissingFileGivesDefaultsWithoutAComplaint) {
  const LoadedPreferences read = loadPreferences(file);
  EXPECT_EQ(read.preferences, Preferences{});
  EXPECT_EQ(read.complaint, "");
  EXPECT_FALSE(fs::exists(file));
}

TEST_F(PreferencesFile, DamagedFileIsReportedRenamedAndReplacedByDefaults) {
  for (const char* text :
       {"", "no json", "{ \"format\": \"sinew-pref", "[]", "{ \"format\": \"sinew-rig\" }", "\xff\xfe"}) {
    write(text);
    const LoadedPreferences read = loadPreferences(file);
    EXPECT_EQ(read.preferences, Preferences{}) << text;
    EXPECT_NE(read.complaint.find("preferences.json"), std::string::npos) << text;
    EXPECT_FALSE(fs::exists(file)) << text;
    std::ifstream aside(file.string() + ".bad", std::ios::binary);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(aside), {}), text);
  }
}

TEST_F(PreferencesFile, InvalidEntriesAreIgnoredIndividually) {
  write(R"({ "format": "sinew-preferences", "version": 99, "keymap": 7, "scale": 1e9, "autosave_seconds": -3,
             "recent_files": ["/a.glb", 5, null, "relative.glb", "/a.glb", "/b.glb"], "recent_actions": {},
             "window": "wide", "keys": { "maya": 7, "blender": { "edit/undo": "U" }, "emacs": { "edit/undo": ["U"] } },
             "layout": { "left": "x", "right": 250, "bottom": 1e300, "overlay": 1, "folded": [1, "surface"] },
             "hidden_files": true, "unknown": [1, 2] })");
  const LoadedPreferences read = loadPreferences(file);
  EXPECT_EQ(read.complaint, "");
  Preferences expected;
  expected.recentFiles = {"/a.glb", "/b.glb"};
  expected.layout.right = 250.0f;
  expected.layout.folded = {"surface"};
  expected.hiddenFiles = true;
  EXPECT_EQ(read.preferences, expected);
}

TEST_F(PreferencesFile, UnwritablePathIsNamedInTheError) {
  const Result<void> saved = savePreferences({}, "/proc/sinew-test/preferences.json");
  ASSERT_FALSE(saved.ok());
  EXPECT_NE(saved.error().text().find("/proc/sinew-test"), std::string::npos);
}

TEST_F(PreferencesFile, RecentFilesAreUniqueNewestFirstAndLimited) {
  std::vector<fs::path> recent;
  for (int i = 0; i < 40; ++i) rememberFile(recent, "/c/" + std::to_string(i) + ".glb");
  ASSERT_EQ(recent.size(), kMostRecentFiles);
  EXPECT_EQ(recent.front(), "/c/39.glb");
  rememberFile(recent, "/c/x/../38.glb");
  EXPECT_EQ(recent.size(), kMostRecentFiles);
  EXPECT_EQ(recent[0], "/c/38.glb");
  EXPECT_EQ(recent[1], "/c/39.glb");
  rememberFile(recent, "here.glb");
  EXPECT_TRUE(recent[0].is_absolute());
}

TEST_F(PreferencesFile, ChangesOfTwoWindowsAreMerged) {
  Preferences base;
  base.recentFiles = {"/a", "/b", "/c"};
  Preferences mine = base;
  Preferences theirs = base;
  EXPECT_EQ(mergedPreferences(base, mine, theirs), base);
  mine.keymap = Keymap::kBlender;
  theirs.scale = 2.0f;
  theirs.newestFirst = true;
  theirs.look.light = LightPreset::kRim;
  theirs.pictureFolder = "/pictures";
  theirs.keys[0]["view/ground"] = {"W"};
  mine.recentFiles = {"/c", "/d", "/a", "/b"};
  theirs.recentFiles = {"/e", "/a", "/b", "/c"};
  const Preferences both = mergedPreferences(base, mine, theirs);
  EXPECT_EQ(both.keymap, Keymap::kBlender);
  EXPECT_EQ(both.scale, 2.0f);
  EXPECT_TRUE(both.newestFirst);
  EXPECT_EQ(both.keys, theirs.keys);
  EXPECT_EQ(both.look, theirs.look);
  EXPECT_EQ(both.pictureFolder, theirs.pictureFolder);
  EXPECT_EQ(both.recentFiles, (std::vector<fs::path>{"/c", "/d", "/e", "/a", "/b"}));
}

TEST_F(PreferencesFile, ClearedRecentListKeepsOnlyFilesAddedByOthers) {
  Preferences base;
  base.recentFiles = {"/a", "/b"};
  Preferences mine = base;
  mine.recentFiles.clear();
  Preferences theirs = base;
  theirs.recentFiles = {"/e", "/a", "/b"};
  EXPECT_EQ(mergedPreferences(base, mine, theirs).recentFiles, std::vector<fs::path>{"/e"});
}

/// Two windows that write alternately lose no recent file and list none twice.
TEST_F(PreferencesFile, AlternatingWindowsLoseNoRecentFile) {
  std::mt19937 random(2);
  for (int round = 0; round < 200; ++round) {
    Preferences disk;
    std::array<Preferences, 2> base;
    std::array<Preferences, 2> mine;
    std::vector<fs::path> opened;
    for (int i = 0; i < 12; ++i) {
      const std::size_t w = random() % 2;
      const fs::path chosen = "/c/" + std::to_string(random() % 9) + ".glb";
      rememberFile(mine[w].recentFiles, chosen);
      rememberFile(opened, chosen);
      if (random() % 3 == 0 && i < 11) continue;  // Written later.
      disk = mergedPreferences(base[w], mine[w], disk);
      base[w] = mine[w];
    }
    for (const std::size_t w : {0, 1}) disk = mergedPreferences(base[w], mine[w], disk);
    std::vector<fs::path> all = disk.recentFiles;
    std::ranges::sort(all);
    EXPECT_EQ(std::ranges::adjacent_find(all), all.end());
    std::ranges::sort(opened);
    EXPECT_EQ(all, opened);
  }
}

TEST_F(PreferencesFile, ConcurrentSavesAreAllMerged) {
  const fs::path shared = folder / "at-once" / "preferences.json";
  std::vector<std::thread> windows;
  for (int w = 0; w < 4; ++w) {
    windows.emplace_back([w, &shared] {
      Preferences mine;
      for (int i = 0; i < 3; ++i) {
        const Preferences base = mine;
        rememberFile(mine.recentFiles, "/c/" + std::to_string(w) + "-" + std::to_string(i) + ".glb");
        EXPECT_TRUE(saveMergedPreferences(base, mine, shared).ok());
      }
    });
  }
  for (std::thread& window : windows) window.join();
  EXPECT_EQ(loadPreferences(shared).preferences.recentFiles.size(), 12u);
}

TEST_F(PreferencesFile, RememberActionAcceptsAnElementOfItsList) {
  std::vector<std::string> recent{"a", "b", "c"};
  rememberAction(recent, recent[2]);
  EXPECT_EQ(recent, (std::vector<std::string>{"c", "a", "b"}));
}

TEST_F(PreferencesFile, FolderFollowsTheEnvironment) {
  const char* before = std::getenv("XDG_CONFIG_HOME");
  const std::string kept = before != nullptr ? before : "";
  setenv("XDG_CONFIG_HOME", folder.c_str(), 1);
  EXPECT_EQ(preferencesFile(), folder / "sinew" / "preferences.json");
  setenv("XDG_CONFIG_HOME", "relative", 1);
  EXPECT_EQ(preferencesFile().string().find("relative"), std::string::npos);
  before != nullptr ? setenv("XDG_CONFIG_HOME", kept.c_str(), 1) : unsetenv("XDG_CONFIG_HOME");
}

}  // namespace
}  // namespace sinew::app
