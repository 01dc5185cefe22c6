// tests/bodies/mend_rig_test.cpp: muscles that no line mends: their bone, depth and territory.
#include "core/bodies/mend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/rig/line_edit.h"
#include "core/rig/twins.h"
#include "core/rig/validation.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"

namespace sinew {
namespace {

struct MendRig : testing::Test {
  const std::filesystem::path assets = std::filesystem::path(SINEW_SOURCE_DIR) / "assets";
  const std::shared_ptr<const Character> character = importGltf(assets / "humanoid.glb").value();
  const MirrorPlan plan = makeMirrorPlan(*character);
  const Motions motions{character};
  const Rig good = loadRig(assets / "humanoid.rig.json").value();

  /// Puts a muscle and its twin on another bone, in place.
  [[nodiscard]] Rig riding(const char* muscle, const char* bone) const {
    const int index = findPrimitive(good, muscle);
    Rig rig = good;
    Primitive& own = at(rig.primitives, index);
    const Skeleton& skeleton = character->skeleton;
    own.placement = carryToBone(own.placement, at(skeleton.bones, *skeleton.findBone(own.bone)).bindInWorld,
                                at(skeleton.bones, *skeleton.findBone(bone)).bindInWorld);
    own.bone = bone;
    return keepTwins(good, good, std::move(rig), plan);
  }
  /// In the world of the bind pose.
  [[nodiscard]] glm::vec3 placeOf(const Primitive& muscle, const glm::vec3& inUnit) const {
    const auto& bone = at(character->skeleton.bones, *character->skeleton.findBone(muscle.bone));
    const glm::vec3 point =
        muscle.placement.center + glm::mat3_cast(muscle.placement.rotation) * (muscle.placement.radii * inUnit);
    return glm::vec3(bone.bindInWorld * glm::vec4(point, 1.0f));
  }
};

TEST_F(MendRig, SoundRigIsUnchanged) {
  ASSERT_TRUE(check(good, motions).empty());
  const auto mended = withMendedRig(good, 0, motions, &plan);
  ASSERT_TRUE(mended.ok());
  EXPECT_EQ(mended->rig, good);
  EXPECT_TRUE(mended->said.empty());
}

TEST_F(MendRig, MuscleOnTheWrongBoneMovesToTheRightOne) {
  for (const auto& [muscle, right, wrong] :
       {std::tuple{"biceps L", "upper_arm.L", "forearm.L"}, std::tuple{"quadriceps L", "thigh.L", "shin.L"}}) {
    const Rig bad = riding(muscle, wrong);
    ASSERT_FALSE(check(bad, motions).empty()) << muscle;
    const auto mended = withMendedRig(bad, 0, motions, &plan);
    ASSERT_TRUE(mended.ok());
    EXPECT_TRUE(check(mended->rig, motions).empty()) << muscle;
    EXPECT_TRUE(validate(mended->rig).ok());
    const int index = findPrimitive(good, muscle);
    EXPECT_EQ(at(mended->rig.primitives, index).bone, right);
    // It stays in place.
    EXPECT_LT(glm::distance(placeOf(at(mended->rig.primitives, index), glm::vec3(0.0f)),
                            placeOf(at(bad.primitives, index), glm::vec3(0.0f))),
              1e-3f * character->height);
    const int twin = twinOf(mended->rig, index);
    EXPECT_EQ(at(mended->rig.primitives, twin).bone, twinBone(plan, right).value());
    ASSERT_EQ(mended->said.size(), 1u) << "twins are named once";
  }
}

TEST_F(MendRig, WorksWithoutAMirrorPlan) {
  const Rig bad = riding("biceps L", "forearm.L");
  const auto mended = withMendedRig(bad, 0, motions, nullptr);
  ASSERT_TRUE(mended.ok());
  EXPECT_TRUE(validate(mended->rig).ok());
  EXPECT_LT(check(mended->rig, motions).size(), check(bad, motions).size());
}

TEST_F(MendRig, DeepenedMuscleKeepsItsTop) {
  // Slightly too thin for how far its skin moves: a bundled muscle thinned until it is found.
  const int index = findPrimitive(good, "latissimus L");
  Rig thin = good;
  while (check(thin, motions).empty()) {
    const Rig before = thin;
    Primitive& own = at(thin.primitives, index);
    ASSERT_GT(own.placement.radii.z, 1e-4f * character->height) << "nothing is ever found";
    own.placement.center += 0.2f * own.placement.radii.z * (glm::mat3_cast(own.placement.rotation)[2]);
    own.placement.radii.z *= 0.8f;
    thin = keepTwins(before, before, std::move(thin), plan);
  }
  const auto mended = withMendedRig(thin, 0, motions, &plan);
  ASSERT_TRUE(mended.ok());
  EXPECT_TRUE(check(mended->rig, motions).empty());
  const Primitive& before = at(thin.primitives, index);
  const Primitive& after = at(mended->rig.primitives, index);
  ASSERT_EQ(after.bone, before.bone) << "another way of mending: this muscle says nothing of deeper ones";
  ASSERT_TRUE(after.line.empty());
  EXPECT_NEAR(after.placement.radii.x, before.placement.radii.x, 1e-6f);
  EXPECT_NEAR(after.placement.radii.y, before.placement.radii.y, 1e-6f);
  EXPECT_GT(after.placement.radii.z, 1.1f * before.placement.radii.z);
  const float top = glm::distance(placeOf(after, {0, 0, 1}), placeOf(before, {0, 0, 1}));
  const float bottom = glm::distance(placeOf(after, {0, 0, -1}), placeOf(before, {0, 0, -1}));
  EXPECT_LT(std::min(top, bottom), 1e-5f * character->height);
  EXPECT_GT(std::max(top, bottom), 0.1f * before.placement.radii.z);
}

TEST_F(MendRig, SkinOfAnotherLimbIsRemovedFromTheTerritory) {
  const int index = findPrimitive(good, "latissimus L");
  Rig wide = good;
  Primitive& own = at(wide.primitives, index);
  own.territory = std::vector<std::string>{own.bone, "forearm.L", "hand.L"};
  own.placement.radii *= 2.5f;
  wide = keepTwins(good, good, std::move(wide), plan);
  const auto across = [&](const Rig& rig) {
    const auto findings = check(rig, motions);
    return std::ranges::count(findings, FindingKind::kReachesAcross, &Finding::kind);
  };
  ASSERT_GT(across(wide), 0);
  // One bone of a muscle is reported at a time.
  Rig rig = wide;
  for (int round = 0; round < 3; ++round) rig = withMendedRig(rig, 0, motions, &plan).value().rig;
  EXPECT_EQ(across(rig), 0);
  EXPECT_FALSE(at(rig.primitives, index).territory->empty());
}

TEST_F(MendRig, ExistingMusclesAreUnchanged) {
  const Rig bad = riding("biceps L", "forearm.L");
  const auto mended = withMendedRig(bad, bad.primitives.size(), motions, &plan);
  ASSERT_TRUE(mended.ok());
  EXPECT_EQ(mended->rig, bad);
}

}  // namespace
}  // namespace sinew
