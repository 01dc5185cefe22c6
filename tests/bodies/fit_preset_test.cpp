// tests/bodies/fit_preset_test.cpp: muscle sets on every available body.
#include "core/bodies/fit_preset.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/bodies/body_frame.h"
#include "core/bodies/body_map.h"
#include "core/files/preset_json.h"
#include "core/geometry/at.h"
#include "core/rig/attachment.h"
#include "core/rig/motion_clip.h"
#include "core/rig/twins.h"
#include "core/rig/validation.h"
#include "sinew/files/gltf_import.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/characters.h"
#include "tests/support/characters/real_characters.h"
#include "tests/support/surface/winding_number.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

Preset preset(const char* name) {
  auto loaded = loadPreset(fs::path(SINEW_SOURCE_DIR) / "assets" / "presets" / (std::string(name) + ".json"));
  EXPECT_TRUE(loaded.ok()) << loaded.error().text();
  return loaded.ok() ? loaded.value() : Preset{};
}

struct Body {
  const char* file;  ///< In assets, or a real character.
  const char* set;
  int least;  ///< Number of the set's muscles that find a place.
};

std::ostream& operator<<(std::ostream& out, const Body& body) { return out << body.file; }

class FitPreset : public ::testing::TestWithParam<Body> {
 protected:
  void SetUp() override {
    const fs::path bundled = fs::path(SINEW_SOURCE_DIR) / "assets" / GetParam().file;
    std::shared_ptr<const Character> found;
    if (fs::exists(bundled)) {
      auto imported = importGltf(bundled);
      ASSERT_TRUE(imported.ok());
      found = imported.value();
    } else {
      found = test::realCharacter(GetParam().file);
    }
    if (!found) SINEW_SKIP_WITHOUT_CHARACTERS();
    character_ = withRangeOfMotion(found);
    plan_ = makeMirrorPlan(*character_);
  }

  Rig fitted(const PresetTuning& tuning = {}) {
    Rig rig;
    rig.character = GetParam().file;
    rig.surface.skinBlend = 0.015f;
    auto fit = fitPreset(rig, preset(GetParam().set), tuning, *character_, plan_);
    EXPECT_TRUE(fit.ok()) << fit.error().text();
    if (!fit) return rig;
    EXPECT_GE(static_cast<int>(fit->muscles.size()), GetParam().least);
    return fit->rig;
  }

  [[nodiscard]] glm::vec3 centerOf(const Primitive& primitive) const {
    const auto bone = character_->skeleton.findBone(primitive.bone);
    return glm::vec3(at(character_->skeleton.bones, *bone).bindInWorld * glm::vec4(primitive.placement.center, 1.0f));
  }

  std::shared_ptr<const Character> character_;
  MirrorPlan plan_;
};

TEST_P(FitPreset, EveryBellyLiesInsideTheBody) {
  const Rig rig = fitted();
  ASSERT_TRUE(validate(rig).ok());
  EXPECT_TRUE(missingBones(rig, character_->skeleton).empty());
  for (const Primitive& primitive : rig.primitives) {
    EXPECT_GT(test::windingNumber(character_->mesh, glm::dvec3(centerOf(primitive))), 0.5) << primitive.name;
  }
}

TEST_P(FitPreset, TwinsAreExactMirrorImagesInTheirOwnGroups) {
  const Rig rig = fitted();
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const Primitive& own = rig.primitives[i];
    const int twin = twinOf(rig, static_cast<int>(i));
    ASSERT_GE(twin, 0) << own.name;
    const Primitive& other = at(rig.primitives, twin);
    EXPECT_NE(own.group, other.group);
    const auto image = mirroredPrimitive(plan_, own);
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->bone, other.bone);
    const float h = character_->height;
    EXPECT_LT(glm::distance(image->placement.center, other.placement.center), 1e-5f * h) << own.name;
    EXPECT_LT(glm::distance(image->placement.radii, other.placement.radii), 1e-5f * h) << own.name;
    if (own.line.empty()) continue;
    EXPECT_EQ(rig.lines[static_cast<std::size_t>(findLine(rig, own.line))].mirror, other.line);
  }
  EXPECT_TRUE(rig.links.empty());
}

/// A muscle moves only the skin of its own part and its neighbors.
TEST_P(FitPreset, MusclesStayOnTheirLimb) {
  const Rig rig = fitted();
  const BodyFrame frame = makeBodyFrame(*character_, bodySlots(*character_, plan_));
  for (const Primitive& primitive : rig.primitives) {
    const int bone = *character_->skeleton.findBone(primitive.bone);
    const bool left = primitive.name.ends_with(" L");
    const glm::vec3 center = centerOf(primitive);
    const glm::vec3 image(reflected(plan_.plane, glm::dvec3(center)));
    EXPECT_EQ(glm::dot(center - image, frame.slots.left) > 0.0f, left) << primitive.name << " is on the other side";
    ASSERT_TRUE(primitive.territory.has_value());
    for (const std::string& name : *primitive.territory) {
      const int other = *character_->skeleton.findBone(name);
      const Zone zone = at(frame.zoneOfBone, other);
      ASSERT_GE(zone, 0) << name;
      const BodySlot part = allBodySlots()[static_cast<std::size_t>(zone)];
      EXPECT_TRUE(!part.isSided() || (part.side == BodySide::kLeft) == left) << primitive.name << " on " << name;
      const auto isArm = [](Slot slot) { return slot >= Slot::kUpperArm && slot <= Slot::kHand; };
      const auto isLeg = [](Slot slot) { return slot >= Slot::kUpperLeg && slot <= Slot::kToes; };
      const Slot own = allBodySlots()[static_cast<std::size_t>(std::max(0, at(frame.zoneOfBone, bone)))].slot;
      EXPECT_FALSE(isArm(own) && isLeg(part.slot)) << primitive.name << " on " << name;
      EXPECT_FALSE(isLeg(own) && isArm(part.slot)) << primitive.name << " on " << name;
    }
  }
}

struct Rise {
  double most = 0.0;
  double share99 = 0.0;  ///< 99th percentile of all vertices that rise.
  int unresolved = 0;
};

Rise riseOf(const std::shared_ptr<const Character>& character, Rig rig) {
  rig.smoothing.depth = 2;
  Rig bare = rig;
  bare.primitives.clear();
  bare.lines.clear();
  Smoother with(character);
  Smoother without(character);
  EXPECT_TRUE(with.prepare(rig).ok());
  EXPECT_TRUE(without.prepare(bare).ok());
  Surface raised;
  Surface flat;
  with.smooth(bindPose(character->skeleton), raised);
  without.smooth(bindPose(character->skeleton), flat);
  EXPECT_EQ(raised.positions.size(), flat.positions.size());
  std::vector<double> rises;
  for (std::size_t i = 0; i < raised.positions.size(); ++i) {
    const auto rise = static_cast<double>(glm::distance(raised.positions[i], flat.positions[i]) / character->height);
    if (rise > 1e-4) rises.push_back(rise);
  }
  std::ranges::sort(rises);
  if (rises.empty()) return {};
  return {rises.back(), rises[static_cast<std::size_t>(0.99 * static_cast<double>(rises.size() - 1))],
          raised.report.unresolved};
}

TEST_P(FitPreset, MusclesAreVisibleAndModerate) {
  const Rise rise = riseOf(character_, fitted());
  EXPECT_EQ(rise.unresolved, 0);
  EXPECT_GT(rise.share99, 0.005);
  EXPECT_LT(rise.share99, 0.04);
  EXPECT_LT(rise.most, 0.06);  // Where lower layers push upper ones.
  PresetTuning heavy;
  heavy.mass = 1.6f;
  heavy.definition = 0.55f;
  EXPECT_GT(riseOf(character_, fitted(heavy)).share99, rise.share99);
}

TEST_P(FitPreset, IsRepeatable) { EXPECT_EQ(fitted(), fitted()); }

TEST_P(FitPreset, DefinitionOmitsNoMuscle) {
  const auto count = [&](float definition) { return fitted({1.0f, definition}).primitives.size(); };
  const std::size_t usual = fitted().primitives.size();
  // A body of parts has gaps between them, at some depths only.
  const std::size_t all = 2 * preset(GetParam().set).muscles.size();
  const std::size_t least = usual == all ? all : usual - 2;
  for (const float definition : {0.0f, 0.7f, 1.0f}) EXPECT_GE(count(definition), least) << definition;
}

INSTANTIATE_TEST_SUITE_P(Bodies, FitPreset,
                         ::testing::Values(Body{"humanoid.glb", "athlete", 36}, Body{"demo.glb", "athlete", 36},
                                           Body{"horse.glb", "animal", 16}, Body{"man.glb", "athlete", 37},
                                           Body{"woman.glb", "athlete", 37}, Body{"fighter.glb", "athlete", 12},
                                           Body{"cesium_man.gltf", "athlete", 34}, Body{"Husky.glb", "animal", 17},
                                           Body{"Bull.glb", "animal", 14}, Body{"Fox.glb", "animal", 16}),
                         [](const auto& body) {
                           std::string name = body.param.file;
                           std::erase_if(name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; });
                           return name;
                         });

TEST(FitPresetRefusal, RefusesABodyOfAnotherKind) {
  const auto imported = importGltf(fs::path(SINEW_SOURCE_DIR) / "assets" / "horse.glb");
  ASSERT_TRUE(imported.ok());
  const auto fit = fitPreset({}, preset("athlete"), {}, *imported.value(), makeMirrorPlan(*imported.value()));
  ASSERT_FALSE(fit.ok());
  EXPECT_NE(fit.error().reason.find("quadruped"), std::string::npos) << fit.error().reason;
}

/// Lines of a set know their shortest length: full contraction is learned.
TEST(FitPresetLines, LearnTheirLengths) {
  const auto imported = importGltf(fs::path(SINEW_SOURCE_DIR) / "assets" / "humanoid.glb");
  ASSERT_TRUE(imported.ok());
  const auto character = withRangeOfMotion(imported.value());
  const auto fit = fitPreset({}, preset("athlete"), {}, *character, makeMirrorPlan(*character));
  ASSERT_TRUE(fit.ok());
  const int biceps = findLine(fit->rig, "biceps L");
  ASSERT_GE(biceps, 0);
  EXPECT_NE(at(fit->rig.lines, biceps).settings.full, 0.8f);
  EXPECT_EQ(at(fit->rig.lines, biceps).settings.full, at(fit->rig.lines, findLine(fit->rig, "biceps R")).settings.full);
}

}  // namespace
}  // namespace sinew
