// tests/rig/driven_numbers_test.cpp: parameters that follow the pose: combined, within range, independent of history.

#include <cmath>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

#include "core/character/pose_override.h"
#include "core/rig/animated_edit.h"
#include "core/rig/attachment.h"
#include "core/rig/driver_input.h"
#include "core/rig/line_edit.h"
#include "core/rig/validation.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/allocations.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/driven_rig.h"
#include "tests/support/rigs/random_animation.h"

namespace sinew {
namespace {

struct DrivenParameters : testing::Test {
  std::shared_ptr<const Character> character = test::makeLimb();
  const Skeleton& skeleton = character->skeleton;
  Rig rig;

  DrivenParameters() {
    Primitive belly;
    belly.name = "belly";
    belly.bone = "middle";
    belly.placement.radii = {0.2f, 0.3f, 0.2f};
    rig = addPrimitive(rig, belly).value();
  }

  [[nodiscard]] Pose bentBy(float degrees) const {
    const int bone = *skeleton.findBone("middle");
    const glm::vec3 along = boneDirection(skeleton.bones[static_cast<std::size_t>(bone)]);
    const glm::vec3 across = glm::normalize(glm::cross(along, glm::vec3(0.3f, 0.2f, 0.9f)));
    PoseOverrides overrides;
    overrides.set(bone, glm::angleAxis(glm::radians(degrees), across));
    return posed(skeleton, bindPose(skeleton), overrides);
  }
  [[nodiscard]] static Driver byBend(DriverMode mode, std::vector<glm::vec2> points) {
    Driver driver;
    driver.input.bone = "middle";
    driver.curve = {std::move(points), CurveKind::kLinear};
    driver.mode = mode;
    return driver;
  }
  void drive(Parameter parameter, const Driver& driver) {
    rig = setDriver(rig, {parameter, 0}, driver).value();
    ASSERT_TRUE(validate(rig)) << validate(rig).error().text();
  }
  [[nodiscard]] float at(Parameter parameter, const Pose& pose) const {
    return numberOf(test::drivenRig(rig, *character, pose), {parameter, 0});
  }
};

TEST_F(DrivenParameters, DriversApplyInOrder) {
  drive(Parameter::kRadiusX, byBend(DriverMode::kAdd, {{0.0f, 0.0f}, {90.0f, 0.1f}}));
  EXPECT_NEAR(at(Parameter::kRadiusX, bentBy(45.0f)), 0.25f, 1e-4f);
  drive(Parameter::kRadiusX, byBend(DriverMode::kMultiply, {{0.0f, 1.0f}, {90.0f, 2.0f}}));
  EXPECT_NEAR(at(Parameter::kRadiusX, bentBy(45.0f)), 0.375f, 1e-4f);
  drive(Parameter::kRadiusX, byBend(DriverMode::kReplace, {{0.0f, 0.5f}, {90.0f, 0.7f}}));
  EXPECT_NEAR(at(Parameter::kRadiusX, bentBy(45.0f)), 0.6f, 1e-4f);
  EXPECT_EQ(at(Parameter::kRadiusY, bentBy(45.0f)), 0.3f) << "what is not driven stays";
}

TEST_F(DrivenParameters, KeysReplaceTheNumberOnlyInTheirClip) {
  const AnimationClip& clip = character->clips.front();
  rig = setKey(rig, {Parameter::kRadiusX, 0}, clip.name, 0.5f, 0.4f).value();
  rig = setKey(rig, {Parameter::kRadiusX, 0}, clip.name, 1.5f, 0.8f).value();
  rig = setKeyKind(rig, {Parameter::kRadiusX, 0}, clip.name, CurveKind::kLinear).value();
  EXPECT_NEAR(at(Parameter::kRadiusX, samplePose(skeleton, clip, 1.0f)), 0.6f, 1e-5f);
  EXPECT_EQ(at(Parameter::kRadiusX, samplePose(skeleton, clip, 0.0f)), 0.4f);
  EXPECT_EQ(at(Parameter::kRadiusX, bindPose(skeleton)), 0.2f);
  AnimationClip other = clip;
  other.name = "other";
  EXPECT_EQ(at(Parameter::kRadiusX, samplePose(skeleton, other, 1.0f)), 0.2f);
  drive(Parameter::kRadiusX, byBend(DriverMode::kAdd, {{0.0f, 0.1f}}));
  EXPECT_NEAR(at(Parameter::kRadiusX, samplePose(skeleton, clip, 1.0f)), 0.7f, 1e-5f) << "drivers join the keyed value";
}

TEST_F(DrivenParameters, ChannelsAreSampledAtTheCurrentTime) {
  const AnimationClip& clip = character->clips.front();
  rig = setChannelKey(rig, "effort", clip.name, 0.0f, 0.0f).value();
  rig = setChannelKey(rig, "effort", clip.name, 2.0f, 1.0f).value();
  Driver driver = byBend(DriverMode::kAdd, {{0.0f, 0.0f}, {1.0f, 0.4f}});
  driver.input = {};
  driver.input.kind = DriverInputKind::kChannel;
  driver.input.channel = "effort";
  drive(Parameter::kRadiusX, driver);
  EXPECT_NEAR(at(Parameter::kRadiusX, samplePose(skeleton, clip, 1.0f)), 0.4f, 1e-5f);
  EXPECT_EQ(at(Parameter::kRadiusX, bindPose(skeleton)), 0.2f);
}

TEST_F(DrivenParameters, LengthsUseTheUnanimatedLine) {
  MuscleLine line;
  line.name = "flexor";
  line.origin = {"root", {0.1f, 0.2f, 0.0f}, {}};
  line.insertion = {"middle", {0.1f, 0.3f, 0.0f}, {}};
  rig = addLine(rig, line).value();
  rig = setLineOfSeveral(rig, std::vector<int>{0}, 0);
  Driver driver = byBend(DriverMode::kReplace, {{0.0f, 0.0f}, {10.0f, 10.0f}});
  driver.input = {};
  driver.input.kind = DriverInputKind::kLength;
  driver.input.line = "flexor";
  drive(Parameter::kReach, driver);
  // The line's own rest length is driven too: no driver reads another's result.
  rig = setDriver(rig, {Parameter::kRest, 0}, byBend(DriverMode::kReplace, {{0.0f, 3.0f}})).value();
  for (const float degrees : {-60.0f, 30.0f, 80.0f}) {
    const Pose pose = bentBy(degrees);
    const float stretch = posedLine(lineRest(rig.lines[0], *character).value(), skeleton, pose).stretch;
    EXPECT_NEAR(at(Parameter::kReach, pose), std::max(stretch, 1.05f), 1e-5f);
    EXPECT_EQ(at(Parameter::kRest, pose), 3.0f);
  }
}

TEST_F(DrivenParameters, DistancesAreRelativeToTheBindPose) {
  Driver driver = byBend(DriverMode::kReplace, {{0.0f, 0.0f}, {10.0f, 10.0f}});
  driver.input = {};
  driver.input.kind = DriverInputKind::kDistance;
  driver.input.from = {"root", {0.1f, 0.1f, 0.0f}, {}};
  driver.input.to = {"middle", {0.1f, 0.4f, 0.0f}, {}};
  const Parameter bend = parameterNamed("bend.x").value();
  drive(bend, driver);
  drive(Parameter::kRadiusY, driver);
  EXPECT_NEAR(at(Parameter::kRadiusY, bindPose(skeleton)), 1.0f, 1e-6f);
  const Pose pose = bentBy(70.0f);
  const auto point = [&](const LineAnchor& anchor, const Pose& in) {
    return glm::vec3(in.boneInWorld[static_cast<std::size_t>(*skeleton.findBone(anchor.bone))] *
                     glm::vec4(anchor.point, 1.0f));
  };
  const auto apart = [&](const Pose& in) {
    return glm::distance(point(driver.input.from, in), point(driver.input.to, in));
  };
  EXPECT_NEAR(at(Parameter::kRadiusY, pose), apart(pose) / apart(bindPose(skeleton)), 1e-5f);
  EXPECT_LE(at(bend, pose), kMostBend) << "brought into range";
}

TEST_F(DrivenParameters, WidthsOfTheSurfaceAreDrivenEachOnItsOwn) {
  rig.surface.grooves = 0.02f;
  drive(Parameter::kGrooves, byBend(DriverMode::kMultiply, {{0.0f, 1.0f}, {90.0f, 3.0f}}));
  EXPECT_NEAR(at(Parameter::kGrooves, bentBy(45.0f)), 0.04f, 1e-5f);
  EXPECT_EQ(at(Parameter::kSkinBlend, bentBy(45.0f)), kDefaultSkinBlend);
  drive(Parameter::kSkinBlend, byBend(DriverMode::kReplace, {{0.0f, 0.1f}}));
  drive(Parameter::kGrooves, byBend(DriverMode::kReplace, {{0.0f, -5.0f}, {90.0f, 5.0f}}));
  EXPECT_EQ(at(Parameter::kSkinBlend, bentBy(45.0f)), 0.1f);
  EXPECT_EQ(at(Parameter::kGrooves, bentBy(0.0f)), 0.0f) << "brought into range";
  EXPECT_EQ(at(Parameter::kGrooves, bentBy(90.0f)), kMostGrooves);
}

TEST_F(DrivenParameters, DriverOfAMissingBoneIsIgnoredAndListed) {
  Driver driver = byBend(DriverMode::kReplace, {{0.0f, 0.7f}});
  driver.input.bone = "tail";
  drive(Parameter::kRadiusX, driver);
  EXPECT_EQ(at(Parameter::kRadiusX, bentBy(40.0f)), 0.2f);
  const std::vector<MissingBone> missing = missingBones(rig, skeleton);
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_EQ(missing[0].place, "primitives[0].animated[0].drivers[0].input.bone");
}

TEST(DrivenRigs, AreValidAndDoNotDependOnHistory) {
  const auto character = test::makeLimb();
  const AnimationClip& clip = character->clips.front();
  int changed = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Rig rig = test::animatedLimbRig(*character, seed);
    ASSERT_TRUE(validate(rig)) << validate(rig).error().text();
    const RigPoser poser(rig, *character);
    PosedRig passing;
    for (const float time : {0.0f, 1.7f, 0.4f, 1.1f, 0.0f, 0.4f}) {
      Pose pose = samplePose(character->skeleton, clip, time);
      if (time == 1.1f) pose = bindPose(character->skeleton);
      poser.pose(pose, passing);
      const Rig alone = test::drivenRig(rig, *character, pose);
      EXPECT_EQ(test::withNumbers(rig, passing.numbers), alone);
      EXPECT_TRUE(validate(alone)) << validate(alone).error().text();
      changed += alone != rig ? 1 : 0;
    }
  }
  EXPECT_GT(changed, 100);
}

TEST(DrivenRigs, RepeatedPosingAllocatesNothing) {
  const auto character = test::makeLimb();
  const AnimationClip& clip = character->clips.front();
  const Rig rig = test::animatedLimbRig(*character, 7);
  const RigPoser poser(rig, *character);
  ASSERT_TRUE(poser.drivesMuscles());
  PosedRig posed;
  const Pose first = samplePose(character->skeleton, clip, 0.3f);
  const Pose second = samplePose(character->skeleton, clip, 1.3f);
  poser.pose(first, posed);
  const std::int64_t before = test::allocations();
  poser.pose(second, posed);
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace sinew
