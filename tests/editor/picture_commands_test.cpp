// tests/editor/picture_commands_test.cpp: destinations of pictures.

#include "app/editor/picture_commands.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

class PictureCommands : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"HOME", "XDG_CONFIG_HOME"}) {
      const char* value = std::getenv(name);
      before_.emplace_back(name, value != nullptr ? value : "");
    }
    home_ = own_.path() / "home";
    fs::create_directories(home_);
    ::setenv("HOME", home_.c_str(), 1);
    ::setenv("XDG_CONFIG_HOME", (own_.path() / "config").c_str(), 1);
    state_.document.rigFile = "/somewhere/fox.rig.json";
  }
  void TearDown() override {
    for (const auto& [name, value] : before_) {
      value.empty() ? ::unsetenv(name.c_str()) : ::setenv(name.c_str(), value.c_str(), 1);
    }
  }

  const test::TemporaryFolder own_;
  fs::path home_;
  std::vector<std::pair<std::string, std::string>> before_;
  EditorState state_;
};

TEST_F(PictureCommands, UsersPicturesFolderIsFound) {
  EXPECT_EQ(picturesFolder(), home_);
  fs::create_directories(home_ / "Pictures");
  EXPECT_EQ(picturesFolder(), home_ / "Pictures");
  own_.write("config/user-dirs.dirs", "# comment\nXDG_MUSIC_DIR=\"$HOME/Music\"\nXDG_PICTURES_DIR=\"$HOME/Bilder\"\n");
  EXPECT_EQ(picturesFolder(), home_ / "Pictures") << "one that is not there is no place to write to";
  fs::create_directories(home_ / "Bilder");
  EXPECT_EQ(picturesFolder(), home_ / "Bilder");
  own_.write("config/user-dirs.dirs", "XDG_PICTURES_DIR=\"");
  EXPECT_EQ(picturesFolder(), home_ / "Pictures");
  own_.write("config/user-dirs.dirs", "XDG_PICTURES_DIR=\"relative\"\n");
  EXPECT_EQ(picturesFolder(), home_ / "Pictures");
}

TEST_F(PictureCommands, DirectSaveNeverReusesAName) {
  savePictureNow(state_);
  ASSERT_TRUE(state_.session.pictureWanted);
  const fs::path first = *state_.session.pictureWanted;
  EXPECT_EQ(first.parent_path(), home_);
  EXPECT_TRUE(first.filename().string().starts_with("fox-2")) << first;
  EXPECT_EQ(first.extension(), ".png");
  // At least two within one second: the clock may advance between them.
  for (int i = 0; i < 3; ++i) {
    savePictureNow(state_);
    EXPECT_FALSE(fs::exists(*state_.session.pictureWanted));
    own_.write(fs::relative(*state_.session.pictureWanted, own_.path()).string(), "taken");
  }
}

TEST_F(PictureCommands, DialogStartsInTheLastPictureFolder) {
  showPictureDialog(state_);
  EXPECT_EQ(state_.dialogs.file.kind, DialogKind::kSavePicture);
  EXPECT_EQ(state_.dialogs.file.folder, home_);
  EXPECT_EQ(state_.dialogs.file.text, "fox.png");
  const fs::path chosen = home_ / "sheets";
  fs::create_directories(chosen);
  wantPicture(state_, chosen / "a.png");
  showPictureDialog(state_);
  EXPECT_EQ(state_.dialogs.file.folder, chosen);
  fs::remove(chosen);
  showPictureDialog(state_);
  EXPECT_EQ(state_.dialogs.file.folder, home_) << "the folder is gone";
}

TEST_F(PictureCommands, NamesEndInPng) {
  EXPECT_EQ(withPictureEnding("/a/fox"), "/a/fox.png");
  EXPECT_EQ(withPictureEnding("/a/fox.PNG"), "/a/fox.PNG");
  EXPECT_EQ(withPictureEnding("/a/fox.jpg"), "/a/fox.jpg.png");
}

}  // namespace
}  // namespace sinew::app
