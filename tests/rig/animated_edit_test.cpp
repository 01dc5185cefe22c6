// tests/rig/animated_edit_test.cpp: edits of keys, drivers and channels, and the references between them.

#include "core/rig/animated_edit.h"

#include <limits>

#include <gtest/gtest.h>

#include "core/rig/line_edit.h"
#include "core/rig/validation.h"
#include "sinew/rig/rig_edit.h"

namespace sinew {
namespace {

constexpr NumberRef kRadius{Parameter::kRadiusX, 0};

struct AnimatedEdit : testing::Test {
  Rig rig;

  AnimatedEdit() {
    MuscleLine line;
    line.name = "biceps";
    line.origin = {"upper", {0.0f, 1.0f, 0.0f}, {}};
    line.insertion = {"fore", {0.0f, 1.0f, 0.0f}, {}};
    rig = addLine(rig, line).value();
    Primitive belly;
    belly.name = "belly";
    belly.bone = "upper";
    belly.line = "biceps";
    rig = addPrimitive(rig, belly).value();
    Primitive other;
    other.name = "other";
    other.bone = "upper";
    rig = addPrimitive(rig, other).value();
  }
  ~AnimatedEdit() override { EXPECT_TRUE(validate(rig)) << validate(rig).error().text(); }

  void edit(const Result<Rig>& edited) {
    ASSERT_TRUE(edited) << edited.error().text();
    rig = edited.value();
  }
  [[nodiscard]] const std::vector<glm::vec2>& points(const std::string& clip) const {
    return trackIn(animationOf(rig, kRadius)->keys, clip)->curve.points;
  }
  static Driver lengthDriver() {
    Driver driver;
    driver.input.kind = DriverInputKind::kLength;
    driver.input.line = "biceps";
    driver.curve.points = {{0.7f, 1.0f}, {1.0f, 0.0f}};
    return driver;
  }
};

TEST_F(AnimatedEdit, KeysStaySortedAndReplaceNearOnes) {
  edit(setKey(rig, kRadius, "Walk", 0.5f, 2.0f));
  edit(setKey(rig, kRadius, "Walk", 0.1f, 1.0f));
  edit(setKey(rig, kRadius, "Walk", 0.503f, 3.0f));
  EXPECT_EQ(points("Walk"), (std::vector<glm::vec2>{{0.1f, 1.0f}, {0.503f, 3.0f}}));
  edit(setKey(rig, kRadius, "", 0.2f, 9.0f));
  EXPECT_EQ(points("Run"), (std::vector<glm::vec2>{{0.2f, 9.0f}})) << "a track without a clip is for every clip";
  EXPECT_EQ(points("Walk").size(), 2u) << "but a clip's own comes first";
  edit(moveKey(rig, kRadius, "Walk", 0, 0.9f));
  EXPECT_EQ(points("Walk"), (std::vector<glm::vec2>{{0.503f, 3.0f}, {0.9f, 1.0f}}));
  EXPECT_EQ(trackIn(animationOf(rig, kRadius)->keys, ""), nullptr) << "no clip, no keys";
}

TEST_F(AnimatedEdit, RemovingTheLastKeyRemovesItsTrackAndEntry) {
  const Rig before = rig;
  edit(setKey(rig, kRadius, "Walk", 0.5f, 2.0f));
  edit(setKey(rig, kRadius, "Walk", 0.7f, 2.0f));
  edit(removeKey(rig, kRadius, "Walk", 1));
  EXPECT_EQ(points("Walk").size(), 1u);
  edit(removeKey(rig, kRadius, "Walk", 0));
  EXPECT_EQ(rig, before);
}

TEST_F(AnimatedEdit, RefusesValuesAFileCannotHold) {
  EXPECT_FALSE(setKey(rig, kRadius, "Walk", -1.0f, 2.0f));
  EXPECT_FALSE(setKey(rig, kRadius, "Walk", 1.0f, std::numeric_limits<float>::quiet_NaN()));
  Driver driver = lengthDriver();
  driver.input.line = "nothing";
  EXPECT_FALSE(setDriver(rig, kRadius, driver));
  driver = lengthDriver();
  driver.curve.points.clear();
  EXPECT_FALSE(setDriver(rig, kRadius, driver));
  for (int i = 0; i <= 16; ++i) driver.curve.points.push_back({static_cast<float>(i), 0.0f});
  EXPECT_FALSE(setDriver(rig, kRadius, driver)) << "17 points";
  EXPECT_EQ(animationOf(rig, kRadius), nullptr);
}

TEST_F(AnimatedEdit, DrivenKeysShareOneDriver) {
  DriverInput bend;
  bend.bone = "fore";
  edit(setDrivenKey(rig, kRadius, bend, 0.0f, 1.0f));
  edit(setDrivenKey(rig, kRadius, bend, 90.0f, 1.5f));
  edit(setDrivenKey(rig, kRadius, bend, 90.3f, 1.6f));
  const AnimatedNumber& number = *animationOf(rig, kRadius);
  ASSERT_EQ(number.drivers.size(), 1u);
  EXPECT_EQ(number.drivers[0].mode, DriverMode::kReplace);
  EXPECT_EQ(number.drivers[0].curve.points, (std::vector<glm::vec2>{{0.0f, 1.0f}, {90.3f, 1.6f}}));
  bend.bone = "upper";
  edit(setDrivenKey(rig, kRadius, bend, 0.0f, 1.0f));
  EXPECT_EQ(animationOf(rig, kRadius)->drivers.size(), 2u) << "another input, another driver";
}

TEST_F(AnimatedEdit, LengthDriversFollowAndAreRemovedWithTheirLine) {
  const NumberRef other{Parameter::kAmount, 1};
  edit(setDriver(rig, other, lengthDriver()));
  edit(renameLine(rig, 0, "biceps L"));
  EXPECT_EQ(animationOf(rig, other)->drivers[0].input.line, "biceps L");
  const std::vector<int> first{0};
  edit(removePrimitives(rig, first));
  EXPECT_TRUE(rig.lines.empty());
  EXPECT_EQ(animationOf(rig, {Parameter::kAmount, 0}), nullptr) << "the driver went with its line";
}

TEST_F(AnimatedEdit, ChannelsAreRenamedAndRemovedWithTheirDrivers) {
  edit(setChannelKey(rig, "effort", "Lift", 0.0f, 0.0f));
  edit(setChannelKey(rig, "effort", "", 0.0f, 1.0f));
  Driver driver = lengthDriver();
  driver.input = {};
  driver.input.kind = DriverInputKind::kChannel;
  driver.input.channel = "effort";
  edit(setDriver(rig, kRadius, driver));
  edit(renameChannel(rig, "effort", "strain"));
  EXPECT_EQ(animationOf(rig, kRadius)->drivers[0].input.channel, "strain");
  EXPECT_GE(findChannel(rig, "strain", "Lift"), 0);
  edit(removeChannel(rig, "strain"));
  EXPECT_TRUE(rig.channels.empty());
  EXPECT_EQ(animationOf(rig, kRadius), nullptr);
}

TEST_F(AnimatedEdit, CopiesAndRenamedMusclesKeepTheirDrivers) {
  edit(setDriver(rig, kRadius, lengthDriver()));
  edit(renamePrimitive(rig, 0, "renamed"));
  EXPECT_NE(animationOf(rig, kRadius), nullptr);
  Primitive copy = rig.primitives[0];
  copy.mirror.clear();
  edit(addPrimitive(rig, copy));
  EXPECT_EQ(rig.primitives.back().animated, rig.primitives[0].animated);
}

}  // namespace
}  // namespace sinew
