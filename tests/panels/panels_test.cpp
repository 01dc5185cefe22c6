// tests/panels/panels_test.cpp: mouse input to the panels, and the resulting rig.

#include "tests/support/editor/headless_editor.h"

#include <cmath>
#include "tests/support/editor/muscles_named.h"

namespace sinew::app {
namespace {

class Panels : public HeadlessEditor {};

TEST_F(Panels, ControlsAreOnScreenInEveryState) {
  const auto check = [&] {
    for (const auto& [id, box] : widgets().rectangles()) {
      EXPECT_GE(box.x, 0.0f) << id;
      EXPECT_GE(box.y, 0.0f) << id;
      EXPECT_LE(box.x + box.z, 1280.0f) << id;
      EXPECT_LE(box.y + box.w, 800.0f) << id;
      EXPECT_GT(box.z, 0.0f) << id;
      EXPECT_GT(box.w, 0.0f) << id;
    }
  };
  check();
  addOne();
  check();
  for (const Menu& menu : menus()) {
    click(std::string("menu/") + menu.id);
    // Rows of a submenu are visible once it is open.
    const auto submenuOf = [](std::string_view id) {
      for (const char* submenu : {"file/export", "edit/shape", "view/light", "view/background"}) {
        if (id.starts_with(std::string(submenu) + '-')) return std::string(submenu);
      }
      constexpr std::string_view kLooks = " view/front view/back view/left view/right view/top view/bottom ";
      const bool looks = kLooks.find(' ' + std::string(id) + ' ') != std::string_view::npos;
      return std::string(looks ? "view/look" : "");
    };
    for (const Action& action : actions()) {
      if (action.menu() != menu.id) continue;
      const std::string submenu = submenuOf(action.id);
      if (!submenu.empty() && !shown(action.id)) click(submenu);
      EXPECT_TRUE(shown(action.id)) << action.id;
    }
    check();
    press(kEscape);
  }
  for (const char* combo : {"inspector/bone", "inspector/group", "timeline/clip"}) {
    click(combo);
    check();
    press(kEscape);
  }
  selectNothing(state);  // Without a selected muscle the panels below have room.
  settle();
  for (const char* combo : {"surface/mode", "smoothing/patch"}) {
    click(combo);
    check();
    press(kEscape);
  }
  showOpenDialog(state);
  settle();
  check();
  EXPECT_TRUE(shown("dialog/path") && shown("dialog/ok") && shown("dialog/cancel"));
}

TEST_F(Panels, FieldDragIsOneStep) {
  addOne();
  const float before = muscle().placement.radii.x;
  const std::size_t done = steps();
  drag("inspector/radius.x", {40.0f, 0.0f});
  EXPECT_GT(muscle().placement.radii.x, before);
  EXPECT_EQ(steps(), done + 1);
  press(kKeyZ, true);
  EXPECT_EQ(muscle().placement.radii.x, before);
}

TEST_F(Panels, TypedValueIsOneStepAndExact) {
  addOne();
  const std::size_t done = steps();
  doubleClick("inspector/center.y");
  press(kKeyA, true);
  type("0.375");
  press(kEnter);
  EXPECT_EQ(muscle().placement.center.y, 0.375f);
  EXPECT_EQ(steps(), done + 1);
}

TEST_F(Panels, EscapeRestoresTheValueNotItsRoundedText) {
  addOne();
  Placement odd = muscle().placement;
  odd.center = {0.123456789f, 0.2f, 0.3f};
  state.document.commands.apply("Odd", setPlacementOf(odd));
  settle();
  const std::size_t done = steps();
  doubleClick("inspector/center.x");
  press(kKeyA, true);
  type("7");
  press(kEscape);
  EXPECT_EQ(muscle().placement.center.x, odd.center.x);
  EXPECT_EQ(steps(), done);
}

TEST_F(Panels, DisplayingARotationNeverChangesIt) {
  addOne();
  Placement odd = muscle().placement;
  odd.rotation = glm::normalize(glm::quat(0.3f, 0.5f, -0.7f, 0.2f));
  state.document.commands.apply("Odd", setPlacementOf(odd));
  for (int i = 0; i < 100; ++i) frame();
  EXPECT_EQ(muscle().placement.rotation, odd.rotation);
  doubleClick("inspector/rotation.z");
  press(kEnter);
  EXPECT_EQ(muscle().placement.rotation, odd.rotation);
}

TEST_F(Panels, TypedAnglesAreShownAsTyped) {
  addOne();
  // At 90 degrees about y the Euler angles are not unique: recomputed from the rotation they would jump.
  for (const char* field : {"inspector/rotation.x", "inspector/rotation.y", "inspector/rotation.z"}) {
    doubleClick(field);
    press(kKeyA, true);
    type(std::string(field).back() == 'y' ? "90" : "30");
    press(kEnter);
  }
  EXPECT_EQ(state.open.euler.degrees, glm::vec3(30.0f, 90.0f, 30.0f));
  EXPECT_NEAR(glm::length(muscle().placement.rotation), 1.0f, 1e-6f);
}

TEST_F(Panels, RadiusOfZeroIsRefused) {
  addOne();
  doubleClick("inspector/radius.x");
  press(kKeyA, true);
  type("0");
  press(kEnter);
  EXPECT_GT(muscle().placement.radii.x, 0.0f);
}

TEST_F(Panels, ToleranceSliderUpdatesLiveInOneStep) {
  const std::size_t triangles = state.live->surface().refinement->triangles.size();
  drag("smoothing/tolerance", {-60.0f, 0.0f});
  EXPECT_GT(state.live->surface().refinement->triangles.size(), triangles);
  EXPECT_EQ(steps(), 1u);
}

TEST_F(Panels, DetailKindIsChosenInOneStep) {
  EXPECT_EQ(state.document.rig().smoothing.detail, DetailKind::kAdaptive) << "a new rig";
  EXPECT_EQ(state.document.rig().surface.grooves, kNewGrooves);
  EXPECT_FALSE(shown("smoothing/depth"));
  click("smoothing/detail");
  click("smoothing/detail/uniform");
  EXPECT_EQ(state.document.rig().smoothing.detail, DetailKind::kUniform);
  EXPECT_TRUE(state.live->surface().refinement->isUniform);
  EXPECT_TRUE(shown("smoothing/depth"));
  EXPECT_FALSE(shown("smoothing/tolerance"));
  EXPECT_EQ(steps(), 1u);
}

/// Makes the detail uniform, as one step.
void makeUniform(EditorState& state) {
  SmoothingSettings settings = state.document.rig().smoothing;
  settings.detail = DetailKind::kUniform;
  state.document.commands.apply("Detail", setSmoothing(state.document.rig(), settings).value());
}

TEST_F(Panels, DepthSliderUpdatesLiveInOneStep) {
  makeUniform(state);
  settle();
  const std::size_t triangles = state.live->surface().refinement->triangles.size();
  drag("smoothing/depth", {80.0f, 0.0f});
  EXPECT_GT(state.live->surface().refinement->triangles.size(), triangles);
  EXPECT_EQ(steps(), 2u);
}

TEST_F(Panels, AutoDepthDisablesTheSliderInOneStep) {
  makeUniform(state);
  settle();
  const int own = state.document.rig().smoothing.depth;
  click("smoothing/auto");
  EXPECT_TRUE(state.document.rig().smoothing.autoDepth);
  EXPECT_EQ(steps(), 2u);
  drag("smoothing/depth", {80.0f, 0.0f});
  EXPECT_EQ(steps(), 2u);
  EXPECT_EQ(state.document.rig().smoothing.depth, own);
  click("smoothing/auto");
  EXPECT_FALSE(state.document.rig().smoothing.autoDepth);
  EXPECT_EQ(steps(), 3u);
}

TEST_F(Panels, CreaseSliderIsOneStep) {
  drag("smoothing/crease", {-80.0f, 0.0f});
  EXPECT_LT(state.document.rig().smoothing.creaseAngle, kDefaultCreaseAngle);
  EXPECT_GE(state.document.rig().smoothing.creaseAngle, 0.0f);
  EXPECT_EQ(steps(), 1u);
  press(kKeyZ, true);
  EXPECT_EQ(state.document.rig().smoothing.creaseAngle, kDefaultCreaseAngle);
}

TEST_F(Panels, KeysEditAndUndo) {
  addOne();
  const std::string name = muscle().name;
  press(kDelete);
  EXPECT_TRUE(state.document.rig().primitives.empty());
  press(kKeyZ, true);
  ASSERT_EQ(state.document.rig().primitives.size(), 1u);
  EXPECT_EQ(state.document.activePrimitive(), 0);
  press(kF2);
  ASSERT_TRUE(shown("outliner/rename"));
  press(kKeyA, true);
  type("biceps");
  press(kEnter);
  EXPECT_EQ(muscle().name, "biceps");
  EXPECT_EQ(state.document.activeName(), "biceps");
  press(kKeyZ, true);
  EXPECT_EQ(muscle().name, name);
  EXPECT_EQ(state.document.activePrimitive(), 0);
}

TEST_F(Panels, TypingInTheSearchDoesNotRunShortcuts) {
  addOne();
  click("outliner/search");
  press(kDelete);
  press(kSpace);
  EXPECT_EQ(state.document.rig().primitives.size(), 1u);
  EXPECT_FALSE(state.open.transport.playing);
}

TEST_F(Panels, PlayButtonAndSpaceToggle) {
  click("timeline/play");
  EXPECT_TRUE(state.open.transport.playing);
  press(kSpace);
  EXPECT_FALSE(state.open.transport.playing);
}

TEST_F(Panels, QuitPromptsAboutUnsavedChanges) {
  addOne();
  request(state, {IntentKind::kQuit, {}});
  settle();
  EXPECT_FALSE(state.session.quit);
  click("unsaved/cancel");
  EXPECT_FALSE(state.session.quit);
  EXPECT_FALSE(shown("unsaved/cancel"));
  request(state, {IntentKind::kQuit, {}});
  settle();
  click("unsaved/discard");
  EXPECT_TRUE(state.session.quit);
}

TEST_F(Panels, BundledRigIsNeverOverwritten) {
  ASSERT_TRUE(openFile(state, std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "demo.rig.json"));
  EXPECT_FALSE(save(state, {}));
  EXPECT_EQ(state.dialogs.file.kind, DialogKind::kSaveAs);
  EXPECT_NE(state.dialogs.file.folder.filename(), "assets");
}

TEST_F(Panels, FailedOpenKeepsTheDocumentAndAddsAMessage) {
  addOne();
  EXPECT_FALSE(openFile(state, "/nowhere/absent.glb"));
  settle();
  EXPECT_EQ(state.document.rig().primitives.size(), 1u);
  ASSERT_EQ(state.session.messages.size(), 1u);
  EXPECT_NE(state.session.messages[0].text.find("absent.glb"), std::string::npos);
  click("messages/dismiss/0");
  EXPECT_TRUE(state.session.messages.empty());
}

TEST_F(Panels, SplittersResizeAndResetLayoutRestoresThem) {
  const float before = state.view.layout.left;
  drag("layout/left", {60.0f, 0.0f});
  EXPECT_NEAR(state.view.layout.left, before + 60.0f, 1.0f);
  run(action("window/reset-layout"), state);
  EXPECT_EQ(state.view.layout.left, before);
}

TEST_F(Panels, SignAndGroupAreSingleSteps) {
  addOne();
  click("inspector/carves");
  EXPECT_EQ(muscle().sign, -1);
  EXPECT_EQ(steps(), 2u);
  click("inspector/group");
  click("inspector/group-new");
  EXPECT_EQ(state.document.rig().groups.size(), 2u);
  EXPECT_EQ(muscle().group, state.document.rig().groups[1].name);
  EXPECT_EQ(steps(), 3u);
}

}  // namespace
}  // namespace sinew::app
