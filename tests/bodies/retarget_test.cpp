// tests/bodies/retarget_test.cpp: muscles of one body on another, and back.

#include "core/bodies/retarget.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/bodies/body_frame.h"
#include "core/bodies/body_map.h"
#include "core/bodies/fit_preset.h"
#include "core/files/preset_json.h"
#include "core/geometry/at.h"
#include "core/rig/animated_edit.h"
#include "core/rig/attachment.h"
#include "core/rig/motion_clip.h"
#include "core/rig/rig_edit.h"
#include "core/rig/twins.h"
#include "core/rig/validation.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/characters/characters.h"
#include "tests/support/characters/real_characters.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

struct RetargetedBody {
  std::shared_ptr<const Character> character;
  MirrorPlan plan;
};

fs::path asset(const std::string& name) { return fs::path(SINEW_SOURCE_DIR) / "assets" / name; }

RetargetedBody bodyOf(std::shared_ptr<const Character> character) {
  MirrorPlan plan = makeMirrorPlan(*character);
  return {withRangeOfMotion(character, plan), plan};
}

RetargetedBody bundled(const std::string& name) {
  auto imported = importGltf(asset(name));
  EXPECT_TRUE(imported.ok());
  return bodyOf(imported.value());
}

Rig rigOf(const std::string& name) {
  auto loaded = loadRig(asset(name));
  EXPECT_TRUE(loaded.ok()) << loaded.error().text();
  return loaded.value();
}

Retargeted onto(const Rig& rig, const RetargetedBody& from, const RetargetedBody& to) {
  auto done = retarget(rig, *from.character, from.plan, Motions(to.character), to.plan);
  EXPECT_TRUE(done.ok()) << done.error().text();
  return done.ok() ? done.value() : Retargeted{};
}

/// The same body with another size, place and bone names.
std::shared_ptr<const Character> enlarged(const Character& character, float factor) {
  Character copy = character;
  for (glm::vec3& position : copy.mesh.positions) position *= factor;
  for (Node& node : copy.skeleton.nodes) {
    node.rest.translation *= factor;
    if (node.rest.matrix) (*node.rest.matrix)[3] = glm::vec4(factor * glm::vec3((*node.rest.matrix)[3]), 1.0f);
  }
  copy.clips.clear();
  for (Bone& bone : copy.skeleton.bones) {
    bone.bindInWorld[3] = glm::vec4(factor * glm::vec3(bone.bindInWorld[3]), 1.0f);
    bone.inverseBindInWorld = glm::inverse(bone.bindInWorld);
    bone.tip *= factor;
  }
  for (Binding& binding : copy.skeleton.bindings)
    binding.inverseBind = glm::mat4(glm::mat3(binding.inverseBind)) +
                          glm::mat4(glm::vec4(0), glm::vec4(0), glm::vec4(0),
                                    glm::vec4(factor * glm::vec3(binding.inverseBind[3]), 0.0f));
  copy.height *= factor;
  return std::make_shared<const Character>(std::move(copy));
}

glm::vec3 centerInBind(const Primitive& primitive, const Skeleton& skeleton) {
  const Bone& bone = at(skeleton.bones, skeleton.findBone(primitive.bone).value());
  return glm::vec3(bone.bindInWorld * glm::vec4(primitive.placement.center, 1.0f));
}

class Retarget : public ::testing::TestWithParam<const char*> {};

/// Bundled rigs: with muscle lines, wrapping, with keys.
TEST_P(Retarget, SameBodyChangesNothing) {
  const Rig rig = rigOf(GetParam());
  const RetargetedBody body = bundled(fs::path(rig.character).filename().string());
  const Retargeted done = onto(rig, body, body);
  EXPECT_TRUE(done.leftOut.empty());
  EXPECT_TRUE(done.mended.empty());
  ASSERT_EQ(done.rig.primitives.size(), rig.primitives.size());
  const float near = 1e-5f * body.character->height;
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const Primitive& was = rig.primitives[i];
    Primitive is = done.rig.primitives[i];
    EXPECT_EQ(is.bone, was.bone) << was.name;
    EXPECT_LT(glm::distance(is.placement.center, was.placement.center), near) << was.name;
    EXPECT_LT(glm::distance(is.placement.radii, was.placement.radii), near) << was.name;
    const float turned = glm::dot(glm::normalize(is.placement.rotation), glm::normalize(was.placement.rotation));
    EXPECT_GT(std::abs(turned), 1.0f - 1e-5f) << was.name;
    EXPECT_EQ(is.territory, was.territory) << was.name;
    is.placement = was.placement;
    is.animated = was.animated;
    EXPECT_EQ(is, was) << was.name;
  }
  ASSERT_EQ(done.rig.lines.size(), rig.lines.size());
  for (std::size_t i = 0; i < rig.lines.size(); ++i) {
    EXPECT_LT(glm::distance(done.rig.lines[i].origin.point, rig.lines[i].origin.point), near) << rig.lines[i].name;
    EXPECT_LT(glm::distance(done.rig.lines[i].insertion.point, rig.lines[i].insertion.point), near);
    EXPECT_EQ(done.rig.lines[i].settings, rig.lines[i].settings);
  }
  EXPECT_EQ(done.rig.groups, rig.groups);
  EXPECT_EQ(done.rig.links, rig.links);
}

/// On a body three times as large, everything is three times as large.
TEST_P(Retarget, LargerBodyScalesEverything) {
  const Rig rig = rigOf(GetParam());
  const RetargetedBody body = bundled(fs::path(rig.character).filename().string());
  const RetargetedBody large = bodyOf(enlarged(*body.character, 3.0f));
  const Retargeted done = onto(rig, body, large);
  EXPECT_TRUE(done.leftOut.empty());
  ASSERT_EQ(done.rig.primitives.size(), rig.primitives.size());
  const float near = 1e-4f * large.character->height;
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const Primitive& was = rig.primitives[i];
    const Primitive& is = done.rig.primitives[i];
    EXPECT_EQ(is.bone, was.bone);
    EXPECT_LT(glm::distance(is.placement.center, 3.0f * was.placement.center), near) << was.name;
    EXPECT_LT(glm::distance(is.placement.radii, 3.0f * was.placement.radii), near) << was.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Bundled, Retarget,
                         ::testing::Values("humanoid.rig.json", "humanoid-flex.rig.json", "humanoid-wrapped.rig.json",
                                           "horse.rig.json", "horse-flex.rig.json"));

/// Checks the bones that a limb's muscles may ride.
void expectSameParts(const Rig& before, const RetargetedBody& from, const Rig& after, const RetargetedBody& to) {
  const BodyFrame ours = makeBodyFrame(*from.character, bodySlots(*from.character, from.plan));
  const BodyFrame theirs = makeBodyFrame(*to.character, bodySlots(*to.character, to.plan));
  const auto zone = [](const BodyFrame& frame, const Skeleton& skeleton, const std::string& bone) {
    return at(frame.zoneOfBone, skeleton.findBone(bone).value());
  };
  for (const Primitive& primitive : after.primitives) {
    const Primitive& was = at(before.primitives, findPrimitive(before, primitive.name));
    EXPECT_EQ(zone(theirs, to.character->skeleton, primitive.bone), zone(ours, from.character->skeleton, was.bone))
        << primitive.name;
  }
}

void expectTwinsExact(const Rig& rig, const RetargetedBody& body) {
  for (int i = 0; i < static_cast<int>(rig.primitives.size()); ++i) {
    const int twin = twinOf(rig, i);
    if (twin < 0) continue;
    const auto image = mirroredPrimitive(body.plan, at(rig.primitives, i));
    ASSERT_TRUE(image.ok());
    EXPECT_LT(glm::distance(image->placement.center, at(rig.primitives, twin).placement.center),
              1e-4f * body.character->height)
        << at(rig.primitives, i).name;
  }
}

class RetargetPeople : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const auto found = test::realCharacter(GetParam());
    if (!found) SINEW_SKIP_WITHOUT_CHARACTERS();
    body_ = bodyOf(found);
  }
  RetargetedBody body_;
};

TEST_P(RetargetPeople, KeepsPartsAndTwinsAndRoundTrips) {
  const Rig rig = rigOf("humanoid-flex.rig.json");
  const RetargetedBody man = bundled("humanoid.glb");
  const Retargeted there = onto(rig, man, body_);
  EXPECT_TRUE(validate(there.rig).ok());
  EXPECT_TRUE(missingBones(there.rig, body_.character->skeleton).empty());
  EXPECT_GE(there.rig.primitives.size(), rig.primitives.size() * 8 / 10);
  expectSameParts(rig, man, there.rig, body_);
  expectTwinsExact(there.rig, body_);
  const Retargeted back = onto(there.rig, body_, man);
  for (const Primitive& primitive : back.rig.primitives) {
    const Primitive& was = at(rig.primitives, findPrimitive(rig, primitive.name));
    EXPECT_LT(
        glm::distance(centerInBind(primitive, man.character->skeleton), centerInBind(was, man.character->skeleton)),
        0.01f * man.character->height)
        << primitive.name;
    EXPECT_LT(glm::distance(primitive.placement.radii, was.placement.radii), 0.01f * man.character->height)
        << primitive.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Real, RetargetPeople, ::testing::Values("man.glb", "woman.glb", "cesium_man.gltf"));

TEST(RetargetKinds, PersonOntoHorseKeepsPartsAndReportsOmissions) {
  const RetargetedBody man = bundled("humanoid.glb");
  const RetargetedBody horse = bundled("horse.glb");
  const Rig rig = rigOf("humanoid-flex.rig.json");
  const Retargeted done = onto(rig, man, horse);
  EXPECT_FALSE(done.leftOut.empty());
  expectSameParts(rig, man, done.rig, horse);
  for (const auto& [name, why] : done.leftOut) EXPECT_NE(why.find("no "), std::string::npos) << name << ": " << why;
  EXPECT_EQ(done.rig.primitives.size() + done.leftOut.size(), rig.primitives.size());
}

TEST(RetargetKinds, RandomMusclesRoundTrip) {
  const RetargetedBody man = bundled("humanoid.glb");
  const RetargetedBody large = bodyOf(enlarged(*man.character, 0.4f));
  std::mt19937 random(5);
  std::uniform_real_distribution<float> any(-1.0f, 1.0f);
  Rig rig;
  rig.character = "humanoid.glb";
  for (int i = 0; i < 60; ++i) {
    const auto bone = static_cast<int>(random() % man.character->skeleton.bones.size());
    Primitive primitive;
    primitive.name = "muscle " + std::to_string(i);
    primitive.bone = man.character->skeleton.fileName(bone);
    const float size = 0.05f * man.character->height;
    primitive.placement.center = at(man.character->skeleton.bones, bone).tip * any(random) +
                                 size * glm::vec3(any(random), any(random), any(random));
    primitive.placement.rotation =
        glm::normalize(glm::quat(any(random), any(random), any(random), any(random)) + glm::quat(0.01f, 0, 0, 0));
    primitive.placement.radii = size * glm::vec3(1.2f + any(random), 1.2f + any(random), 1.2f + any(random));
    auto added = addPrimitive(std::move(rig), std::move(primitive));
    ASSERT_TRUE(added.ok());
    rig = std::move(added).value();
  }
  const Retargeted there = onto(rig, man, large);
  const Retargeted back = onto(there.rig, large, man);
  ASSERT_EQ(back.rig.primitives.size(), rig.primitives.size());
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const Primitive& was = rig.primitives[i];
    const Primitive& is = back.rig.primitives[i];
    EXPECT_EQ(is.bone, was.bone);
    EXPECT_LT(glm::distance(is.placement.center, was.placement.center), 1e-3f * man.character->height) << was.name;
    EXPECT_LT(glm::distance(is.placement.radii, was.placement.radii), 1e-3f * man.character->height) << was.name;
  }
}

TEST(RetargetKinds, BodyWithoutMatchingPartsIsRefused) {
  const RetargetedBody man = bundled("humanoid.glb");
  const RetargetedBody tangle = bundled("tangle.glb");
  const auto done =
      retarget(rigOf("humanoid.rig.json"), *man.character, man.plan, Motions(tangle.character), tangle.plan);
  ASSERT_FALSE(done.ok());
  EXPECT_NE(done.error().reason.find("no muscle"), std::string::npos);
}

TEST(RetargetedShapes, ShapeAndSurfaceDriversUseTheNewBones) {
  const RetargetedBody from = bundled("humanoid.glb");
  auto renamed = std::make_shared<Character>(*from.character);
  for (Bone& bone : renamed->skeleton.bones) bone.name = "mixamorig:" + bone.name;
  finishBones(renamed->skeleton);
  const RetargetedBody to = bodyOf(renamed);
  DriverInput input;
  input.bone = "forearm.L";
  const Driver driver{input, {{{0.0f, 0.0f}, {90.0f, 1.0f}}, CurveKind::kLinear}, DriverMode::kAdd, {}};
  Rig rig = setMorphWeight(rigOf("humanoid-flex.rig.json"), "smile", 0.5f).value();
  rig = setDriver(std::move(rig), {Parameter::kMorphWeight, 0}, driver, -1).value();
  rig = setDriver(std::move(rig), {Parameter::kSkinBlend, 0}, driver, -1).value();
  const Retargeted done = onto(rig, from, to);
  EXPECT_TRUE(missingBones(done.rig, to.character->skeleton).empty());
  ASSERT_EQ(done.rig.morphs.size(), 1U);
  for (const auto& animated : {done.rig.morphs[0].animated, done.rig.surface.animated}) {
    ASSERT_EQ(animated.size(), 1U);
    EXPECT_TRUE(to.character->skeleton.findBone(animated[0].drivers.at(0).input.bone));
    EXPECT_FALSE(from.character->skeleton.findBone(animated[0].drivers[0].input.bone));
  }
}

TEST(RetargetedDrivers, LengthsAreScaledAndFactorsAreNot) {
  const RetargetedBody from = bundled("humanoid.glb");
  const RetargetedBody to = bodyOf(enlarged(*from.character, 0.4f));
  Rig rig = rigOf("humanoid-flex.rig.json");
  rig.clipFiles = {"walk.glb"};
  const NumberRef radius{Parameter::kRadiusX, 0};
  Driver driver;
  driver.input.bone = "forearm.L";
  driver.curve = {{{0.0f, 1.0f}, {90.0f, 1.5f}}, CurveKind::kLinear};
  for (const DriverMode mode : {DriverMode::kMultiply, DriverMode::kAdd}) {
    driver.mode = mode;
    const Retargeted done = onto(setDriver(rig, radius, driver).value(), from, to);
    EXPECT_TRUE(done.rig.clipFiles.empty()) << "their paths began at the other rig";
    const AnimatedNumber* animated = animationOf(done.rig, radius);
    ASSERT_NE(animated, nullptr);
    const std::vector<glm::vec2>& points = animated->drivers.at(0).curve.points;
    const float factor = mode == DriverMode::kMultiply ? 1.0f : 0.4f;
    EXPECT_NEAR(points[0].y, factor, 0.01f);
    EXPECT_NEAR(points[1].y, 1.5f * factor, 0.01f);
  }
}

}  // namespace
}  // namespace sinew
