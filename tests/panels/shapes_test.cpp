// tests/panels/shapes_test.cpp: the Shapes tab: sliders, groups, search, reset, keys and drivers.
#include "app/editor/animate.h"
#include "core/rig/rig_edit.h"
#include "sinew/files/rig_json.h"
#include "tests/support/characters/morphing_post.h"
#include "tests/support/editor/headless_editor.h"
#include "tests/support/temporary_folder.h"

namespace sinew::app {
namespace {

/// A post with morph targets "bulge.0", "dent.1", "bulge.2", "dent.3" and "smile".
class ShapesPanel : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    test::Post post = test::makeMorphingPost(5, 2);
    post.file.json["meshes"][0]["extras"]["targetNames"][4] = "smile";
    ASSERT_TRUE(openFile(state, folder.write("post.glb", post.file.glb())));
    state.open.transport.playing = false;
    settle();
    click("shapes/tab");
  }
  /// Waits until a click no longer counts as part of a double click.
  void rest() {
    for (int i = 0; i < 40; ++i) frame();
  }
  [[nodiscard]] float weight(const std::string& name) const {
    const int index = findMorph(state.document.rig(), name);
    return index < 0 ? -99.0f : state.document.rig().morphs[static_cast<std::size_t>(index)].weight;
  }

  test::TemporaryFolder folder;
};

TEST_F(ShapesPanel, CharacterWithoutShapesHasNoSearchField) {
  ASSERT_TRUE(openFile(state, std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "demo.glb"));
  settle();
  EXPECT_FALSE(shown("shapes/search"));
  EXPECT_TRUE(state.document.rig().morphs.empty());
}

TEST_F(ShapesPanel, OpeningDoesNotModifyTheDocument) {
  EXPECT_EQ(state.document.rig().morphs.size(), 5u);
  EXPECT_EQ(steps(), 0u);
  EXPECT_FALSE(state.document.commands.modified());
}

TEST_F(ShapesPanel, DragIsOneStepThatChangesTheSurface) {
  const Surface before = state.live->surface();
  drag("shapes/smile", {30.0f, 0.0f});
  EXPECT_GT(weight("smile"), 0.05f);
  EXPECT_EQ(steps(), 1u);
  EXPECT_NE(state.live->surface().positions, before.positions);
  state.document.commands.undo();
  settle();
  EXPECT_EQ(weight("smile"), 0.0f);
  EXPECT_EQ(state.live->surface().positions, before.positions);
}

TEST_F(ShapesPanel, TypedNumbersMayExceedTheSliderWithinLimits) {
  typeInto("shapes/smile", "2.5");
  EXPECT_EQ(weight("smile"), 2.5f);
  rest();
  typeInto("shapes/smile", "-1");
  EXPECT_EQ(weight("smile"), -1.0f);
  rest();
  typeInto("shapes/smile", "40");
  EXPECT_EQ(weight("smile"), -1.0f);
}

TEST_F(ShapesPanel, GroupsFoldAndSearchOpensThem) {
  EXPECT_TRUE(shown("shapes/group/bulge"));
  EXPECT_TRUE(shown("shapes/group/dent"));
  EXPECT_FALSE(shown("shapes/group/smile"));
  click("shapes/group/bulge");
  EXPECT_FALSE(shown("shapes/bulge.0"));
  EXPECT_TRUE(shown("shapes/dent.1"));
  click("shapes/search");
  type("bulge");
  EXPECT_TRUE(shown("shapes/bulge.0")) << "what is looked for is shown, folded or not";
  EXPECT_FALSE(shown("shapes/dent.1"));
}

TEST_F(ShapesPanel, ResetSetsAllToZeroInOneStep) {
  typeInto("shapes/smile", "0.5");
  typeInto("shapes/dent.1", "1");
  const std::size_t before = steps();
  click("shapes/reset");
  EXPECT_EQ(weight("smile"), 0.0f);
  EXPECT_EQ(weight("dent.1"), 0.0f);
  EXPECT_EQ(steps(), before + 1);
}

TEST_F(ShapesPanel, DrivenShapeShowsItsCurveUnderItsName) {
  DriverInput input;
  input.bone = "knee";
  const std::array refs{NumberRef{Parameter::kMorphWeight, findMorph(state.document.rig(), "smile")}};
  driveNumbers(state, refs, input);
  settle();
  ASSERT_EQ(state.document.rig().morphs.back().animated.size(), 1u);
  EXPECT_TRUE(shown("inspector/animation/weight/0"));
  click("shapes/name/smile");
  EXPECT_FALSE(shown("inspector/animation/weight/0"));
  click("shapes/name/smile");
  EXPECT_TRUE(shown("inspector/animation/weight/0/curve"));
  click("inspector/animation/weight/0/remove");
  EXPECT_TRUE(state.document.rig().morphs.back().animated.empty());
}

/// A rig may name shapes that its character lacks. Reset to zero, they stay listed until the document is reopened.
TEST_F(ShapesPanel, ShapeMissingFromTheCharacterCanBeReset) {
  const Rig rig = setMorphWeight(state.document.rig(), "gone", 0.5f).value();
  const auto file = folder.path() / "gone.rig.json";
  ASSERT_TRUE(saveRig(rig, file).ok());
  ASSERT_TRUE(openFile(state, file));
  settle();
  EXPECT_EQ(weight("gone"), 0.5f);
  click("shapes/gone", 1);
  click("context/reset");
  EXPECT_EQ(weight("gone"), 0.0f);
  EXPECT_TRUE(shown("shapes/gone"));
  ASSERT_TRUE(saveDocument(state.document, file).ok());
  ASSERT_TRUE(openFile(state, file));
  settle();
  EXPECT_FALSE(shown("shapes/gone"));
}

TEST_F(ShapesPanel, WeightsAreSavedAndReopened) {
  typeInto("shapes/smile", "0.5");
  const auto file = folder.path() / "post.rig.json";
  ASSERT_TRUE(saveDocument(state.document, file).ok());
  const Rig saved = loadRig(file).value();
  ASSERT_EQ(saved.morphs.size(), 1u);
  EXPECT_EQ(saved.morphs[0].name, "smile");
  ASSERT_TRUE(openFile(state, file));
  settle();
  EXPECT_EQ(state.document.rig().morphs.size(), 5u);
  EXPECT_EQ(weight("smile"), 0.5f);
  EXPECT_FALSE(state.document.commands.modified());
}

}  // namespace
}  // namespace sinew::app
