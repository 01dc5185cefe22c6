// tests/panels/key_rows_test.cpp: dragging keys along their rows.

#include "app/panels/timeline.h"

#include <gtest/gtest.h>

#include "core/rig/twins.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/characters/synthetic_characters.h"

namespace sinew::app {
namespace {

const std::vector<glm::vec2>& pointsOf(const Rig& rig, int primitive) {
  return rig.primitives[static_cast<std::size_t>(primitive)].animated.at(0).keys.at(0).curve.points;
}

TEST(KeyRows, RestingDragKeepsBothTwinsKeysInPlace) {
  const auto character = test::makeTwoLegged();
  const MirrorPlan plan = makeMirrorPlan(*character);
  Primitive thigh;
  thigh.name = "thigh L";
  thigh.bone = "leg L";
  Rig start = addPair({}, thigh, plan).value();
  const NumberRef radius{Parameter::kRadiusX, 0};
  for (const float time : {0.2f, 0.8f}) {
    const Rig keyed = setKey(start, radius, "cross", time, time).value();
    start = keepTwins(start, start, keyed, plan);
  }
  ASSERT_EQ(pointsOf(start, 1).size(), 2u);
  const KeyRow row{"row", "radius", radius, {}, *trackIn(start.primitives[0].animated[0].keys, "cross")};
  Rig shown = start;
  for (const float time : {0.6f, 0.5f, 0.5f, 0.5f, 0.1f, 0.1f}) {
    shown = keepTwins(start, shown, withKeyMoved(start, shown, row, 1, time).value(), plan);
    for (const int twin : {0, 1}) {
      ASSERT_EQ(pointsOf(shown, twin).size(), 2u);
      EXPECT_EQ(pointsOf(shown, twin)[time < 0.2f ? 0 : 1].x, time);
    }
  }
}

TEST(KeyRows, ChannelKeyCanBeDraggedPastAnother) {
  Rig start = setChannelKey({}, "effort", "Walk", 0.5f, 0.0f).value();
  start = setChannelKey(start, "effort", "Walk", 0.7f, 1.0f).value();
  KeyRow row{"row", "channel effort", {}, "effort", start.channels[0].track};
  Rig shown = start;
  for (const float time : {0.6f, 0.503f, 0.5f, 0.4f}) {
    const Result<Rig> moved = withKeyMoved(start, shown, row, 1, time);
    ASSERT_TRUE(moved) << moved.error().text();
    shown = moved.value();
    row.track = shown.channels[0].track;
  }
  EXPECT_EQ(shown.channels[0].track.curve.points, (std::vector<glm::vec2>{{0.4f, 1.0f}, {0.5f, 0.0f}}));
}

}  // namespace
}  // namespace sinew::app
