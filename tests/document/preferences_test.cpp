// tests/document/preferences_test.cpp: what is remembered comes back; what is damaged does no harm.

#include "app/document/preferences.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/io/files/atomic_file.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

class PreferencesTest : public testing::Test {
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

TEST_F(PreferencesTest, EverythingComesBack) {
  const Preferences written = unlikeTheDefaults();
  ASSERT_TRUE(savePreferences(written, file).ok());
  const LoadedPreferences read = loadPreferences(file);
  EXPECT_EQ(read.complaint, "");
  EXPECT_EQ(read.preferences, written);
  EXPECT_EQ(preferencesToJson(read.preferences), preferencesToJson(written));
}

TEST_F(PreferencesTest, WithoutAFileThereAreDefaultsAndNoComplaint) {
  const LoadedPreferences read = loadPreferences(file);
  EXPECT_EQ(read.preferences, Preferences{});
  EXPECT_EQ(read.complaint, "");
  EXPECT_FALSE(fs::exists(file));
}

TEST_F(PreferencesTest, ADamagedFileIsToldKeptAsideAndReplacedByDefaults) {
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

TEST_F(PreferencesTest, WhatIsWrongInPartCostsThatPartAlone) {
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

TEST_F(PreferencesTest, APlaceThatCannotBeWrittenIsAnErrorThatNamesIt) {
  const Result<void> saved = savePreferences({}, "/proc/sinew-test/preferences.json");
  ASSERT_FALSE(saved.ok());
  EXPECT_NE(saved.error().text().find("/proc/sinew-test"), std::string::npos);
}

TEST_F(PreferencesTest, RecentFilesAreNewestFirstEachOnceAndNotTooMany) {
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

TEST_F(PreferencesTest, AnActionOfTheListItselfCanBeRemembered) {
  std::vector<std::string> recent{"a", "b", "c"};
  rememberAction(recent, recent[2]);
  EXPECT_EQ(recent, (std::vector<std::string>{"c", "a", "b"}));
}

TEST_F(PreferencesTest, TheFolderFollowsTheEnvironment) {
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
