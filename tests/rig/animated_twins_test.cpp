// tests/rig/animated_twins_test.cpp: driven twins are mirror images in mirrored poses.

#include "core/rig/animated_edit.h"
#include "core/rig/twins.h"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/character/pose_override.h"
#include "core/rig/line_edit.h"
#include "core/rig/validation.h"
#include "sinew/rig/rig_edit.h"
#include "tests/rig/hamstrings.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/driven_rig.h"
#include "tests/support/rigs/random_animation.h"

namespace sinew {
namespace {

struct AnimatedTwins : testing::Test {
  std::shared_ptr<const Character> character = test::makeTwoLegged();
  const Skeleton& skeleton = character->skeleton;
  MirrorPlan plan = makeMirrorPlan(*character);
  Rig rig = hamstrings(plan);

  AnimatedTwins() {
    Rig bent = rig;
    bent.primitives[0].placement.shape.bend = {0.1f, 0.2f};
    rig = keepTwins(rig, rig, bent, plan);
  }

  void edit(const Result<Rig>& edited) {
    ASSERT_TRUE(edited) << edited.error().text();
    rig = keepTwins(rig, rig, edited.value(), plan);
    ASSERT_TRUE(validate(rig)) << validate(rig).error().text();
  }

  /// A pose of the left leg, and the same of the right one.
  [[nodiscard]] std::array<Pose, 2> anyPoses(test::Random& random) const {
    PoseOverrides left;
    for (const char* name : {"hips", "leg L", "shin L", "leg R"}) {
      const glm::vec3 axis = glm::normalize(
          glm::vec3(random.uniform(-1.0f, 1.0f), random.uniform(-1.0f, 1.0f), random.uniform(0.1f, 1.0f)));
      left.set(*skeleton.findBone(name), glm::angleAxis(random.uniform(-1.2f, 1.2f), axis));
    }
    const PoseOverrides right = mirroredPose(left, skeleton, plan.twinOf, glm::vec3(plan.plane.normal));
    return {posed(skeleton, bindPose(skeleton), left), posed(skeleton, bindPose(skeleton), right)};
  }
};

TEST_F(AnimatedTwins, MirrorEachOtherInMirroredPoses) {
  test::Random random(11);
  const Rig start = rig;
  int driven = 0;
  for (int round = 0; round < 40; ++round) {
    rig = start;
    Rig drawn = rig;
    test::addAnimation(random, {"hips", "leg L", "shin L"}, {"cross"}, drawn);
    Rig edited = rig;
    edited.channels = drawn.channels;
    edited.primitives[0].animated = drawn.primitives[0].animated;
    edited.lines[0].animated = drawn.lines[0].animated;
    edit(edited);
    for (int i = 0; i < 5; ++i) {
      const auto [left, right] = anyPoses(random);
      const Rig here = test::drivenRig(rig, *character, left);
      const Rig there = test::drivenRig(rig, *character, right);
      const Result<Primitive> image = mirroredPrimitive(plan, here.primitives[0]);
      ASSERT_TRUE(image);
      const Primitive& twin = there.primitives[1];
      EXPECT_LT(glm::distance(twin.placement.center, image->placement.center), 2e-3f);
      EXPECT_LT(glm::distance(twin.placement.radii, image->placement.radii), 2e-3f);
      EXPECT_LT(glm::distance(twin.placement.shape.bend, image->placement.shape.bend), 2e-3f);
      EXPECT_NEAR(twin.placement.shape.belly, image->placement.shape.belly, 2e-3f);
      EXPECT_NEAR(twin.amount, here.primitives[0].amount, 2e-3f);
      EXPECT_NEAR(there.lines[1].settings.base, here.lines[0].settings.base, 2e-3f);
      driven += here.primitives[0].placement != rig.primitives[0].placement ? 1 : 0;
    }
  }
  EXPECT_GT(driven, 60);
}

TEST_F(AnimatedTwins, MirroringTwiceGivesTheOriginal) {
  test::Random random(12);
  for (int round = 0; round < 100; ++round) {
    Rig drawn = rig;
    test::addAnimation(random, {"leg L", "shin L"}, {"cross"}, drawn);
    Primitive first = drawn.primitives[0];
    // Steps are rewritten, and products have a mirror image only about 0.
    std::erase_if(first.animated, [](const AnimatedNumber& number) {
      return std::ranges::any_of(number.drivers, [](const Driver& driver) {
        return driver.curve.kind == CurveKind::kStep || driver.mode == DriverMode::kMultiply;
      });
    });
    const Primitive image = mirroredPrimitive(plan, first).value();
    const Primitive back = mirroredPrimitive(plan, image).value();
    ASSERT_EQ(back.animated.size(), first.animated.size());
    for (std::size_t i = 0; i < back.animated.size(); ++i) {
      EXPECT_EQ(back.animated[i].parameter, first.animated[i].parameter);
      ASSERT_EQ(back.animated[i].drivers.size(), first.animated[i].drivers.size());
      for (std::size_t d = 0; d < back.animated[i].drivers.size(); ++d) {
        const Driver& a = first.animated[i].drivers[d];
        const Driver& b = back.animated[i].drivers[d];
        EXPECT_EQ(a.input.kind, b.input.kind);
        EXPECT_EQ(a.input.bone, b.input.bone);
        for (std::size_t p = 0; p < a.curve.points.size(); ++p) {
          EXPECT_NEAR(a.curve.points[p].x, b.curve.points[p].x, 1e-5f);
          EXPECT_NEAR(a.curve.points[p].y, b.curve.points[p].y, 1e-4f);
        }
      }
    }
  }
}

TEST_F(AnimatedTwins, FollowAnEditWithTheTwinsLine) {
  Driver driver;
  driver.input.kind = DriverInputKind::kLength;
  driver.input.line = "hamstring L";
  driver.curve.points = {{0.7f, 0.2f}, {1.0f, 0.0f}};
  edit(setDriver(rig, {Parameter::kRadiusX, 0}, driver));
  ASSERT_EQ(rig.primitives[1].animated.size(), 1u);
  EXPECT_EQ(rig.primitives[1].animated[0].drivers[0].input.line, "hamstring R");
  edit(removeAnimation(rig, {Parameter::kRadiusX, 1}));
  EXPECT_TRUE(rig.primitives[0].animated.empty()) << "and back";
}

TEST_F(AnimatedTwins, StepCurvesAreMirroredOverTwist) {
  Driver driver;
  driver.input.kind = DriverInputKind::kTwist;
  driver.input.bone = "leg L";
  driver.curve = {{{-30.0f, 1.0f}, {10.0f, 2.0f}, {50.0f, 3.0f}}, CurveKind::kStep};
  const Driver image = mirroredDriver(plan, driver).value();
  for (const float x : {-80.0f, -31.0f, -29.0f, 0.0f, 9.0f, 11.0f, 49.0f, 51.0f, 90.0f}) {
    EXPECT_EQ(valueAt(image.curve, -x), valueAt(driver.curve, x)) << x;
  }
}

}  // namespace
}  // namespace sinew
