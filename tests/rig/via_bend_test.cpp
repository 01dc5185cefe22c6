// tests/rig/via_bend_test.cpp: muscles bend with a line around a via point.
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/surface/posed_field.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"

namespace sinew::test {
namespace {

/// A line along y, with a belly of length 8.
LineRest rest() {
  LineRest rest;
  rest.settings.tendons = {0.1f, 0.1f};
  rest.length = 10.0;
  return rest;
}

Placement placed(const glm::vec3& radii, const glm::quat& rotation = glm::quat(1.0f, 0.0f, 0.0f, 0.0f)) {
  return {{0.3f, 0.2f, -0.1f}, rotation, radii};
}

glm::mat4 someCarrier() {
  glm::mat4 carrier = glm::mat4_cast(glm::angleAxis(0.7f, glm::normalize(glm::vec3(0.2f, -1.0f, 0.4f))));
  for (int i = 0; i < 3; ++i) carrier[i] *= 0.8f + 0.3f * static_cast<float>(i);
  carrier[3] = {3.0f, -2.0f, 1.0f, 1.0f};
  return carrier;
}

/// Position of the axis at y in radii, world.
glm::vec3 axisAt(const BentMuscle& muscle, float y) {
  const glm::vec2 bend = (1.0f - y * y) * muscle.placement.shape.bend;
  return glm::vec3(shapeInWorld(muscle.placement, 1.0f, muscle.carrier) * glm::vec4(bend.x, y, bend.y, 1.0f));
}

TEST(ViaBend, MiddleReachesTheViaPointAndTheEndsStay) {
  const ViaBend bend = viaBend(rest(), placed({1.0f, 4.0f, 1.5f}), glm::mat4(1.0f));
  EXPECT_NEAR(bend.share, 1.0f, 1e-6f);
  const glm::mat4 carrier = someCarrier();
  const glm::mat4 inWorld = shapeInWorld(bend.placement, 1.0f, carrier);
  const glm::vec3 shift = glm::vec3(0.4f * inWorld[0] - 0.3f * inWorld[2]);
  const BentMuscle muscle = bentMuscle(bend, carrier, shift);
  EXPECT_NEAR(muscle.placement.shape.bend.x, 0.4f, 1e-5f);
  EXPECT_NEAR(muscle.placement.shape.bend.y, -0.3f, 1e-5f);
  const glm::vec3 whole(inWorld[3]);
  EXPECT_LT(glm::distance(axisAt(muscle, 0.0f), whole), 1e-5f);
  for (const float side : {-1.0f, 1.0f}) {
    const glm::vec3 end = whole + side * glm::vec3(inWorld[1]);
    EXPECT_LT(glm::distance(axisAt(muscle, side), end - shift), 1e-5f) << "where it is without the via point";
  }
}

TEST(ViaBend, BendIsQuadraticInTheFractionAndZeroAcrossTheLine) {
  EXPECT_NEAR(viaBend(rest(), placed({0.5f, 2.0f, 0.5f}), glm::mat4(1.0f)).share, 0.25f, 1e-6f);
  EXPECT_NEAR(viaBend(rest(), placed({0.5f, 40.0f, 0.5f}), glm::mat4(1.0f)).share, 1.0f, 1e-6f);
  float before = 1.0f;
  for (float angle = 0.0f; angle < 1.57f; angle += 0.01f) {
    Placement placement = placed({0.5f, 4.0f, 0.5f}, glm::angleAxis(angle, glm::vec3(0.0f, 0.0f, 1.0f)));
    placement.shape.belly = 0.05f;  // Has a distinguished axis.
    const float share = viaBend(rest(), placement, glm::mat4(1.0f)).share;
    EXPECT_LE(share, before + 1e-6f);
    EXPECT_LT(before - share, 0.05f) << angle;
    before = share;
  }
  EXPECT_EQ(before, 0.0f);
}

TEST(ViaBend, PlainEllipsoidBendsTheSameAlongAnyAxis) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> number(-3.0f, 3.0f);
  for (int along = 0; along < 3; ++along) {
    glm::vec3 radii(1.0f, 1.5f, 0.8f);
    radii[along] = 4.0f;
    glm::vec3 axis(0.0f);
    axis[along] = 1.0f;
    const glm::vec3 to = glm::normalize(glm::vec3(0.2f, 1.0f, -0.1f));
    const glm::quat turn = glm::normalize(glm::quat(1.0f + glm::dot(axis, to), glm::cross(axis, to)));
    const Placement placement = placed(radii, turn);
    const ViaBend bend = viaBend(rest(), placement, glm::mat4(1.0f));
    EXPECT_EQ(bend.placement.radii.y, 4.0f);
    EXPECT_GT(bend.share, 0.9f);
    const UnitBallMap before = unitBallMap(placement, 1.3f, someCarrier());
    const BentMuscle still = bentMuscle(bend, someCarrier(), glm::vec3(0.0f));
    EXPECT_EQ(still.placement.shape, Shape{});
    const UnitBallMap after = unitBallMap(still.placement, 1.3f, still.carrier);
    for (int i = 0; i < 200; ++i) {
      const glm::vec3 point = before.center + glm::vec3(number(random), number(random), number(random));
      EXPECT_NEAR(after.rSquared(point), before.rSquared(point), 1e-4f * (1.0f + before.rSquared(point)));
    }
  }
}

TEST(ViaBend, ExcessBendMovesTheWholeMuscle) {
  const ViaBend bend = viaBend(rest(), placed({1.0f, 4.0f, 1.5f}), glm::mat4(1.0f));
  const glm::mat4 inWorld = shapeInWorld(bend.placement, 1.0f, someCarrier());
  glm::vec3 before = axisAt(bentMuscle(bend, someCarrier(), {}), 1.0f);
  for (float amount = 0.0f; amount < 3.0f; amount += 0.01f) {
    const BentMuscle muscle = bentMuscle(bend, someCarrier(), amount * glm::vec3(inWorld[2]));
    EXPECT_LE(std::abs(muscle.placement.shape.bend.y), kMostBend);
    if (amount < 0.25f) {
      EXPECT_TRUE(muscle.placement.shape.isPlain()) << "what is hardly seen costs nothing";
    } else if (amount > 0.5f) {
      EXPECT_NEAR(muscle.placement.shape.bend.y, std::min(amount, kMostBend), 1e-5f);
    }
    EXPECT_LT(glm::distance(axisAt(muscle, 0.0f), glm::vec3(inWorld[3])), 1e-5f) << amount;
    const glm::vec3 end = axisAt(muscle, 1.0f);
    EXPECT_LT(glm::distance(end, before), 0.04f * glm::length(glm::vec3(inWorld[2]))) << amount;
    before = end;
  }
}

TEST(ViaBend, DrawnMusclesMatchTheField) {
  const std::filesystem::path assets = std::filesystem::path(SINEW_SOURCE_DIR) / "assets";
  const auto character = importGltf(assets / "humanoid.glb").value();
  const Rig rig = loadRig(assets / "humanoid-flex.rig.json").value();
  BlendingGraphMemo graphs;
  const auto preparation = prepare(characterTables(character), rig, {}, nullptr, graphs).value();
  PosedField field;
  int bent = 0;
  const AnimationClip& clip = character->clips.at(0);
  for (float time = 0.0f; time < clip.duration; time += 0.1f) {
    const Pose pose = samplePose(character->skeleton, clip, time);
    const PosedRig posedRig = preparation->poser->pose(pose);
    poseFieldAndSkin(preparation, posedRig, pose, field);
    const std::vector<PosedPrimitive>& posed = field.primitives;
    for (std::size_t i = 0; i < posed.size(); ++i) {
      const auto index = static_cast<std::size_t>(preparation->attached->attachment.rigIndex[i]);
      const auto& [carrier, placement] = posedRig.muscles[index].body;
      const UnitBallMap drawn = unitBallMap(placement, rig.primitives[index].reach, carrier);
      EXPECT_EQ(drawn.center, posed[i].influence.center) << rig.primitives[index].name;
      EXPECT_EQ(drawn.toUnit, posed[i].influence.toUnit);
      EXPECT_EQ(drawn.isPlain(), posed[i].influence.isPlain());
      bent += drawn.isPlain() ? 0 : 1;
    }
  }
  EXPECT_GT(bent, 3) << "triceps and quadriceps, where the joint bends far";
}

}  // namespace
}  // namespace sinew::test
