// tests/smoothing/property_test.cpp: hundreds of random rigs and poses: finite, unit, whole, and moving without jumps.

#include <limits>

#include <gtest/gtest.h>

#include "sinew/smoothing/smoother.h"
#include "tests/support/mesh_checks.h"
#include "tests/support/random_rigs.h"
#include "tests/support/synthetic_characters.h"

namespace sinew::test {
namespace {

using CharacterPtr = std::shared_ptr<const Character>;

Rig anyRig(const Character& character, std::uint64_t seed) {
  Random random(seed * 7919 + 1);
  RigRecipe recipe;
  recipe.primitives = random.below(25);
  recipe.groups = 1 + random.below(8);
  recipe.linkChance = random.uniform(0.0f, 1.0f);
  recipe.carveChance = random.uniform(0.0f, 0.6f);
  recipe.radiusLow = random.chance(0.2f) ? 0.001f : 0.03f;
  recipe.radiusHigh = random.chance(0.2f) ? 0.6f : 0.15f;
  Rig rig = randomRig(character, recipe, seed);
  rig.surface.mode = random.chance(0.5f) ? SurfaceMode::kSwell : SurfaceMode::kReplace;
  rig.surface.iso = random.uniform(0.02f, 0.95f);
  rig.surface.skinBlend = random.uniform(0.001f, 0.3f);
  rig.smoothing.depth = 1 + random.below(5);
  constexpr std::array kPatches{PatchKind::kPn, PatchKind::kPhong, PatchKind::kSpherigon, PatchKind::kFlat};
  constexpr std::array kProjections{ProjectionKind::kNewton, ProjectionKind::kBisection, ProjectionKind::kAnalytic};
  rig.smoothing.patch = kPatches[static_cast<std::size_t>(random.below(4))];
  rig.smoothing.projection = kProjections[static_cast<std::size_t>(random.below(3))];
  for (Primitive& primitive : rig.primitives) {
    if (random.chance(0.1f)) primitive.reach = random.uniform(1.001f, 6.0f);
  }
  return rig;
}

TEST(Property, RandomRigsAndPosesStayWhole) {
  const std::vector<CharacterPtr> characters{makeLimb(), makeTwoLegged(), makeTube(), makeStrip()};
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const CharacterPtr& character = characters[seed % characters.size()];
    const Rig rig = anyRig(*character, seed);
    Smoother smoother(character);
    const auto prepared = smoother.prepare(rig);
    ASSERT_TRUE(prepared.ok()) << "seed " << seed << ": " << prepared.error().text();
    Surface surface;
    smoother.smooth(randomPose(character->skeleton, 1.5f, 0.5f, seed), surface);
    ASSERT_TRUE(allFinite(surface.positions)) << "seed " << seed;
    ASSERT_TRUE(allUnit(surface.normals)) << "seed " << seed;
    if (character->name != "strip") {
      ASSERT_TRUE(isClosed(surface.refinement->triangles)) << "seed " << seed;
    }
    // Nothing flies off: no further from the character than the largest reach the recipes allow.
    for (const glm::vec3& p : surface.positions)
      ASSERT_LT(glm::length(p), 40.0f * character->height) << "seed " << seed;
  }
}

// The corners of what a rig may say: every valid setting gives a whole surface.
TEST(Property, SettingsAtTheirLimitsStayWhole) {
  const CharacterPtr character = makeTwoLegged();
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Rig rig = anyRig(*character, seed);
    for (const float iso : {kLeastIso, kMostIso}) {
      for (const float blend : {std::numeric_limits<float>::denorm_min(), 1e-6f, kMostSkinBlend}) {
        rig.surface.iso = iso;
        rig.surface.skinBlend = blend;
        Smoother smoother(character);
        ASSERT_TRUE(smoother.prepare(rig).ok());
        Surface surface;
        smoother.smooth(randomPose(character->skeleton, 1.5f, 0.5f, seed), surface);
        ASSERT_TRUE(allFinite(surface.positions)) << "seed " << seed << " iso " << iso << " blend " << blend;
        ASSERT_TRUE(allUnit(surface.normals)) << "seed " << seed << " iso " << iso << " blend " << blend;
        for (const glm::vec3& p : surface.positions) ASSERT_LT(glm::length(p), 100.0f * character->height);
      }
    }
  }
}

// Bones flattened to a plane, a line, a point; primitives on them reach nothing or something, never NaN.
TEST(Property, FlattenedBonesAreHarmless) {
  const CharacterPtr character = makeTwoLegged();
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    const Rig rig = anyRig(*character, seed);
    Smoother smoother(character);
    ASSERT_TRUE(smoother.prepare(rig).ok());
    Pose pose = bindPose(character->skeleton);
    glm::mat4& bone = pose.boneInWorld[seed % pose.boneInWorld.size()];
    for (int column = 0; column <= static_cast<int>(seed % 3); ++column) bone[column] = glm::vec4(0.0f);
    Surface surface;
    smoother.smooth(pose, surface);
    ASSERT_TRUE(allFinite(surface.positions)) << "seed " << seed;
    ASSERT_TRUE(allUnit(surface.normals)) << "seed " << seed;
  }
}

// A mirrored bone (negative scale) turns the skin inside out with its normals still unit.
TEST(Property, MirroredBonesAreHarmless) {
  const CharacterPtr character = makeLimb();
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Smoother smoother(character);
    ASSERT_TRUE(smoother.prepare(anyRig(*character, seed)).ok());
    Pose pose = bindPose(character->skeleton);
    for (glm::mat4& bone : pose.boneInWorld) bone[0] = -bone[0];
    Surface surface;
    smoother.smooth(pose, surface);
    ASSERT_TRUE(allFinite(surface.positions)) << "seed " << seed;
    ASSERT_TRUE(allUnit(surface.normals)) << "seed " << seed;
  }
}

/// Largest step of any vertex between surfaces of neighbouring parameters.
float largestStep(const Surface& a, const Surface& b) {
  float out = 0.0f;
  for (std::size_t v = 0; v < a.positions.size(); ++v) {
    out = std::max(out, glm::distance(a.positions[v], b.positions[v]));
  }
  return out;
}

// A shallow muscle (no overhang) sliding out through the skin: the skin rises without a jump.
TEST(Property, SwellMovesContinuouslyWithThePrimitive) {
  const CharacterPtr character = makeLimb();
  Rig rig;
  rig.groups.push_back({"a", {}});
  rig.primitives.push_back(ellipsoidAt(*character, "lens", "middle", "a", {0.0f, 1.0f, 0.0f}, {0.25f, 0.3f, 0.15f}));
  rig.smoothing.depth = 4;
  Smoother smoother(character);
  const glm::vec3 start = rig.primitives[0].placement.center;
  Surface before;
  Surface after;
  float worst = 0.0f;
  float total = 0.0f;
  constexpr int kSteps = 400;
  for (int i = 0; i <= kSteps; ++i) {
    rig.primitives[0].placement.center = start + glm::vec3(0.0f, 0.0f, 0.2f * static_cast<float>(i) / kSteps);
    ASSERT_TRUE(smoother.prepare(rig).ok());
    smoother.smooth(bindPose(character->skeleton), after);
    if (i > 0) {
      worst = std::max(worst, largestStep(before, after));
      total += largestStep(before, after);
    }
    before = after;
  }
  EXPECT_GT(total, 0.05f) << "the skin moved";
  EXPECT_LT(worst, 8.0f * 0.2f / kSteps) << "no step much longer than the primitive's own";
}

}  // namespace
}  // namespace sinew::test
