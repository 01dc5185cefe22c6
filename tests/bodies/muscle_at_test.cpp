// tests/bodies/muscle_at_test.cpp: a muscle of a set laid at the pointer.
#include "core/bodies/muscle_set.h"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/bodies/fit_preset.h"
#include "core/character/bindings.h"
#include "core/files/preset_json.h"
#include "core/geometry/at.h"
#include "core/rig/motion_clip.h"
#include "sinew/files/gltf_import.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

class MuscleAt : public ::testing::Test {
 protected:
  const std::shared_ptr<const Character> character =
      withRangeOfMotion(importGltf(fs::path(SINEW_SOURCE_DIR) / "assets" / "humanoid.glb").value());
  const MirrorPlan plan = makeMirrorPlan(*character);
  const MeasuredBody body{*character, plan, {}};
  const Preset athlete = loadPreset(fs::path(SINEW_SOURCE_DIR) / "assets" / "presets" / "athlete.json").value();

  [[nodiscard]] const PresetMuscle& muscle(const char* name) const {
    return *std::ranges::find(athlete.muscles, name, &PresetMuscle::name);
  }
  /// Center of the left one, in the bind pose.
  [[nodiscard]] glm::vec3 laid(const PresetMuscle& one) const {
    Preset set = athlete;
    set.muscles = {one};
    const auto fitted = fitPreset({}, set, {}, *character, plan);
    EXPECT_TRUE(fitted.ok()) << fitted.error().text();
    if (!fitted) return glm::vec3(NAN);
    const Primitive& first = fitted->rig.primitives.front();
    const int bone = *character->skeleton.findBone(first.bone);
    return glm::vec3(at(character->skeleton.bones, bone).bindInWorld * glm::vec4(first.placement.center, 1.0f));
  }
  [[nodiscard]] glm::vec3 skinAt(const Mark& mark) const { return body.flesh.measure(mark)->at(0.0f); }
};

TEST_F(MuscleAt, PointOnTheSkinGivesItsMark) {
  for (const Slot slot : {Slot::kUpperArm, Slot::kLowerArm, Slot::kUpperLeg, Slot::kLowerLeg, Slot::kSpine}) {
    const int bone = slot == Slot::kSpine ? body.frame.slots.trunk.front() : body.frame.slots.boneOf(slot);
    for (const float angle : {10.0f, 80.0f, 150.0f}) {
      const glm::vec3 point = skinAt({slot, 0.5f, angle, 0.0f});
      const auto found = markOnSkin(body, bone, point);
      ASSERT_TRUE(found.has_value());
      EXPECT_EQ(found->mark.slot, slot);
      EXPECT_EQ(found->side, BodySide::kLeft);
      EXPECT_NEAR(found->mark.u, 0.5f, 0.02f);
      EXPECT_NEAR(found->mark.angle, angle, 2.0f);
      // The same on the other side.
      const auto twin = twinBone(plan, character->skeleton.fileName(bone));
      const auto other = markOnSkin(body, *character->skeleton.findBone(twin.value()),
                                    glm::vec3(reflected(plan.plane, glm::dvec3(point))));
      ASSERT_TRUE(other.has_value());
      EXPECT_EQ(other->side, BodySide::kRight);
      EXPECT_NEAR(other->mark.angle, angle, 2.0f);
    }
  }
}

TEST_F(MuscleAt, StaysAtItsOwnMark) {
  for (const PresetMuscle& each : athlete.muscles) {
    const PresetMuscle same = muscleAt(each, each.belly, body);
    EXPECT_EQ(same.belly.u, each.belly.u) << each.name;
    EXPECT_EQ(same.origin.has_value(), each.origin.has_value());
  }
}

TEST_F(MuscleAt, MovesItsLineWithinItsPart) {
  const PresetMuscle& biceps = muscle("biceps");
  const PresetMuscle moved = muscleAt(biceps, {Slot::kUpperArm, 0.5f, 170.0f, 0.0f}, body);
  ASSERT_TRUE(moved.origin.has_value());
  EXPECT_NEAR(std::remainder(moved.origin->angle - biceps.origin->angle - 175.0f, 360.0f), 0.0f, 1.0f);
  EXPECT_LT(glm::distance(laid(moved), skinAt({Slot::kUpperArm, 0.5f, 170.0f, 0.0f})), 0.05f * character->height);
}

TEST_F(MuscleAt, IsABellyWithoutALineOnAnotherPart) {
  for (const char* name : {"biceps", "pectoral, lower", "gastrocnemius, outer"}) {
    for (const Mark& mark : {Mark{Slot::kUpperLeg, 0.4f, 30.0f, 0.0f}, Mark{Slot::kLowerArm, 0.3f, 100.0f, 0.0f}}) {
      const PresetMuscle moved = muscleAt(muscle(name), mark, body);
      EXPECT_FALSE(moved.origin.has_value());
      EXPECT_GT(moved.halfLength, 0.0f);
      EXPECT_LT(glm::distance(laid(moved), skinAt(mark)), 0.06f * character->height) << name;
    }
  }
}

}  // namespace
}  // namespace sinew
