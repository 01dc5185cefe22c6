// tests/surface/projection/tile_projection_test.cpp: `swell` and `replace` in tiles agree with scalar code, and all
// instruction sets give the same bits.

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/geometry/instruction_set.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/rigs/trial_scenes.h"
#include "tests/support/surface/mesh_checks.h"
#include "tests/support/surface/projected.h"
#include "tests/support/surface/vector_agreement.h"

namespace sinew::test {
namespace {

using CharacterPtr = std::shared_ptr<const Character>;

/// In two poses.
void expectSameBitsByEverySet(const TrialScene& scene, Projected& projected) {
  for (const Pose& pose : spreadPoses(*scene.character, 2)) {
    const Surface widest = projected.at(pose);
    for (const InstructionSet set : availableInstructionSets()) {
      if (set == InstructionSet::kScalar) continue;
      const Surface other = surfaceBy(set, projected, pose);
      EXPECT_TRUE(other.positions == widest.positions) << scene.name << ", " << nameOf(set);
      EXPECT_TRUE(other.normals == widest.normals) << scene.name << ", " << nameOf(set);
      EXPECT_TRUE(other.displacement == widest.displacement) << scene.name << ", " << nameOf(set);
    }
  }
}

// humanoid-flex and horse-flex have bent muscles.
TEST(VectorSwell, MatchesTheScalarOnCharacters) {
  std::vector<TrialScene> scenes = trialScenes();
  for (const char* name : {"humanoid", "horse", "demo", "humanoid-flex", "horse-flex"}) {
    scenes.push_back(bundledTrialScene(name));
  }
  for (const TrialScene& scene : scenes) {
    Agreement seen;
    addAgreement(*scene.character, withMode(scene.rig, SurfaceMode::kSwell), spreadPoses(*scene.character, 4), seen);
    print(scene.name, seen);
    EXPECT_GT(seen.projected, 500) << scene.name;
    EXPECT_LE(seen.worst, kAim) << scene.name;
    EXPECT_LE(seen.worstNormal, 1e-3) << scene.name;
    EXPECT_LE(seen.uncertifiedShare(), 0.02) << scene.name;
  }
}

TEST(VectorSwell, EveryInstructionSetGivesTheSameBits) {
  std::string sets;
  for (const InstructionSet set : availableInstructionSets()) sets += std::string(" ") + nameOf(set);
  std::printf("  this machine runs%s\n", sets.c_str());
  for (const TrialScene& scene : trialScenes()) {
    Rig rig = withMode(scene.rig, SurfaceMode::kSwell);
    Projected projected(*scene.character, rig);
    expectSameBitsByEverySet(scene, projected);
  }
}

// Neighboring rays meet other muscles, some of them carves.
TEST(VectorSwell, EveryInstructionSetGivesTheSameBitsOnRandomRigs) {
  const CharacterPtr character = makeTwoLegged();
  for (std::uint64_t seed = 0; seed < 16; ++seed) {
    RigRecipe recipe;
    recipe.primitives = 16;
    recipe.groups = 1 + static_cast<int>(seed % 4);
    recipe.carveChance = 0.3f;
    recipe.radiusHigh = seed % 2 == 0 ? 0.1f : 0.4f;
    recipe.shapedChance = seed % 3 == 0 ? 0.0f : 0.5f;
    recipe.groovesChance = 0.5f;
    recipe.partChance = seed % 8 < 4 ? 0.5f : 0.0f;
    Rig rig = randomRig(*character, recipe, seed);
    rig.smoothing.detail = DetailKind::kUniform;
    rig.smoothing.depth = 4;
    rig.surface.mode = seed % 2 == 0 ? SurfaceMode::kSwell : SurfaceMode::kReplace;
    Projected projected(*character, rig);
    const Pose pose = randomPose(character->skeleton, 0.6f, 0.3f, seed);
    const Surface widest = projected.at(pose);
    EXPECT_GT(widest.report.projected, 100);
    for (const InstructionSet set : availableInstructionSets()) {
      if (set == InstructionSet::kScalar) continue;
      const Surface other = surfaceBy(set, projected, pose);
      EXPECT_TRUE(sameBytes(other.positions, widest.positions)) << seed << ", " << nameOf(set);
      EXPECT_TRUE(sameBytes(other.normals, widest.normals)) << seed << ", " << nameOf(set);
    }
  }
}

// Also patches, shading normals and `replace`; the projection's bits are covered by the test above.
TEST(VectorSwell, EveryInstructionSetGivesTheSameBitsForAWholeFrame) {
  constexpr PatchKind kKinds[] = {PatchKind::kPn, PatchKind::kPhong, PatchKind::kSpherigon};
  for (const TrialScene& scene : trialScenes()) {
    for (const int depth : {1, 3, 5}) {
      for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
        Rig rig = withMode(scene.rig, mode);
        rig.smoothing.detail = DetailKind::kUniform;
        rig.smoothing.depth = depth;
        rig.smoothing.patch = kKinds[(depth + static_cast<int>(mode)) / 2 % 3];
        Smoother smoother(scene.character);
        ASSERT_TRUE(smoother.prepare(rig).ok());
        const Pose pose = spreadPoses(*scene.character, 3).back();
        Surface widest;
        smoother.smooth(pose, widest);
        for (const InstructionSet set : availableInstructionSets()) {
          if (set == InstructionSet::kScalar) continue;  // The projection's scalar path differs.
          const InstructionSetScope scope(set);
          Surface other;
          smoother.smooth(pose, other);
          EXPECT_TRUE(sameBytes(other.positions, widest.positions)) << scene.name << ", " << nameOf(set);
          EXPECT_TRUE(sameBytes(other.normals, widest.normals)) << scene.name << ", " << nameOf(set);
          EXPECT_TRUE(other.displacement == widest.displacement) << scene.name << ", " << nameOf(set);
        }
      }
    }
  }
}

TEST(VectorSwell, MatchesTheScalarOnRandomRigs) {
  struct Sizes {
    const char* name;
    float low;
    float high;
    int least;           ///< Projected.
    double uncertified;  ///< Fraction; inside muscles larger than the body a ray crosses several at once.
  };
  for (const auto& [name, low, high, least, uncertified] : {Sizes{"usual", 0.03f, 0.1f, 10000, 0.02},
                                                            {"tiny", 0.002f, 0.01f, 50, 0.02},
                                                            {"huge", 0.3f, 2.0f, 10000, 0.5}}) {
    Agreement seen;
    for (const CharacterPtr& character : {makeLimb(), makeTwoLegged(), makeStrip()}) {
      for (std::uint64_t seed = 0; seed < 12; ++seed) {
        RigRecipe recipe;
        recipe.primitives = 14;
        recipe.groups = 1 + static_cast<int>(seed % 6);
        recipe.carveChance = 0.3f;
        recipe.radiusLow = low;
        recipe.radiusHigh = high;
        recipe.groovesChance = 0.4f;
        Rig rig = randomRig(*character, recipe, seed);
        rig.smoothing.detail = DetailKind::kUniform;
        rig.smoothing.depth = 4;
        addAgreement(*character, rig, {randomPose(character->skeleton, 0.6f, 0.3f, seed)}, seen);
      }
    }
    print(name, seen);
    EXPECT_GT(seen.projected, least) << name;
    // Where two roots meet, rounding decides which one is found.
    EXPECT_LE(seen.far, seen.projected / 2000) << name;
    EXPECT_LE(seen.uncertifiedShare(), uncertified) << name;
  }
}

// A shell that the skin's field just reaches, then just misses: roots meet and vanish along the path. And carves that
// do the same inwards.
TEST(VectorSwell, MatchesTheScalarAcrossTangencies) {
  const CharacterPtr character = makeStrip();
  const float height = character->height;
  for (const int sign : {1, -1}) {
    Agreement seen;
    for (int step = 0; step < 60; ++step) {
      Rig rig = randomRig(*character, {.primitives = 1, .groups = 1}, 1);
      const glm::vec3 under = 0.5f * (character->mesh.positions.front() + character->mesh.positions.back());
      const float radius = 0.06f * height;
      const float off = radius * 0.05f * static_cast<float>(step);
      const std::string group = rig.primitives.front().group;
      Primitive low = ellipsoidAt(*character, "low", "root", group, under, glm::vec3(radius));
      Primitive high = ellipsoidAt(*character, "high", "root", group, under + glm::vec3(0.0f, 0.0f, off),
                                   glm::vec3(0.7f, 1.3f, 0.8f) * radius);
      high.sign = sign;
      rig.primitives = {low, high};
      rig.smoothing.detail = DetailKind::kUniform;
      rig.smoothing.depth = 6;
      addAgreement(*character, rig, {bindPose(character->skeleton)}, seen);
    }
    print(sign > 0 ? "shells that touch" : "carves that touch", seen);
    EXPECT_GT(seen.projected, 500);
    EXPECT_LE(seen.far, seen.projected / 1000);
  }
}

std::vector<TrialScene> scenes() {
  std::vector<TrialScene> out = trialScenes();
  for (const char* name : {"humanoid-wrapped", "horse-wrapped", "humanoid", "demo", "horse-flex"}) {
    out.push_back(bundledTrialScene(name));
  }
  return out;
}

TEST(VectorReplace, MatchesTheScalarOnCharacters) {
  for (const TrialScene& scene : scenes()) {
    Agreement seen;
    addAgreement(*scene.character, withMode(scene.rig, SurfaceMode::kReplace), spreadPoses(*scene.character, 4), seen);
    print(scene.name, seen);
    EXPECT_GT(seen.projected, 50) << scene.name;
    EXPECT_EQ(seen.far, 0) << scene.name;
    EXPECT_LE(seen.uncertifiedShare(), 0.025) << scene.name;
  }
}

TEST(VectorReplace, EveryInstructionSetGivesTheSameBits) {
  for (const TrialScene& scene : scenes()) {
    Projected projected(*scene.character, withMode(scene.rig, SurfaceMode::kReplace));
    expectSameBitsByEverySet(scene, projected);
  }
}

}  // namespace
}  // namespace sinew::test
