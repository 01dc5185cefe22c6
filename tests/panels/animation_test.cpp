// tests/panels/animation_test.cpp: keys and drivers of numbers: context menu of fields, driven keys, the inspector's
// section and its curves.

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "app/editor/animate.h"
#include "app/editor/edit.h"
#include "app/panels/curve_editor.h"
#include "app/panels/field_edit.h"
#include "app/panels/timeline.h"
#include "core/rig/animated_edit.h"
#include "core/rig/driver_input.h"
#include "tests/support/editor/clip_editor.h"
#include "tests/support/editor/muscles_named.h"
#include "tests/support/rigs/driven_rig.h"

namespace sinew::app {
namespace {

constexpr const char* kRadius = "inspector/radius.x";
constexpr const char* kLower = "forearm.L";

/// Only "biceps L" is selected.
class Animation : public ClipEditor {
 protected:
  void SetUp() override {
    ClipEditor::SetUp();
    select(state.document, {"biceps L"});
    settle();
  }
  [[nodiscard]] NumberRef radius() const { return {Parameter::kRadiusX, state.document.activePrimitive()}; }
  [[nodiscard]] const AnimatedNumber* animated() const { return animationOf(state.document.rig(), radius()); }
  [[nodiscard]] float drawn() const { return numberOf(state.document.rig(), radius()); }
  /// Computed from the definition, independent of the panels.
  [[nodiscard]] float now() const {
    return numberOf(test::drivenRig(state.document.rig(), state.character(), state.live->pose()), radius());
  }
  [[nodiscard]] float bend() const {
    DriverInput input;
    input.bone = kLower;
    return sinew::inputNow(input, state.document.rig(), state.character(), state.live->pose()).value();
  }
  void turnElbow(float degrees) {
    const int bone = state.character().skeleton.findBone(kLower).value();
    const glm::vec3 along = glm::normalize(state.character().skeleton.bones[static_cast<std::size_t>(bone)].tip);
    const glm::vec3 other = std::abs(along.x) < 0.7f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 0.0f, 1.0f);
    const glm::vec3 across = glm::normalize(glm::cross(along, other));
    state.open.transport.overrides.set(bone, glm::angleAxis(glm::radians(degrees), across));
    keepPose(state, "Pose");
    settle();
  }
  void hover(const std::string& id) {
    queue.move(center(id));
    settle();
    settle();
  }
  /// Walks through the submenus of a number's context menu.
  void choose(std::initializer_list<const char*> entries) {
    click(kRadius, 1);
    for (const char* entry : entries) {
      if (entry == *(entries.end() - 1)) click(std::string("context/") + entry);
      else hover(std::string("context/") + entry);
    }
    settle();
  }
  [[nodiscard]] const std::string& label() const {
    return state.document.commands.label(state.document.commands.position());
  }
};

TEST_F(Animation, KeyStoresTheFieldValueAtTheCurrentTime) {
  goTo(0.2);
  typeInto(kRadius, "0.1");
  hover(kRadius);
  press(kKeyK);
  goTo(0.8);
  typeInto(kRadius, "0.05");
  EXPECT_NEAR(now(), 0.1f, 1e-6f) << "the keys replace the number";
  hover(kRadius);
  press(kKeyK);
  EXPECT_EQ(label(), "Key radius X of biceps L at 0.80 s");
  ASSERT_NE(animated(), nullptr);
  const KeyTrack& track = animated()->keys.at(0);
  EXPECT_EQ(track.clip, state.character().clips.at(0).name);
  ASSERT_EQ(track.curve.points.size(), 2u);
  EXPECT_NEAR(track.curve.points[0].x, 0.2f, 1e-6f);
  EXPECT_NEAR(now(), 0.05f, 1e-6f);
  goTo(0.5);
  EXPECT_LT(now(), 0.1f);
  EXPECT_GT(now(), 0.05f);
  // Between two keys: toggling the other key changes nothing.
  const float between = now();
  choose({"key-now"});
  EXPECT_EQ(animated()->keys.at(0).curve.points.size(), 3u);
  EXPECT_EQ(now(), between);
  choose({"key-remove"});
  EXPECT_EQ(animated()->keys.at(0).curve.points.size(), 2u);
  hover(kRadius);
  press(kKeyK);  // Nothing was set since the last key: the shown value is keyed.
  EXPECT_EQ(now(), between);
  choose({"key-remove"});
  const std::vector<glm::vec3> keyed = state.live->surface().positions;
  choose({"keys-remove"});
  EXPECT_EQ(animated(), nullptr);
  EXPECT_NE(state.live->surface().positions, keyed) << "the surface follows the keys";
  undoAll();
  EXPECT_EQ(state.document.rig(), opened);
}

TEST_F(Animation, FieldShowsWhatAnimatesItsNumber) {
  const auto look = [&] {
    WidgetLog log;
    PanelUi ui(state, log, fonts);
    return lookOf(ui, {{radius()}, {1.0f}, "%.3f"});
  };
  EXPECT_EQ(look().words, "");
  choose({"key"});
  EXPECT_TRUE(look().keyedHere && look().keyNow && !look().driven);
  goTo(0.5);
  EXPECT_TRUE(look().keyedHere && !look().keyNow);
  choose({"drive", "drive/bend", "drive/bend/near/forearm.L"});
  EXPECT_EQ(look().words.find("Drawn " + numberText("%.3f", drawn()) + ", now " + numberText("%.3f", now()) +
                              ": 1 driver, 1 key in " + state.character().clips[0].name),
            0u);
  chooseClip(state.open.transport, 1, state.character());
  settle();
  EXPECT_TRUE(look().driven && look().keyedElsewhere && !look().keyedHere);
}

TEST_F(Animation, BindPoseTakesNoKeys) {
  chooseClip(state.open.transport, -1, state.character());
  settle();
  hover(kRadius);
  const Action& key = action("edit/key");
  EXPECT_FALSE(key.enabled(state));
  EXPECT_STREQ(key.enabled(state).reason(), "Choose a clip first: the bind pose has no time");
  choose({"key"});  // Grayed out.
  EXPECT_EQ(animated(), nullptr);
  EXPECT_EQ(steps(), 0u);
}

TEST_F(Animation, KeyingSeveralMusclesIsOneStepWithEachMusclesOwnValue) {
  select(state.document, {"calf L", "biceps L"});
  settle();
  choose({"key"});
  EXPECT_EQ(steps(), 1u);
  for (const char* name : {"calf L", "biceps L"}) {
    const Rig& rig = state.document.rig();
    const Primitive& muscle = rig.primitives[static_cast<std::size_t>(findPrimitive(rig, name))];
    const AnimatedNumber* number = animationOf(muscle.animated, Parameter::kRadiusX);
    ASSERT_NE(number, nullptr) << name;
    EXPECT_EQ(number->keys.at(0).curve.points.at(0).y, muscle.placement.radii.x) << name;
  }
}

TEST_F(Animation, MenuAddsABendDriver) {
  choose({"drive", "drive/bend", "drive/bend/near/forearm.L"});
  EXPECT_EQ(label(), "Drive radius X of biceps L by bend of forearm.L");
  ASSERT_NE(animated(), nullptr);
  EXPECT_EQ(now(), drawn() + valueAt(animated()->drivers.at(0).curve, bend()));
  turnElbow(-80.0f);
  EXPECT_GT(bend(), 60.0f);
  EXPECT_GT(now(), 1.05f * drawn());
  choose({"animation-remove"});
  undoAll();
  EXPECT_EQ(state.document.rig(), opened);
}

TEST_F(Animation, MenuAddsAxisAndDistanceDrivers) {
  choose({"drive", "drive/axis", "drive/axis/near/forearm.L", "drive/axis/near/forearm.L/Z"});
  EXPECT_EQ(label(), "Drive radius X of biceps L by turn about Z of forearm.L");
  choose({"drive", "drive/distance", "drive/distance/near/upper_arm.L", "drive/distance/near/upper_arm.L/hand.L"});
  EXPECT_EQ(label(), "Drive radius X of biceps L by distance from upper_arm.L to hand.L");
  turnElbow(-80.0f);
  EXPECT_LT(inputNow(state, animated()->drivers.at(1).input).value(), 0.9f);
  choose({"drive", "drive/distance", "drive/distance/near/upper_arm.L", "drive/distance/near/upper_arm.L/upper_arm.L"});
  EXPECT_EQ(animated()->drivers.size(), 2u) << "a joint has no distance from itself";
}

TEST_F(Animation, NewChannelIsMadeWithItsDriver) {
  choose({"drive", "drive/channel", "drive/channel-new"});
  EXPECT_EQ(steps(), 1u);
  ASSERT_EQ(state.document.rig().channels.size(), 1u);
  EXPECT_EQ(animated()->drivers.at(0).input.channel, state.document.rig().channels[0].name);
}

TEST_F(Animation, DrivenKeysAreSetByPosingWithoutChangingTheRestValue) {
  const float before = drawn();
  choose({"set-driven", "set-driven/bend", "set-driven/bend/near/forearm.L"});
  ASSERT_TRUE(shown("driven-key/now"));
  EXPECT_EQ(steps(), 0u) << "nothing is set yet";
  press(kKeyK);
  const float straight = bend();
  turnElbow(-80.0f);
  typeInto(kRadius, "0.11");
  EXPECT_EQ(drawn(), before);
  EXPECT_NEAR(now(), 0.11f, 1e-6f);
  ASSERT_EQ(animated()->drivers.size(), 1u);
  const Curve curve = animated()->drivers[0].curve;
  ASSERT_EQ(curve.points.size(), 2u);
  EXPECT_NEAR(curve.points[0].x, straight, 1e-3f);
  EXPECT_EQ(curve.points[0].y, before);
  // A drag at the same pose replaces the point, in one step.
  const std::size_t stepsBefore = steps();
  drag(kRadius, {30.0f, 0.0f});
  EXPECT_EQ(steps(), stepsBefore + 1);
  EXPECT_EQ(animated()->drivers[0].curve.points.size(), 2u);
  EXPECT_GT(now(), 0.11f);
  turnElbow(-40.0f);
  EXPECT_LT(now(), 0.11f);
  EXPECT_GT(now(), before);
  press(kEscape);
  EXPECT_FALSE(state.open.animate.drivenKey.isOn());
  EXPECT_FALSE(state.document.selection.primitives.empty()) << "Esc ends one thing at a time";
  typeInto(kRadius, "0.2");
  EXPECT_EQ(drawn(), 0.2f) << "the field is the number's again";
  undoAll();
  EXPECT_EQ(state.document.rig(), opened);
}

TEST_F(Animation, DrivenKeysOfSeveralMusclesKeepTheirProportions) {
  select(state.document, {"calf L", "biceps L"});
  settle();
  const auto valueOf = [&](const char* name) {
    const Rig& rig = state.document.rig();
    const NumberRef ref{Parameter::kRadiusX, findPrimitive(rig, name)};
    return numberOf(test::drivenRig(rig, state.character(), state.live->pose()), ref);
  };
  const float share = valueOf("calf L") / valueOf("biceps L");
  const float before = valueOf("biceps L");
  choose({"set-driven", "set-driven/bend", "set-driven/bend/near/forearm.L"});
  drag(kRadius, {40.0f, 0.0f});
  EXPECT_EQ(steps(), 1u);
  EXPECT_GT(valueOf("biceps L"), before);
  EXPECT_NEAR(valueOf("calf L") / valueOf("biceps L"), share, 1e-4f);
  typeInto(kRadius, "0.08");
  EXPECT_NEAR(valueOf("calf L"), 0.08f, 1e-6f);
  EXPECT_NEAR(valueOf("biceps L"), 0.08f, 1e-6f);
}

TEST_F(Animation, DrivenKeyModeEndsWhenItsMuscleIsDeleted) {
  choose({"set-driven", "set-driven/bend", "set-driven/bend/near/forearm.L"});
  ASSERT_TRUE(state.open.animate.drivenKey.isOn());
  press(kDelete);
  settle();
  EXPECT_FALSE(state.open.animate.drivenKey.isOn());
}

TEST_F(Animation, CurveIsEditedWithThePointer) {
  choose({"drive", "drive/bend", "drive/bend/near/forearm.L"});
  choose({"drivers"});
  const std::string curve = "inspector/animation/radii.x/0/curve";
  ASSERT_TRUE(shown(curve));
  const std::size_t stepsBefore = steps();
  doubleClick(curve);
  EXPECT_EQ(animated()->drivers.at(0).curve.points.size(), 3u);
  EXPECT_EQ(steps(), stepsBefore + 1);
  const glm::vec2 before = animated()->drivers.at(0).curve.points.at(1);
  drag(curve, {0.0f, -20.0f});
  EXPECT_EQ(steps(), stepsBefore + 2) << "a drag is one step";
  const glm::vec2 after = animated()->drivers.at(0).curve.points.at(1);
  EXPECT_GT(after.y, before.y);
  EXPECT_NEAR(after.x, before.x, 1.0f);
  undo(state);
  settle();
  const std::size_t muscles = state.document.rig().primitives.size();
  hover(curve);
  press(kDelete);
  EXPECT_EQ(animated()->drivers.at(0).curve.points.size(), 2u);
  EXPECT_EQ(state.document.rig().primitives.size(), muscles);
}

TEST_F(Animation, SectionSetsModeAndKindAndRemovesDrivers) {
  choose({"drive", "drive/bend", "drive/bend/near/forearm.L"});
  choose({"drivers"});
  const std::string driver = "inspector/animation/radii.x/0";
  click(driver + "/mode");
  click(driver + "/mode/multiply");
  EXPECT_EQ(animated()->drivers.at(0).mode, DriverMode::kMultiply);
  click(driver + "/kind");
  click(driver + "/kind/linear");
  EXPECT_EQ(animated()->drivers.at(0).curve.kind, CurveKind::kLinear);
  click(driver + "/remove");
  EXPECT_EQ(animated(), nullptr);
  EXPECT_FALSE(shown("inspector/animation"));
}

TEST_F(Animation, TimelineRowsMoveAndRemoveKeys) {
  EXPECT_EQ(keyRowsHeight(state), 0.0f);
  const float height = state.frame.viewport.w;
  goTo(0.2);
  choose({"key"});
  goTo(0.6);
  choose({"key"});
  settle();
  EXPECT_LT(state.frame.viewport.w, height);
  const std::string row = "timeline/row/radius X of biceps L";
  ASSERT_TRUE(shown(row + "/key/1"));
  const std::size_t stepsBefore = steps();
  const float perSecond = (center(row + "/key/1").x - center(row + "/key/0").x) / 0.4f;
  drag(row + "/key/1", {0.2f * perSecond, 0.0f});
  EXPECT_EQ(steps(), stepsBefore + 1) << "a drag is one step";
  EXPECT_NEAR(animated()->keys.at(0).curve.points.at(1).x, 0.8f, 0.02f);
  // Past the other key, which stays.
  drag(row + "/key/1", {-0.7f * perSecond, 0.0f});
  ASSERT_EQ(animated()->keys.at(0).curve.points.size(), 2u);
  EXPECT_NEAR(animated()->keys.at(0).curve.points.at(0).x, 0.1f, 0.02f);
  EXPECT_NEAR(animated()->keys.at(0).curve.points.at(1).x, 0.2f, 1e-3f);
  click(row + "/key/1", 1);
  click("context/kind/step");
  EXPECT_EQ(animated()->keys.at(0).curve.kind, CurveKind::kStep);
  click(row + "/key/1", 1);
  click("context/key-remove");
  EXPECT_EQ(animated()->keys.at(0).curve.points.size(), 1u);
  click(row + "/key/0", 1);
  click("context/key-remove");
  EXPECT_EQ(keyRowsHeight(state), 0.0f);
  EXPECT_EQ(state.document.rig(), opened);
}

TEST_F(Animation, ChannelRowShowsItsValueAndTakesKeys) {
  choose({"drive", "drive/channel", "drive/channel-new"});
  settle();
  const std::string row = "timeline/row/channel effort";
  goTo(0.5);
  typeInto(row + "/value", "0.75");
  ASSERT_EQ(state.document.rig().channels.at(0).track.curve.points.size(), 2u);
  EXPECT_EQ(state.document.rig().channels[0].track.curve.points[1].y, 0.75f);
  EXPECT_GT(now(), drawn());
  const std::size_t stepsBefore = steps();
  doubleClick(row);
  EXPECT_EQ(state.document.rig().channels[0].track.curve.points.size(), 3u);
  EXPECT_EQ(steps(), stepsBefore + 1);
  click(row, 1);
  click("context/channel-name");
  press(kKeyA, true);
  type("tension");
  press(kEnter);
  EXPECT_EQ(state.document.rig().channels[0].name, "tension");
  EXPECT_EQ(animated()->drivers.at(0).input.channel, "tension");
  click("timeline/row/channel tension", 1);
  click("context/channel-remove");
  EXPECT_TRUE(state.document.rig().channels.empty());
  EXPECT_EQ(state.document.rig(), opened);
}

TEST_F(Animation, SelectedCurvePointTakesTypedNumbers) {
  choose({"drive", "drive/bend", "drive/bend/near/forearm.L"});
  choose({"drivers"});
  const std::string driver = "inspector/animation/radii.x/0";
  click(driver + "/curve/1");
  typeInto(driver + "/point.x", "120");
  EXPECT_EQ(animated()->drivers.at(0).curve.points.at(1).x, 120.0f);
  for (int i = 0; i < 30; ++i) frame();  // Long enough not to count as a multiple click.
  typeInto(driver + "/point.x", "-5");   // Would precede the first point.
  EXPECT_EQ(animated()->drivers.at(0).curve.points.at(1).x, 120.0f);
  EXPECT_FALSE(state.session.messages.empty());
  click(driver + "/curve/0", 1);
  EXPECT_EQ(animated()->drivers.at(0).curve.points.size(), 1u);
}

TEST_F(Animation, NumbersOfTheSurfaceAreKeyedInItsPanel) {
  const auto pointAt = [&](const std::string& id) {
    queue.move(center(id));
    settle();
  };
  if (!shown("surface/skin-blend")) click("inspector/header");
  pointAt("surface/skin-blend");
  press(kKeyK);
  EXPECT_EQ(label().substr(0, 18), "Key skin blend at ");
  ASSERT_EQ(state.document.rig().surface.animated.size(), 1u);
  EXPECT_TRUE(shown("surface/animation"));
  EXPECT_FALSE(shown("inspector/animation"));
  pointAt("surface/grooves");
  press(kKeyK);
  EXPECT_EQ(label().substr(0, 15), "Key grooves at ");
  ASSERT_EQ(state.document.rig().surface.animated.size(), 2u);
  EXPECT_EQ(state.document.rig().surface.animated[1].parameter, Parameter::kGrooves);
}

TEST(CurveEdits, PointsStayInOrder) {
  Curve curve{{{0.0f, 1.0f}, {2.0f, 3.0f}}, CurveKind::kSmooth};
  curve = withPoint(curve, {1.0f, 5.0f});
  EXPECT_EQ(curve.points.at(1), glm::vec2(1.0f, 5.0f));
  EXPECT_EQ(withPoint(curve, {1.0f, 7.0f}), curve);
}

TEST_F(Animation, KeyOfAnEveryClipTrackGoesIntoThatTrack) {
  state.document.commands.apply("Key", setKey(state.document.rig(), radius(), "", 0.0f, 0.1f).value());
  goTo(0.5);
  choose({"key"});
  ASSERT_NE(animated(), nullptr);
  ASSERT_EQ(animated()->keys.size(), 1u);
  EXPECT_EQ(animated()->keys[0].clip, "");
  EXPECT_EQ(animated()->keys[0].curve.points.size(), 2u);
}

}  // namespace
}  // namespace sinew::app
