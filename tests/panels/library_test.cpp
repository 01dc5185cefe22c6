// tests/panels/library_test.cpp: the Library tab: adding muscles by click or drag, and custom sets.
#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "app/document/muscle_sets.h"
#include "app/editor/actions.h"
#include "app/panels/muscle_picture.h"
#include "core/rig/validation.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

class LibraryPanel : public HeadlessEditor {
 protected:
  void SetUp() override {
    const char* before = std::getenv("XDG_CONFIG_HOME");
    kept_ = before != nullptr ? before : "";
    ::setenv("XDG_CONFIG_HOME", own_.path().c_str(), 1);
    HeadlessEditor::SetUp();
  }
  void TearDown() override {
    HeadlessEditor::TearDown();
    kept_.empty() ? ::unsetenv("XDG_CONFIG_HOME") : ::setenv("XDG_CONFIG_HOME", kept_.c_str(), 1);
  }
  void open(const fs::path& file) {
    ASSERT_TRUE(openFile(state, file));
    state.open.transport.playing = false;
    settle();
    click("library/tab");
  }
  static fs::path asset(const char* file) { return fs::path(SINEW_SOURCE_DIR) / "assets" / file; }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const Primitive& each : state.document.rig().primitives) all.push_back(each.name);
    return all;
  }
  [[nodiscard]] int bone(const char* name) const { return state.character().skeleton.findBone(name).value_or(-1); }
  /// Drags a tile to a position in window coordinates.
  void carry(const std::string& tile, const glm::vec2& to) { drag(tile, to - center(tile)); }

 private:
  const test::TemporaryFolder own_;
  std::string kept_;
};

TEST_F(LibraryPanel, ClickPlacesAMuscleAndItsTwinAtItsOwnBone) {
  open(asset("humanoid.glb"));
  click("library/athlete/biceps");
  EXPECT_EQ(names(), (std::vector<std::string>{"biceps L", "biceps R"}));
  EXPECT_TRUE(validate(state.document.rig()).ok());
  EXPECT_EQ(steps(), 1u);
  EXPECT_EQ(state.document.activeName(), "biceps L");
  EXPECT_EQ(state.document.rig().primitives[0].bone, "upper_arm.L");
  EXPECT_FALSE(state.document.rig().primitives[0].line.empty());
  run(action("edit/undo"), state);
  settle();
  EXPECT_TRUE(names().empty());
}

TEST_F(LibraryPanel, MuscleIsDraggedOntoTheSkin) {
  open(asset("humanoid.glb"));
  carry("library/athlete/biceps", pixelOfBone(bone("thigh.R")));
  ASSERT_EQ(names().size(), 2u);
  EXPECT_EQ(steps(), 1u);
  EXPECT_EQ(state.document.rig().primitives[0].bone, "thigh.L");
  EXPECT_EQ(state.document.rig().primitives[1].bone, "thigh.R");
  EXPECT_EQ(state.document.activePrimitive(), 1);
  EXPECT_TRUE(state.document.rig().lines.empty());
  EXPECT_LT(state.open.library.drag.set, 0);
}

TEST_F(LibraryPanel, MuscleDroppedOnItsOwnPartKeepsItsLine) {
  open(asset("humanoid.glb"));
  carry("library/athlete/biceps", pixelOfBone(bone("upper_arm.R")));
  ASSERT_EQ(names().size(), 2u);
  EXPECT_EQ(state.document.rig().primitives[1].bone, "upper_arm.R");
  EXPECT_EQ(state.document.activePrimitive(), 1);
  EXPECT_EQ(state.document.rig().lines.size(), 2u);
}

TEST_F(LibraryPanel, DropOutsideTheCharacterOrEscapePlacesNothing) {
  open(asset("humanoid.glb"));
  const glm::vec4& v = state.frame.viewport;
  carry("library/athlete/biceps", {v.x + 0.9f * v.z, v.y + 0.4f * v.w});
  EXPECT_EQ(steps(), 0u);
  queue.move(center("library/athlete/biceps"));
  settle();
  queue.button(0, true);
  queue.move(pixelOfBone(bone("thigh.R")));
  settle();
  EXPECT_EQ(state.open.library.drag.set, 0);
  EXPECT_NE(state.open.library.drag.says.find("upper leg"), std::string::npos);
  press(kEscape);
  EXPECT_LT(state.open.library.drag.set, 0);
  queue.button(0, false);
  settle();
  EXPECT_EQ(steps(), 0u);
}

TEST_F(LibraryPanel, SearchFiltersByWord) {
  open(asset("humanoid.glb"));
  EXPECT_TRUE(shown("library/athlete/biceps"));
  state.open.library.search = "glut";
  settle();
  EXPECT_FALSE(shown("library/athlete/biceps"));
  EXPECT_TRUE(shown("library/athlete/gluteus maximus"));
}

TEST_F(LibraryPanel, SetMatchesTheKindOfBody) {
  open(asset("horse.glb"));
  EXPECT_TRUE(shown("library/add/animal"));
  EXPECT_FALSE(shown("library/add/athlete"));
  click("library/add/animal");
  EXPECT_GT(names().size(), 20u);
  EXPECT_TRUE(shown("muscle-set/mass"));
}

TEST_F(LibraryPanel, SelectedMusclesAreSavedAsASetAndFitAnotherCharacter) {
  open(asset("humanoid-flex.rig.json"));
  EXPECT_FALSE(action("muscles/save-set").enabled(state));
  for (const Primitive& each : state.document.rig().primitives)
    if (each.name == "biceps L" || each.name == "quadriceps L" || each.name == "nape")
      state.document.selection.primitives.push_back(each.id());
  const std::size_t count = state.document.selection.primitives.size();
  ASSERT_GE(count, 2u);
  settle();
  click("library/save-set");
  type("My arms");
  press(kEnter);
  EXPECT_FALSE(state.open.library.naming) << state.open.library.notice;
  EXPECT_TRUE(isOwnSet("My arms"));
  for (const char* set : {"athlete", "sculpted"}) state.open.library.folded.insert(set);
  settle();
  ASSERT_TRUE(shown("library/add/My arms"));
  EXPECT_FALSE(state.document.commands.modified());

  open(asset("demo.glb"));
  for (const char* set : {"athlete", "sculpted"}) state.open.library.folded.insert(set);
  settle();
  ASSERT_TRUE(shown("library/My arms/biceps"));
  click("library/My arms/biceps");
  EXPECT_EQ(names(), (std::vector<std::string>{"biceps L", "biceps R"}));
}

TEST_F(LibraryPanel, SetIsReplacedOnlyAfterConfirmation) {
  open(asset("humanoid-flex.rig.json"));
  state.document.selection.primitives = {state.document.rig().primitives[0].id()};
  settle();
  const auto save = [&](const char* name) {
    click("library/name");
    press(kKeyA, true);
    type(name);
    click("library/save");
  };
  click("library/save-set");
  save("");
  EXPECT_EQ(state.open.library.notice, "Type a name");
  save("athlete");
  EXPECT_NE(state.open.library.notice.find("comes with the program"), std::string::npos);
  save("Mine");
  ASSERT_TRUE(isOwnSet("Mine"));
  click("library/save-set");
  save("Mine");
  EXPECT_TRUE(state.open.library.naming);
  EXPECT_NE(state.open.library.notice.find("to replace"), std::string::npos);
  click("library/save");
  EXPECT_FALSE(state.open.library.naming);
  // Esc goes back.
  click("library/save-set");
  press(kEscape);
  EXPECT_FALSE(state.open.library.naming);
}

TEST_F(LibraryPanel, RemovedSetKeepsABackupFile) {
  open(asset("humanoid-flex.rig.json"));
  state.document.selection.primitives = {state.document.rig().primitives[0].id()};
  settle();
  click("library/save-set");
  type("Gone");
  press(kEnter);
  ASSERT_TRUE(isOwnSet("Gone"));
  for (const char* set : {"athlete", "sculpted"}) state.open.library.folded.insert(set);
  settle();
  click("library/Gone", 1);
  click("library/remove/Gone");
  EXPECT_FALSE(isOwnSet("Gone"));
  EXPECT_FALSE(shown("library/add/Gone"));
  EXPECT_TRUE(fs::exists(ownSetsFolder() / "Gone.json~"));
}

TEST_F(LibraryPanel, UnknownBodyShowsTheReason) {
  const test::TemporaryFolder folder;
  open(folder.write("post.glb", test::makePost().file.glb()));
  EXPECT_TRUE(state.open.library.sets.empty());
  EXPECT_FALSE(state.open.library.why.empty());
  click("library/body-parts");
  EXPECT_TRUE(state.open.bodyParts.shown);
}

TEST(SetNames, AreValidFileNames) {
  EXPECT_EQ(setNameFor("My arms"), "My arms");
  EXPECT_EQ(setNameFor("../arms/x"), "-arms-x");
  EXPECT_EQ(setNameFor("  .. "), "");
  EXPECT_EQ(setNameFor("a\nb\\c:d"), "a-b-c-d");
  EXPECT_LE(setNameFor(std::string(500, 'x')).size(), 60u);
}

/// The red pixels center on the middle; without a muscle there are none.
TEST_F(LibraryPanel, PictureShowsTheMuscleInTheMiddle) {
  open(asset("humanoid.glb"));
  for (const FittedPreset& laid : state.open.library.laid) {
    for (const Primitive& muscle : laid.rig.primitives) {
      if (!muscle.sheet.empty()) continue;
      const Image image = musclePicture(state.character(), std::vector{muscle}, 0.36f);
      ASSERT_EQ(image.rgba.size(), 4u * static_cast<std::size_t>(kMusclePicture.x * kMusclePicture.y));
      double red = 0.0;
      glm::dvec2 sum(0.0);
      for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
          const auto at = 4 * static_cast<std::size_t>(y * image.width + x);
          const double more = std::max(0, image.rgba[at] - image.rgba[at + 1] - 30);
          red += more;
          sum += more * glm::dvec2(x, y);
        }
      }
      ASSERT_GT(red, 0.0) << muscle.name;
      EXPECT_NEAR(sum.x / red, 0.5 * image.width, 0.2 * image.width) << muscle.name;
      EXPECT_NEAR(sum.y / red, 0.5 * image.height, 0.25 * image.height) << muscle.name;
    }
  }
  const Image bare = musclePicture(state.character(), {}, 0.36f);
  for (std::size_t i = 0; i < bare.rgba.size(); i += 4) ASSERT_LT(bare.rgba[i], bare.rgba[i + 1] + 30);
}

}  // namespace
}  // namespace sinew::app
