// tests/bodies/muscle_set_test.cpp: muscles added by a set stay in the flesh in every clip, or are left out with a
// reason.
#include "core/bodies/muscle_set.h"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "core/bodies/mend.h"
#include "core/character/bone_names.h"
#include "core/files/preset_json.h"
#include "core/rig/twins.h"
#include "core/rig/validation.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"
#include "tests/support/characters/characters.h"
#include "tests/support/characters/real_characters.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

const fs::path kAssets = fs::path(SINEW_SOURCE_DIR) / "assets";

struct Body {
  const char* file;  ///< In assets, or a real character.
  const char* set;
  std::size_t mostLeftOut;  ///< Muscles per side; on low bodies made of parts most have no flesh.
};
std::ostream& operator<<(std::ostream& out, const Body& body) { return out << body.file; }

class MuscleSetOnBody : public ::testing::TestWithParam<Body> {};

TEST_P(MuscleSetOnBody, PassesTheCheck) {
  std::shared_ptr<const Character> found;
  if (fs::exists(kAssets / GetParam().file)) found = importGltf(kAssets / GetParam().file).value();
  else found = test::realCharacter(GetParam().file);
  if (!found) SINEW_SKIP_WITHOUT_CHARACTERS();
  const Motions motions(found);
  const MirrorPlan plan = makeMirrorPlan(*found);
  const Preset set = loadPreset(kAssets / "presets" / (std::string(GetParam().set) + ".json")).value();
  const auto added = addMuscleSet({}, set, {}, motions, plan);
  ASSERT_TRUE(added.ok()) << added.error().text();
  const Rig& rig = added->fitted.rig;
  EXPECT_TRUE(validate(rig).ok());
  EXPECT_EQ(rig.surface.skinBlend, set.skinBlend);
  EXPECT_EQ(rig.surface.grooves, set.grooves);
  for (const Finding& finding : check(rig, motions)) {
    ADD_FAILURE() << rig.primitives[static_cast<std::size_t>(finding.primitive)].name << ": " << textOf(finding);
  }
  EXPECT_LE(added->fitted.leftOut.size(), GetParam().mostLeftOut);
  EXPECT_EQ(added->fitted.muscles.size() + added->fitted.leftOut.size(), set.muscles.size());
  for (const Primitive& muscle : rig.primitives) {
    const std::string name = withoutSide(muscle.name);
    EXPECT_NE(std::ranges::find(added->fitted.muscles, name), added->fitted.muscles.end()) << name;
    EXPECT_FALSE(muscle.mirror.empty()) << name;
  }
  for (const auto& [name, why] : added->fitted.leftOut) EXPECT_FALSE(why.empty()) << name;
  for (const Group& group : rig.groups) {
    EXPECT_TRUE(std::ranges::any_of(rig.primitives, [&](const auto& each) { return each.group == group.name; }))
        << group.name << " is empty";
  }
}

INSTANTIATE_TEST_SUITE_P(Bodies, MuscleSetOnBody,
                         ::testing::Values(Body{"humanoid.glb", "athlete", 0}, Body{"demo.glb", "athlete", 0},
                                           Body{"horse.glb", "animal", 3}, Body{"man.glb", "athlete", 0},
                                           Body{"woman.glb", "athlete", 1}, Body{"fighter.glb", "athlete", 16},
                                           Body{"cesium_man.gltf", "athlete", 5}, Body{"Husky.glb", "animal", 0},
                                           Body{"Bull.glb", "animal", 3}, Body{"Fox.glb", "animal", 1},
                                           Body{"RobotExpressive.glb", "athlete", 18},
                                           Body{"greenman.glb", "athlete", 37}),
                         [](const auto& body) { return fs::path(body.param.file).stem().string(); });

TEST(MuscleSet, KeepsExistingMuscles) {
  const Rig own = loadRig(kAssets / "horse.rig.json").value();
  const auto character = importGltf(kAssets / own.character).value();
  const Motions motions(character);
  const auto findings = check(own, motions);
  ASSERT_FALSE(findings.empty());
  const Preset set = loadPreset(kAssets / "presets" / "animal.json").value();
  const auto added = addMuscleSet(own, set, {}, motions, makeMirrorPlan(*character));
  ASSERT_TRUE(added.ok());
  for (std::size_t i = 0; i < own.primitives.size(); ++i) EXPECT_EQ(added->fitted.rig.primitives[i], own.primitives[i]);
  EXPECT_EQ(added->fitted.rig.surface, own.surface);
  EXPECT_EQ(findingsFrom(added->fitted.rig, own.primitives.size(), motions).size(), 0u);
  for (std::size_t i = 0; i < own.groups.size(); ++i) EXPECT_EQ(added->fitted.rig.groups[i].name, own.groups[i].name);
}

}  // namespace
}  // namespace sinew
