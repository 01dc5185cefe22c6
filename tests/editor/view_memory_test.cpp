// tests/editor/view_memory_test.cpp: reopening a file restores its view.

#include "app/editor/view_memory.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "app/document/view_files.h"
#include "app/editor/commands.h"
#include "app/editor/open_file.h"
#include "app/editor/pose_commands.h"
#include "app/window/session_keeper.h"
#include "core/character/range_of_motion.h"
#include "core/rig/motion_clip.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

namespace fs = std::filesystem;

constexpr WindowPlace kWindowPlace{10, 20, 1280, 800, false};

class ViewMemory : public testing::Test {
 protected:
  void SetUp() override {
    const fs::path assets = fs::path(SINEW_SOURCE_DIR) / "assets";
    for (const char* name : {"demo.glb", "demo.rig.json"}) fs::copy_file(assets / name, folder / name);
    fs::copy_file(assets / "demo.glb", folder / "other.glb");
  }
  [[nodiscard]] SessionKeeper keeper() const {
    return {folder / "preferences.json", folder / "recovery", folder / "views"};
  }
  static std::string bytesOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  /// Sets everything that is restored.
  static void arrange(EditorState& state) {
    chooseClip(state.open.transport, 1, state.character());
    state.open.transport.playing = false;
    state.open.transport.time = 0.5;
    state.open.transport.loop = false;
    state.open.transport.speed = 0.25f;
    state.view.display.shading = Shading::kClay;
    state.view.display.skeleton = true;
    state.view.display.anatomy = true;
    state.view.display.relief = true;
    state.view.display.glass = 0.25f;
    state.view.tools.camera.stand = {{0.1f, 0.9f, -0.2f}, 3.5f, -1.25f, 0.5f, {0.25f, -0.125f}};
    state.view.tools.camera.orthographic = true;
    state.view.outlinerFilter = "thigh";
    state.view.outliner.onlyWithMuscles = true;
    state.view.outliner.helperBones = true;
    state.view.outliner.folded = {"hips/spine"};
    state.document.visibility.setMuscle(Mark::kHidden, state.document.idAt(2), true);
    state.document.visibility.setMuscle(Mark::kLocked, state.document.idAt(3), true);
    state.document.visibility.setBone(Mark::kHidden, state.character().skeleton.bones[4].path, true);
  }
  static void expectArranged(const EditorState& state) {
    const Transport& transport = state.open.transport;
    EXPECT_EQ(transport.clip, 1);
    EXPECT_FALSE(transport.playing);
    EXPECT_DOUBLE_EQ(transport.time, 0.5);
    EXPECT_FALSE(transport.loop);
    EXPECT_EQ(transport.speed, 0.25f);
    EXPECT_EQ(state.view.display.shading, Shading::kClay);
    EXPECT_TRUE(state.view.display.skeleton);
    EXPECT_TRUE(state.view.display.anatomy);
    EXPECT_TRUE(state.view.display.relief);
    EXPECT_EQ(state.view.display.glass, 0.25f);
    const CameraStand& stand = state.view.tools.camera.stand;
    EXPECT_EQ(stand.target, glm::vec3(0.1f, 0.9f, -0.2f));
    EXPECT_EQ(stand.distance, 3.5f);
    EXPECT_EQ(stand.yaw, -1.25f);
    EXPECT_EQ(stand.pitch, 0.5f);
    EXPECT_EQ(stand.aim, glm::vec2(0.25f, -0.125f));
    EXPECT_TRUE(state.view.tools.camera.orthographic);
    EXPECT_FALSE(state.open.frameWanted) << "the camera would be framed again";
    EXPECT_EQ(state.view.outlinerFilter, "thigh");
    EXPECT_TRUE(state.view.outliner.onlyWithMuscles);
    EXPECT_TRUE(state.view.outliner.helperBones);
    EXPECT_EQ(state.view.outliner.folded, std::set<std::string>{"hips/spine"});
    const Visibility& visibility = state.document.visibility;
    EXPECT_EQ(visibility.hidden.muscles, std::set<PrimitiveId>{state.document.idAt(2)});
    EXPECT_EQ(visibility.locked.muscles, std::set<PrimitiveId>{state.document.idAt(3)});
    EXPECT_EQ(visibility.hidden.bones, std::set<std::string>{state.character().skeleton.bones[4].path});
  }

  const test::TemporaryFolder own;
  const fs::path folder = own.path();
};

TEST_F(ViewMemory, IsRestoredAtTheNextStartWithoutTouchingTheRigFile) {
  const std::string before = bytesOf(folder / "demo.rig.json");
  {
    EditorState state;
    SessionKeeper one = keeper();
    one.start(state);
    ASSERT_TRUE(openFile(state, folder / "demo.rig.json"));
    arrange(state);
    one.finish(state, kWindowPlace);
  }
  EditorState next;
  SessionKeeper two = keeper();
  two.start(next);
  ASSERT_TRUE(openFile(next, folder / "demo.rig.json"));
  expectArranged(next);
  EXPECT_FALSE(next.document.commands.modified());
  EXPECT_EQ(bytesOf(folder / "demo.rig.json"), before);
  EXPECT_FALSE(fs::exists(folder / "demo.rig.json.view")) << "nothing beside it either";
}

TEST_F(ViewMemory, IsRestoredAfterAnotherFileWasOpen) {
  EditorState state;
  SessionKeeper one = keeper();
  one.start(state);
  ASSERT_TRUE(openFile(state, folder / "demo.rig.json"));
  arrange(state);
  ASSERT_TRUE(openFile(state, folder / "other.glb"));
  EXPECT_TRUE(state.document.visibility.plain());
  EXPECT_TRUE(state.open.frameWanted);
  state.view.display.shading = Shading::kTextured;
  state.view.display.skeleton = false;
  state.view.tools.camera = {};
  state.view.outlinerFilter.clear();
  state.view.outliner = {};
  ASSERT_TRUE(openFile(state, folder / "demo.rig.json"));
  expectArranged(state);
}

TEST_F(ViewMemory, IsStoredOnceTheViewRests) {
  EditorState state;
  SessionKeeper one = keeper();
  one.start(state);
  ASSERT_TRUE(openFile(state, folder / "demo.rig.json"));
  arrange(state);
  for (double now = 0.0; now < 4.0; now += 0.25) one.tick(state, now, kWindowPlace);
  const auto kept = loadView(folder / "views", folder / "demo.rig.json");
  ASSERT_TRUE(kept.has_value()) << "a crash would lose it";
  EXPECT_EQ(kept->at("display").at("shading").text(""), "clay");
  // Playback alone writes nothing, since the time keeps changing.
  state.open.transport.playing = true;
  for (double now = 4.0; now < 8.0; now += 0.25) one.tick(state, now, kWindowPlace);
  fs::remove_all(folder / "views");
  for (double now = 8.0; now < 20.0; now += 0.25) {
    state.open.transport.time = 0.01 * now;
    one.tick(state, now, kWindowPlace);
  }
  EXPECT_FALSE(fs::exists(folder / "views"));
}

TEST_F(ViewMemory, TwoEditorsKeepTheirOwnFiles) {
  EditorState first, second;
  SessionKeeper one = keeper(), two = keeper();
  one.start(first);
  two.start(second);
  ASSERT_TRUE(openFile(first, folder / "demo.rig.json"));
  ASSERT_TRUE(openFile(second, folder / "other.glb"));
  arrange(first);
  second.view.display.shading = Shading::kHeat;
  one.finish(first, kWindowPlace);
  two.finish(second, kWindowPlace);
  EditorState third;
  SessionKeeper three = keeper();
  three.start(third);
  ASSERT_TRUE(openFile(third, folder / "other.glb"));
  EXPECT_EQ(third.view.display.shading, Shading::kHeat);
  ASSERT_TRUE(openFile(third, folder / "demo.rig.json"));
  expectArranged(third);
}

TEST_F(ViewMemory, RangeOfMotionClipIsRecreated) {
  EditorState state;
  SessionKeeper one = keeper();
  one.start(state);
  ASSERT_TRUE(openFile(state, folder / "demo.rig.json"));
  playRangeOfMotion(state);
  state.open.transport.playing = false;
  state.open.transport.time = 3.0;
  one.finish(state, kWindowPlace);
  EditorState next;
  SessionKeeper two = keeper();
  two.start(next);
  ASSERT_TRUE(openFile(next, folder / "demo.rig.json"));
  EXPECT_EQ(next.open.transport.clip, findClip(next.character(), kRangeOfMotionName));
  EXPECT_DOUBLE_EQ(next.open.transport.time, 3.0);
}

// Whatever the file contains, the document opens, and invalid values get their defaults.
TEST_F(ViewMemory, InvalidValuesAreIgnored) {
  EditorState fresh;
  ASSERT_TRUE(openFile(fresh, folder / "demo.rig.json"));
  const Json nonsense[] = {
      Json(),
      Json(3),
      Json::array(),
      Json::object().set("clip", 3).set("camera", "x").set("display", Json::array()).set("hidden", 1),
      Json::object()
          .set("clip", Json::object().set("name", "no such clip").set("time", 1e300))
          .set("camera", Json::object().set("target", Json::array().push("a").push(1).push(2)).set("height", 99)),
      Json::object()
          .set("clip",
               Json::object().set("name", "Walk").set("time", -1).set("speed", 0).set("range", Json::array().push(9)))
          .set("display", Json::object().set("shading", "glass"))
          .set("hidden", Json::object().set("muscles", Json::array().push("nobody").push(4)).set("bones", 2)),
  };
  for (const Json& view : nonsense) {
    ASSERT_TRUE(storeView(folder / "views", folder / "demo.rig.json", view).ok());
    EditorState state;
    SessionKeeper one = keeper();
    one.start(state);
    ASSERT_TRUE(openFile(state, folder / "demo.rig.json")) << view.dump();
    EXPECT_EQ(state.open.transport.clip, fresh.open.transport.clip) << view.dump();
    EXPECT_DOUBLE_EQ(state.open.transport.time, 0.0);
    EXPECT_EQ(state.open.transport.speed, 1.0f);
    EXPECT_EQ(state.view.display, fresh.view.display);
    EXPECT_TRUE(state.open.frameWanted);
    EXPECT_TRUE(state.document.visibility.plain());
    EXPECT_TRUE(state.session.messages.empty());
  }
}

TEST_F(ViewMemory, SamplesAreNotRemembered) {
  const fs::path sample = fs::path(SINEW_SOURCE_DIR) / "assets" / "demo.rig.json";
  EditorState state;
  SessionKeeper one = keeper();
  one.start(state);
  ASSERT_TRUE(openFile(state, sample));
  arrange(state);
  one.finish(state, kWindowPlace);
  EXPECT_FALSE(fs::exists(folder / "views"));
}

}  // namespace
}  // namespace sinew::app
