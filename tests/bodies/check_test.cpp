// tests/bodies/check_test.cpp: faults put into rigs are found and classified; good rigs have none.

#include "core/bodies/check.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"
#include "sinew/geometry/threads.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew::test {
namespace {

using CharacterPtr = std::shared_ptr<const Character>;

struct Scene {
  CharacterPtr character;
  Rig rig;
};

Scene bundled(const char* name) {
  const std::filesystem::path assets = std::filesystem::path(SINEW_SOURCE_DIR) / "assets";
  Rig rig = loadRig(assets / (std::string(name) + ".rig.json")).value();
  return {importGltf(assets / rig.character).value(), std::move(rig)};
}

std::vector<Finding> findingsOf(const Scene& scene) { return check(scene.rig, Motions(scene.character)); }

bool has(const std::vector<Finding>& findings, FindingKind kind, int primitive) {
  return std::ranges::any_of(findings, [&](const Finding& f) { return f.kind == kind && f.primitive == primitive; });
}

std::string listOf(const Scene& scene, const std::vector<Finding>& findings) {
  std::string out;
  for (const Finding& finding : findings) {
    out += scene.rig.primitives[static_cast<std::size_t>(finding.primitive)].name + ": " + textOf(finding) + " (" +
           finding.clip + ")\n";
  }
  return out;
}

class BundledRigs : public testing::TestWithParam<const char*> {};

TEST_P(BundledRigs, HaveNoFindings) {
  const Scene scene = bundled(GetParam());
  const std::vector<Finding> findings = findingsOf(scene);
  EXPECT_TRUE(findings.empty()) << listOf(scene, findings);
}
INSTANTIATE_TEST_SUITE_P(Check, BundledRigs, testing::Values("humanoid", "humanoid-flex", "horse-flex"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

struct RigFaults : testing::Test {
  Scene scene = bundled("humanoid-flex");
  int muscle = findPrimitive(scene.rig, "biceps L");
  MuscleLine& line = scene.rig.lines[static_cast<std::size_t>(findLine(scene.rig, "biceps L"))];
  Primitive& primitive = scene.rig.primitives[static_cast<std::size_t>(muscle)];

  [[nodiscard]] glm::mat4 bone(const char* name) const {
    return scene.character->skeleton.bones[static_cast<std::size_t>(*scene.character->skeleton.findBone(name))]
        .bindInWorld;
  }
};

TEST_F(RigFaults, PivotOnADistantBoneIsFound) {
  // The belly thickens away from the bone, so that its underside comes out.
  line.settings.pivot = 1.0f;
  line.settings.flex = {3.0f, 0.0f};
  line.settings.volume = 3.0f;
  const glm::vec3 out = glm::vec3(glm::inverse(bone("upper_arm.L")) * glm::vec4(0, 0, 1, 0));
  for (LineAnchor* anchor : {&line.origin, &line.insertion}) anchor->point += 0.12f * glm::normalize(out);
  EXPECT_TRUE(has(findingsOf(scene), FindingKind::kComesOut, muscle) ||
              has(findingsOf(scene), FindingKind::kSlidesOff, muscle))
      << listOf(scene, findingsOf(scene));
}

TEST_F(RigFaults, BallShapedBellyIsFound) {
  line.settings.tendons = {0.4f, 0.35f};
  line.settings.flex = {2.0f, 2.0f};
  EXPECT_TRUE(has(findingsOf(scene), FindingKind::kBall, muscle)) << listOf(scene, findingsOf(scene));
}

TEST_F(RigFaults, ViaPointAtTheWrongEndIsFound) {
  line.via = LineAnchor{"hand.L", glm::vec3(0.0f), {}};
  EXPECT_TRUE(has(findingsOf(scene), FindingKind::kSlidesOff, muscle) ||
              has(findingsOf(scene), FindingKind::kComesOut, muscle) ||
              has(findingsOf(scene), FindingKind::kTooShort, muscle))
      << listOf(scene, findingsOf(scene));
}

TEST_F(RigFaults, TerritoryAcrossLimbsIsFound) {
  const int chest = findPrimitive(scene.rig, "latissimus L");
  Primitive& wide = scene.rig.primitives[static_cast<std::size_t>(chest)];
  wide.territory = std::vector<std::string>{wide.bone, "forearm.L", "hand.L"};
  wide.placement.radii *= 2.5f;
  const std::vector<Finding> findings = findingsOf(scene);
  EXPECT_TRUE(has(findings, FindingKind::kReachesAcross, chest)) << listOf(scene, findings);
}

TEST_F(RigFaults, OverlongLineIsFound) {
  line.insertion = {"hand.L", glm::vec3(0.0f), {}};
  line.settings.rest = 0.4f;
  const std::vector<Finding> findings = findingsOf(scene);
  EXPECT_TRUE(has(findings, FindingKind::kTooLong, muscle)) << listOf(scene, findings);
}

/// If the whole character moves rigidly, nothing moves relative to its skin.
TEST(BellyMotion, IsZeroUnderRigidMotion) {
  const CharacterPtr character = makeLimb();
  const Rig rig = randomRig(*character, {.primitives = 8}, 3);
  const RigPoser poser(rig, *character);
  const Pose bind = bindPose(character->skeleton);
  const glm::mat4 turn = glm::rotate(glm::translate(glm::mat4(1.0f), {3.0f, -1.0f, 0.5f}), 1.1f,
                                     glm::normalize(glm::vec3(0.3f, 1.0f, -0.4f)));
  Pose moved = bind;
  for (glm::mat4& bone : moved.boneInWorld) bone = turn * bone;
  const PosedRig atRest = poser.pose(bind);
  const PosedRig posed = poser.pose(moved);
  int followed = 0;
  for (std::size_t i = 0; i < rig.primitives.size(); ++i) {
    const auto bone = character->skeleton.findBone(rig.primitives[i].bone);
    const auto belly = FollowedBelly::create(*character, SkinRuns(character->mesh), atRest.muscles[i], *bone);
    if (!belly) continue;
    ++followed;
    std::vector<std::optional<SkinFrame>> frames;
    for (const SkinSpot& spot : belly->spots()) frames.push_back(frameAt(*character, spot, moved));
    const BellyMotion motion = belly->motion(posed.muscles[i], frames);
    EXPECT_NEAR(motion.out, 0.0f, 1e-3f);
    EXPECT_NEAR(motion.beside, 0.0f, 1e-3f);
    EXPECT_LE(motion.ball, belly->mostBall());
  }
  EXPECT_GT(followed, 4);
}

/// The measure itself: a belly lifted out of its skin by a known fraction of its height.
TEST(BellyMotion, MeasuresALiftedBelly) {
  const CharacterPtr character = makeLimb();
  Rig rig = randomRig(*character, {.primitives = 1}, 3);
  Primitive& muscle = rig.primitives[0];
  muscle.bone = "middle";
  muscle.placement = Placement{};
  muscle.placement.center = {0.0f, 0.2f, 0.3f};
  muscle.placement.radii = {0.1f, 0.2f, 0.05f};
  const RigPoser poser(rig, *character);
  const Pose bind = bindPose(character->skeleton);
  PosedRig posed = poser.pose(bind);
  const auto belly = FollowedBelly::create(*character, SkinRuns(character->mesh), posed.muscles[0],
                                           *character->skeleton.findBone("middle"));
  ASSERT_TRUE(belly);
  std::vector<std::optional<SkinFrame>> frames;
  for (const SkinSpot& spot : belly->spots()) frames.push_back(frameAt(*character, spot, bind));
  const glm::vec3 out = frames[0]->normal();
  posed.muscles[0].body.carrier = glm::translate(glm::mat4(1.0f), 0.05f * out) * posed.muscles[0].body.carrier;
  // The limb's skin is nearly perpendicular to the belly: 0.05 of a height of about 0.1.
  EXPECT_NEAR(belly->motion(posed.muscles[0], frames).out, 0.5f, 0.1f);
}

TEST(RigCheck, LongClipsAreSampledSparsely) {
  auto slow = std::make_shared<Character>(*importGltf(std::string(SINEW_SOURCE_DIR) + "/assets/demo.glb").value());
  for (const float seconds : {1e6f, 1e15f}) {
    slow->clips.front().duration = seconds;
    const std::size_t poses = Motions(slow).poses().size();
    EXPECT_GT(poses, 5'000U);
    EXPECT_LT(poses, 6'100U);
  }
}

TEST(RigCheck, DoesNotDependOnThreads) {
  const Scene scene = bundled("horse");
  std::vector<std::vector<Finding>> all;
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    all.push_back(findingsOf(scene));
  }
  EXPECT_EQ(all[0], all[1]);
  EXPECT_EQ(all[0], all[2]);
}

}  // namespace
}  // namespace sinew::test
