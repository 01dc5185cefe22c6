// tests/panels/animated_links_test.cpp: keys and drivers of how much groups blend, in the matrix and in the graph.

#include "tests/support/editor/clip_editor.h"

#include "app/editor/animate.h"
#include "app/editor/blending_edit.h"
#include "app/panels/blending.h"
#include "app/panels/timeline.h"
#include "core/rig/animated_edit.h"
#include "core/rig/validation.h"

namespace sinew::app {
namespace {

constexpr const char* kCell = "blending/cell/torso/legs";

/// In the Groups tab.
class AnimatedLinks : public ClipEditor {
 protected:
  void SetUp() override {
    ClipEditor::SetUp();
    click("blending/tab");
    ASSERT_TRUE(shown(kCell));
  }
  [[nodiscard]] NumberRef amount() const {
    return {Parameter::kLinkAmount, findLink(state.document.rig(), "legs", "torso")};
  }
  [[nodiscard]] const AnimatedNumber* animated() const {
    return amount().owner < 0 ? nullptr : animationOf(state.document.rig(), amount());
  }
  void choose(const std::vector<std::string>& rows) {
    click(kCell, 1);
    for (const std::string& row : rows) click("context/" + row);
  }
};

TEST_F(AnimatedLinks, AreKeyedUnderThePointerAndInTheMenu) {
  goTo(0.2);
  queue.move(center(kCell));
  settle();
  press(kKeyK);
  ASSERT_NE(animated(), nullptr);
  EXPECT_EQ(state.document.commands.label(1), "Key link amount of legs and torso at 0.20 s");
  drag(kCell, {-60.0f * state.frame.uiScale, 0.0f});
  EXPECT_EQ(numberNow(state, amount()), 1.0f) << "the key replaces the number";
  ASSERT_NE(animated(), nullptr) << "a drag keeps keys";
  goTo(0.6);
  const std::vector<glm::vec3> before = state.live->surface().positions;
  choose({"key"});
  ASSERT_EQ(animated()->keys.at(0).curve.points.size(), 2u);
  EXPECT_EQ(numberNow(state, amount()), linkAmount(state.document.rig(), "legs", "torso"));
  EXPECT_LT(numberNow(state, amount()), 1.0f);
  EXPECT_NE(state.live->surface().positions, before) << "the surface follows the keys";
  const std::vector<KeyRow> rows = keyRows(state);
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].name, "link amount of legs and torso");
  undoAll();
  EXPECT_EQ(state.document.rig(), opened);
}

TEST_F(AnimatedLinks, DriversAreShownBelowTheGroups) {
  choose({"drive", "drive/bend", "drive/bend/forearm.L"});
  ASSERT_NE(animated(), nullptr);
  EXPECT_EQ(state.document.commands.label(1), "Drive link amount of legs and torso by bend of forearm.L");
  ASSERT_TRUE(shown("blending/animation"));
  ASSERT_TRUE(shown("inspector/animation/link_amount/0/curve"));
  EXPECT_LT(valueAt(animated()->drivers.at(0).curve, 90.0f), 0.0f) << "of a whole link: takes it away";
  click("blending/animation/close");
  EXPECT_FALSE(shown("blending/animation"));
  choose({"drivers"});
  EXPECT_TRUE(shown("blending/animation"));
  click("blending/view/graph");
  EXPECT_TRUE(shown("blending/animation"));
  click("inspector/animation/link_amount/0/remove");
  EXPECT_EQ(animated(), nullptr);
  EXPECT_FALSE(shown("blending/animation"));
  EXPECT_TRUE(validate(state.document.rig()));
}

TEST_F(AnimatedLinks, TheGraphOffersTheSame) {
  click("blending/view/graph");
  const std::string edge = shown("blending/edge/legs/torso") ? "blending/edge/legs/torso" : "blending/edge/torso/legs";
  goTo(0.3);
  click(edge, 1);
  click("context/key");
  press(kEscape);
  EXPECT_NE(animated(), nullptr);
  queue.move(center(edge));
  settle();
  goTo(0.7);
  press(kKeyK);
  EXPECT_EQ(animated()->keys.at(0).curve.points.size(), 2u);
}

TEST_F(AnimatedLinks, DrivenKeysAreSetAtThePose) {
  choose({"set-driven", "set-driven/bend", "set-driven/bend/forearm.L"});
  EXPECT_TRUE(state.open.animate.drivenKey.isOn());
  press(kKeyK);
  ASSERT_NE(animated(), nullptr);
  EXPECT_EQ(animated()->drivers.at(0).mode, DriverMode::kReplace);
  EXPECT_EQ(animated()->drivers.at(0).curve.points.at(0).y, 1.0f);
}

TEST_F(AnimatedLinks, NeitherADragNorATypedZeroTakesKeys) {
  choose({"key"});
  drag(kCell, {-400.0f, 0.0f});
  EXPECT_EQ(linkAmount(state.document.rig(), "legs", "torso"), 0.01f);
  EXPECT_NE(animated(), nullptr);
  click(kCell);
  EXPECT_EQ(findLink(state.document.rig(), "legs", "torso"), -1) << "a click unlinks";
  undo(state);
  EXPECT_NE(animated(), nullptr);
}

TEST_F(AnimatedLinks, FollowRenamedGroups) {
  choose({"key"});
  const HeldNumber number = held(state.document.rig(), amount());
  ASSERT_TRUE(renameGroupTo(state, state.document.rig().groups[0].id(), "hind"));
  ASSERT_TRUE(refOf(state.document.rig(), number).has_value());
  EXPECT_NE(animationOf(state.document.rig(), *refOf(state.document.rig(), number)), nullptr);
}

}  // namespace
}  // namespace sinew::app
