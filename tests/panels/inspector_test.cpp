// tests/panels/inspector_test.cpp: one or many muscles: common values, units, reset, copy and paste, territory.

#include "tests/support/editor/headless_editor.h"

#include <algorithm>

#include "core/rig/attachment.h"
#include "tests/support/editor/muscles_named.h"

namespace sinew::app {
namespace {

/// Bundled rig with all sections of the inspector visible.
class Inspector : public HeadlessEditor {
 protected:
  void SetUp() override {
    HeadlessEditor::SetUp();
    ASSERT_TRUE(openFile(state, std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "demo.rig.json"));
    state.open.transport.playing = false;
    settle();
  }
  [[nodiscard]] const Primitive& named(const std::string& name) const {
    return state.document.rig().primitives[static_cast<std::size_t>(findPrimitive(state.document.rig(), name))];
  }
  void select(std::initializer_list<const char*> names) {
    state.document.selection.clear();
    for (const char* name : names) state.document.selection.primitives.push_back(idOf(state.document, name));
    settle();
  }
  [[nodiscard]] std::vector<int> territory(const std::string& name) const {
    const Skeleton& skeleton = state.character().skeleton;
    return territoryBones(named(name), skeleton.findBone(named(name).bone).value(), nullptr, skeleton);
  }
};

TEST_F(Inspector, TypedNumberAppliesToAllInOneStep) {
  select({"thigh L", "chest L", "tail root"});
  typeInto("inspector/reach", "2.5");
  for (const char* name : {"thigh L", "chest L", "tail root"}) EXPECT_EQ(named(name).reach, 2.5f) << name;
  // Twins of the selected muscles follow; others stay.
  EXPECT_NE(named("calf L").reach, 2.5f);
  EXPECT_EQ(steps(), 1u);
}

TEST_F(Inspector, DragKeepsTheProportionsOfDifferentRadii) {
  select({"thigh L", "tail root"});
  const float thigh = named("thigh L").placement.radii.x;
  const float tail = named("tail root").placement.radii.x;
  drag("inspector/radius.x", {40.0f, 0.0f});
  EXPECT_GT(named("tail root").placement.radii.x, tail);
  EXPECT_NEAR(named("thigh L").placement.radii.x / thigh, named("tail root").placement.radii.x / tail, 1e-4f);
  EXPECT_EQ(steps(), 1u);
}

TEST_F(Inspector, DragMovesAllMusclesByTheSameAmount) {
  select({"thigh L", "calf L"});
  const glm::vec3 thigh = named("thigh L").placement.center;
  const glm::vec3 calf = named("calf L").placement.center;
  drag("inspector/center.y", {30.0f, 0.0f});
  const float moved = named("calf L").placement.center.y - calf.y;
  EXPECT_GT(moved, 0.0f);
  EXPECT_NEAR(named("thigh L").placement.center.y - thigh.y, moved, 1e-5f);
  EXPECT_EQ(named("thigh L").placement.center.x, thigh.x);
}

TEST_F(Inspector, ShapesUseTheLongestAxisAndApplyToTheTwin) {
  select({"thigh L"});
  const glm::vec3 radii = named("thigh L").placement.radii;
  click("inspector/shape");
  typeInto("inspector/core", "0.5");
  const Placement& thigh = named("thigh L").placement;
  EXPECT_EQ(thigh.shape.core, 0.5f);
  EXPECT_EQ(named("thigh R").placement.shape.core, 0.5f);
  EXPECT_EQ(thigh.radii.y, std::max({radii.x, radii.y, radii.z}));
  typeInto("inspector/bend.z", "-0.25");
  EXPECT_EQ(named("thigh L").placement.shape.bend.y, -0.25f);
  typeInto("inspector/belly", "0.2");
  EXPECT_EQ(std::abs(named("thigh R").placement.shape.belly), 0.2f);
  EXPECT_EQ(steps(), 3u);
  press(kKeyZ, true);
  press(kKeyZ, true);
  press(kKeyZ, true);
  EXPECT_TRUE(named("thigh L").placement.shape.isPlain());
  EXPECT_EQ(named("thigh L").placement.radii, radii);
}

TEST_F(Inspector, LargerReachReducesTheBellyWithAMessage) {
  select({"tail root"});
  typeInto("inspector/reach", "1.2");
  click("inspector/shape");
  typeInto("inspector/belly", "9");
  const float most = mostBelly(0.0f, 1.2f);
  EXPECT_EQ(named("tail root").placement.shape.belly, most);
  typeInto("inspector/reach", "2");
  EXPECT_EQ(named("tail root").placement.shape.belly, mostBelly(0.0f, 2.0f));
  ASSERT_TRUE(state.session.toast);
  EXPECT_NE(state.session.toast->text.find("larger reach"), std::string::npos) << state.session.toast->text;
}

TEST_F(Inspector, PercentIsRelativeToTheCharactersHeight) {
  select({"tail root"});
  click("inspector/lengths/% of h");
  typeInto("inspector/radius.x", "10");
  EXPECT_NEAR(named("tail root").placement.radii.x, 0.1f * state.character().height, 1e-5f);
  click("inspector/lengths/units");
  typeInto("inspector/radius.x", "0.125");
  EXPECT_EQ(named("tail root").placement.radii.x, 0.125f);
}

TEST_F(Inspector, ContextMenuResetsAField) {
  select({"thigh L", "thigh R"});
  typeInto("inspector/reach", "3");
  click("inspector/reach", 1);
  click("context/reset");
  EXPECT_EQ(named("thigh L").reach, kNewReach);
  EXPECT_EQ(named("thigh R").reach, kNewReach);
  EXPECT_EQ(steps(), 2u);
}

TEST_F(Inspector, ValueIsCopiedFromOneFieldToAnother) {
  select({"thigh L"});
  const float wanted = named("thigh L").placement.radii.y;
  click("inspector/radius.y", 1);
  click("context/copy");
  click("inspector/radius.z", 1);
  click("context/paste");
  EXPECT_EQ(named("thigh L").placement.radii.z, wanted);
}

TEST_F(Inspector, GroupAndEffectApplyToAllSelectedMuscles) {
  select({"thigh L", "chest L"});
  click("inspector/carves");
  EXPECT_EQ(named("thigh L").sign, -1);
  EXPECT_EQ(named("chest L").sign, -1);
  click("inspector/group");
  click("inspector/group/arms");
  EXPECT_EQ(named("thigh L").group, "arms");
  EXPECT_EQ(named("chest L").group, "arms");
  click("inspector/group");
  click("inspector/group-new");
  EXPECT_EQ(named("thigh L").group, named("chest L").group);
  EXPECT_NE(named("thigh L").group, "arms");
  EXPECT_EQ(steps(), 3u);
}

TEST_F(Inspector, BonesAreRemovedFromAndAddedToTheTerritory) {
  select({"tail root"});
  const std::vector<int> standard = territory("tail root");
  ASSERT_GT(standard.size(), 1u);
  click("inspector/territory");
  ASSERT_FALSE(named("tail root").territory);
  const Skeleton& skeleton = state.character().skeleton;
  const std::string gone = skeleton.fileName(standard.front());
  click("inspector/territory-remove/" + gone);
  ASSERT_TRUE(named("tail root").territory);
  EXPECT_EQ(territory("tail root").size(), standard.size() - 1);
  EXPECT_FALSE(std::ranges::binary_search(territory("tail root"), standard.front()));
  click("inspector/territory-add");
  click("inspector/territory-add/" + gone);
  EXPECT_EQ(territory("tail root"), standard);
  EXPECT_EQ(steps(), 2u);
  click("inspector/territory-reset");
  EXPECT_FALSE(named("tail root").territory);
}

TEST_F(Inspector, TerritoryModeTogglesClickedBonesAndEndsWithEscape) {
  select({"tail root"});
  const std::vector<int> before = territory("tail root");
  run(action("tool/territory"), state);
  settle();
  ASSERT_TRUE(editsTerritory(state));
  EXPECT_TRUE(state.view.tools.territoryMode);
  EXPECT_EQ(shownTerritory(state), before);
  ASSERT_TRUE(shown("territory/done"));
  // In the list, then in the picture.
  const Skeleton& skeleton = state.character().skeleton;
  const int own = skeleton.findBone("tail.1").value();
  click("outliner/bone/tail.2");
  EXPECT_EQ(steps(), 1u);
  EXPECT_NE(territory("tail root"), before);
  clickAt(pixelOfBone(skeleton.findBone("tail.2").value()));
  EXPECT_EQ(steps(), 2u);
  EXPECT_EQ(territory("tail root"), before);
  EXPECT_TRUE(std::ranges::binary_search(territory("tail root"), own));
  press(kEscape);
  EXPECT_FALSE(editsTerritory(state));
  EXPECT_FALSE(state.view.tools.territoryMode);
  EXPECT_EQ(state.document.activeName(), "tail root");
}

TEST_F(Inspector, TerritoryTintMatchesTheAttachmentWeights) {
  select({"tail root"});
  EXPECT_TRUE(shownTerritoryWeights(state).empty());
  run(action("tool/territory"), state);
  settle();
  const std::vector<float> weights = shownTerritoryWeights(state);
  const Attachment attachment = attach(state.document.rig(), state.character()).value();
  const int index = findPrimitive(state.document.rig(), "tail root");
  ASSERT_EQ(weights.size(), attachment.candidatesOfVertex.size());
  for (std::size_t v = 0; v < weights.size(); ++v) {
    const auto& list = attachment.candidatesOfVertex[v];
    const auto found = std::ranges::find(list, index, &sinew::Candidate::primitive);
    EXPECT_EQ(weights[v], found == list.end() ? 0.0f : found->weight);
  }
}

TEST_F(Inspector, LastTerritoryBoneCannotBeRemoved) {
  select({"tail root"});
  const Skeleton& skeleton = state.character().skeleton;
  const int index = findPrimitive(state.document.rig(), "tail root");
  Rig rig = state.document.rig();
  std::vector<int> bones = territory("tail root");
  while (bones.size() > 1) {
    rig = withTerritoryBone(rig, index, bones.back(), skeleton).value();
    bones.pop_back();
  }
  EXPECT_FALSE(withTerritoryBone(rig, index, bones.front(), skeleton).ok());
}

TEST_F(Inspector, LegendsAreShownWithTheirShading) {
  run(action("view/heat"), state);
  settle();
  EXPECT_TRUE(shown("legend/heat"));
  run(action("view/classes"), state);
  settle();
  EXPECT_TRUE(shown("legend/classes"));
  EXPECT_FALSE(shown("legend/heat"));
  run(action("view/anatomy"), state);
  settle();
  EXPECT_TRUE(shown("legend/anatomy"));
  EXPECT_TRUE(shown("legend/glass"));
  EXPECT_FALSE(shown("legend/classes")) << "the skin is glass, whatever its shading";
}

}  // namespace
}  // namespace sinew::app
