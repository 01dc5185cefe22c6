// tests/bodies/preset_from_muscles_test.cpp: muscles converted to a preset and back on the same body, and on others.

#include "core/bodies/muscle_set.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/files/preset_json.h"
#include "core/geometry/affine_image.h"
#include "core/geometry/at.h"
#include "core/rig/motion_clip.h"
#include "core/rig/twins.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"
#include "sinew/rig/rig_edit.h"
#include "tests/support/characters/characters.h"
#include "tests/support/characters/real_characters.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

fs::path assetFile(const std::string& name) { return fs::path(SINEW_SOURCE_DIR) / "assets" / name; }

struct BodyOfPreset {
  std::shared_ptr<const Character> character;
  MirrorPlan plan;
};

/// Empty: the real character is not available.
BodyOfPreset body(const std::string& file) {
  std::shared_ptr<const Character> found;
  if (fs::exists(assetFile(file))) found = importGltf(assetFile(file)).value();
  else found = test::realCharacter(file.c_str());
  if (!found) return {};
  found = withRangeOfMotion(found);
  return {found, makeMirrorPlan(*found)};
}

Preset shipped(const char* name) { return loadPreset(assetFile(std::string("presets/") + name + ".json")).value(); }

std::vector<int> allOf(const Rig& rig) {
  std::vector<int> indices(rig.primitives.size());
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

/// In the world of the bind pose.
Placement inWorld(const Character& character, const Primitive& primitive) {
  const glm::dmat4 bind(at(character.skeleton.bones, *character.skeleton.findBone(primitive.bone)).bindInWorld);
  return imageOf(primitive.placement, {glm::dmat3(bind), glm::dvec3(bind[3])});
}

/// Half the size of its bounding box: independent of the order of axes.
glm::vec3 extentOf(const Placement& placement) {
  const glm::mat3 axes = glm::mat3_cast(placement.rotation);
  glm::vec3 sum(0.0f);
  for (glm::length_t i = 0; i < 3; ++i) sum += placement.radii[i] * placement.radii[i] * axes[i] * axes[i];
  return glm::sqrt(sum);
}

struct Off {
  float center = 0.0f;  ///< Maximum, of H.
  float extent = 0.0f;  ///< Maximum, of H.
};
/// Distances between muscles of the same name.
Off offBetween(const Character& character, const Rig& one, const Rig& other) {
  Off off;
  for (const Primitive& own : one.primitives) {
    const auto same = std::ranges::find(other.primitives, own.name, &Primitive::name);
    if (same == other.primitives.end()) {
      ADD_FAILURE() << own.name << " is missing";
      continue;
    }
    const Placement a = inWorld(character, own);
    const Placement b = inWorld(character, *same);
    off.center = std::max(off.center, glm::distance(a.center, b.center) / character.height);
    const glm::vec3 extent = glm::abs(extentOf(a) - extentOf(b)) / character.height;
    off.extent = std::max({off.extent, extent.x, extent.y, extent.z});
  }
  return off;
}

struct Fitted {
  const char* file;
  const char* set;
};
std::ostream& operator<<(std::ostream& out, const Fitted& each) { return out << each.file; }
class PresetFromFittedSet : public ::testing::TestWithParam<Fitted> {};

/// A fitted set is reproduced: the same names, pairs, groups and lines, at the same places.
TEST_P(PresetFromFittedSet, ReproducesTheSet) {
  const BodyOfPreset own = body(GetParam().file);
  if (!own.character) SINEW_SKIP_WITHOUT_CHARACTERS();
  const FittedPreset first = fitPreset({}, shipped(GetParam().set), {}, *own.character, own.plan).value();
  const auto made = presetFromMuscles(first.rig, allOf(first.rig), *own.character, own.plan);
  ASSERT_TRUE(made.ok()) << made.error().text();
  for (const auto& [name, why] : made->leftOut) ADD_FAILURE() << name << ": " << why;
  const auto again = fitPreset({}, made->preset, {}, *own.character, own.plan);
  ASSERT_TRUE(again.ok()) << again.error().text();
  for (const auto& [name, why] : again->leftOut) ADD_FAILURE() << name << ": " << why;
  ASSERT_EQ(again->rig.primitives.size(), first.rig.primitives.size());
  EXPECT_EQ(again->rig.lines.size(), first.rig.lines.size());
  for (const Primitive& before : first.rig.primitives) {
    const auto after = std::ranges::find(again->rig.primitives, before.name, &Primitive::name);
    ASSERT_NE(after, again->rig.primitives.end()) << before.name;
    EXPECT_EQ(after->group, before.group) << before.name;
    EXPECT_EQ(after->line.empty(), before.line.empty()) << before.name;
    EXPECT_FLOAT_EQ(after->reach, before.reach) << before.name;
    EXPECT_EQ(after->mirror, before.mirror);
  }
  const Off off = offBetween(*own.character, first.rig, again->rig);
  EXPECT_LT(off.center, 0.001f);
  EXPECT_LT(off.extent, 0.005f);
}

INSTANTIATE_TEST_SUITE_P(PresetFromMuscles, PresetFromFittedSet,
                         ::testing::Values(Fitted{"humanoid.glb", "athlete"}, Fitted{"horse.glb", "animal"},
                                           Fitted{"man.glb", "athlete"}, Fitted{"woman.glb", "athlete"},
                                           Fitted{"Husky.glb", "animal"}, Fitted{"Fox.glb", "animal"}),
                         [](const auto& each) { return fs::path(each.param.file).stem().string(); });

/// Muscles laid by hand: pairs, and single ones across the middle.
TEST(PresetFromMuscles, ReproducesMusclesLaidByHand) {
  for (const char* name : {"humanoid-flex", "horse-flex"}) {
    Rig rig = loadRig(assetFile(std::string(name) + ".rig.json")).value();
    const BodyOfPreset own = body(rig.character);
    const auto made = presetFromMuscles(rig, allOf(rig), *own.character, own.plan);
    ASSERT_TRUE(made.ok()) << made.error().text();
    // One pair each: on the hand, on the head.
    ASSERT_LE(made->leftOut.size(), 1u) << name;
    for (const auto& [left, why] : made->leftOut) {
      EXPECT_NE(why.find("sets have no place for it on the "), std::string::npos) << left << ": " << why;
      const auto lost = std::ranges::find(rig.primitives, left, &Primitive::name) - rig.primitives.begin();
      rig = removePrimitives(rig, std::vector<int>{static_cast<int>(lost), twinOf(rig, static_cast<int>(lost))});
    }
    const auto again = fitPreset({}, made->preset, {}, *own.character, own.plan);
    ASSERT_TRUE(again.ok()) << again.error().text();
    EXPECT_EQ(again->rig.primitives.size(), rig.primitives.size());
    const auto single = std::ranges::count(rig.primitives, "", &Primitive::mirror);
    EXPECT_GT(single, 0);
    EXPECT_EQ(std::ranges::count(again->rig.primitives, "", &Primitive::mirror), single);
    const Off off = offBetween(*own.character, rig, again->rig);
    EXPECT_LT(off.center, 0.002f) << name;
    EXPECT_LT(off.extent, 0.005f) << name;
  }
}

/// Both sides give the same preset.
TEST(PresetFromMuscles, RightAndLeftSidesGiveTheSamePreset) {
  const BodyOfPreset own = body("humanoid.glb");
  const Rig rig = fitPreset({}, shipped("athlete"), {}, *own.character, own.plan).value().rig;
  std::vector<int> left;
  std::vector<int> right;
  for (int i = 0; i < static_cast<int>(rig.primitives.size()); ++i)
    (at(rig.primitives, i).name.ends_with(" L") ? left : right).push_back(i);
  ASSERT_EQ(left.size(), right.size());
  const auto ofLeft = presetFromMuscles(rig, left, *own.character, own.plan);
  const auto ofRight = presetFromMuscles(rig, right, *own.character, own.plan);
  ASSERT_TRUE(ofLeft.ok() && ofRight.ok());
  ASSERT_EQ(ofLeft->preset.muscles.size(), left.size());
  ASSERT_EQ(ofRight->preset.muscles.size(), left.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    const PresetMuscle& a = ofLeft->preset.muscles[i];
    const PresetMuscle& b = ofRight->preset.muscles[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_NEAR(a.belly.u, b.belly.u, 1e-3f) << a.name;
    EXPECT_NEAR(a.belly.angle, b.belly.angle, 0.1f) << a.name;
    EXPECT_NEAR(a.height, b.height, 1e-3f) << a.name;
    EXPECT_NEAR(a.turn, b.turn, 0.1f) << a.name;
  }
}

TEST(PresetFromMuscles, FitsOtherBodies) {
  const BodyOfPreset own = body("humanoid.glb");
  const BodyOfPreset other = body("man.glb");
  if (!other.character) SINEW_SKIP_WITHOUT_CHARACTERS();
  const Rig rig = loadRig(assetFile("humanoid-flex.rig.json")).value();
  const auto made = presetFromMuscles(rig, allOf(rig), *own.character, own.plan);
  ASSERT_TRUE(made.ok());
  const auto fitted = fitPreset({}, made->preset, {}, *other.character, other.plan);
  ASSERT_TRUE(fitted.ok()) << fitted.error().text();
  EXPECT_LE(fitted->leftOut.size(), made->preset.muscles.size() / 10);
}

TEST(PresetFromMuscles, UnsupportedMusclesAreOmittedWithAReason) {
  const BodyOfPreset own = body("humanoid.glb");
  Rig rig = fitPreset({}, shipped("athlete"), {}, *own.character, own.plan).value().rig;
  const std::size_t before = rig.primitives.size();
  Primitive lost = rig.primitives[0];
  lost.name = "lost";
  lost.mirror.clear();
  lost.line.clear();
  lost.bone = "nowhere";
  rig = addPrimitive(std::move(rig), lost).value();
  const auto made = presetFromMuscles(rig, allOf(rig), *own.character, own.plan);
  ASSERT_TRUE(made.ok());
  ASSERT_EQ(made->leftOut.size(), 1u);
  EXPECT_EQ(made->leftOut[0].name, "lost");
  EXPECT_NE(made->leftOut[0].why.find("nowhere"), std::string::npos);
  EXPECT_EQ(made->preset.muscles.size(), before / 2);
  const std::vector<int> none{static_cast<int>(before)};
  EXPECT_FALSE(presetFromMuscles(rig, none, *own.character, own.plan).ok());
}

/// Reading gives what was written.
TEST(PresetFromMuscles, RoundTripsThroughJson) {
  for (const char* name : {"humanoid-flex", "horse-flex", "humanoid-wrapped"}) {
    Rig rig = loadRig(assetFile(std::string(name) + ".rig.json")).value();
    rig.surface.grooves = 0.02f;
    const BodyOfPreset own = body(rig.character);
    const auto made = presetFromMuscles(rig, allOf(rig), *own.character, own.plan);
    ASSERT_TRUE(made.ok()) << made.error().text();
    EXPECT_EQ(made->preset.grooves, 0.02f);
    Preset preset = made->preset;
    preset.title = "Mine";
    const std::string text = presetToJson(preset);
    const auto read = presetFromJson(text);
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(presetToJson(read.value()), text);
    const Rig fitted = fitPreset({}, preset, {}, *own.character, own.plan).value().rig;
    EXPECT_EQ(fitPreset({}, read.value(), {}, *own.character, own.plan).value().rig, fitted) << name;
  }
}

}  // namespace
}  // namespace sinew
