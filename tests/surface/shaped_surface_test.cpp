// tests/surface/shaped_surface_test.cpp: surfaces over capsules, eggs and bent spindles: oracle, vector path,
// continuity.

#include <iostream>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/geometry/affine_image.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/oracle/compare.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/rigs/trial_scenes.h"
#include "tests/support/surface/every_kind.h"
#include "tests/support/surface/mesh_checks.h"
#include "tests/support/surface/projected.h"
#include "tests/support/surface/vector_agreement.h"

namespace sinew::test {
namespace {

using CharacterPtr = std::shared_ptr<const Character>;

Rig shapedRig(const Character& character, SurfaceMode mode, std::uint64_t seed) {
  RigRecipe recipe;
  recipe.primitives = 16;
  recipe.groups = 3;
  recipe.shapedChance = 0.8f;
  recipe.groovesChance = 0.5f;
  if (mode == SurfaceMode::kReplace) {
    recipe.carveChance = 0.05f;
    recipe.radiusLow = 0.06f;
    recipe.radiusHigh = 0.14f;
  }
  Rig rig = randomRig(character, recipe, seed);
  rig.surface.mode = mode;
  return rig;
}

oracle::Tally tallyOf(const CharacterPtr& character, const Rig& rig, ProjectionKind projection) {
  Smoother smoother(character, projection);
  const auto prepared = smoother.prepare(rig);
  EXPECT_TRUE(prepared.ok()) << prepared.error().text();
  if (!prepared) return {};
  oracle::Oracle oracle(*character, rig, projection);
  Projected projected(*character, rig, projection);
  oracle::Tally total;
  Surface surface;
  for (const Pose& pose : {bindPose(character->skeleton), randomPose(character->skeleton, 0.5f, 0.2f, 4)}) {
    smoother.smooth(pose, surface);
    EXPECT_TRUE(allFinite(surface.positions));
    EXPECT_TRUE(allUnit(surface.normals));
    oracle.pose(pose);
    const Surface& raw = projected.at(pose);
    const oracle::Stages stages(oracle, projected.bindPatch(), projected.patch(), raw);
    const int stride = std::max(1, static_cast<int>(surface.positions.size()) / 250);
    total.add(oracle::compare(oracle, *character, stages, surface, stride, 0));
  }
  return total;
}

void expectAgreement(SurfaceMode mode) {
  int sought = 0;
  for (const CharacterPtr& character : {makeLimb(), makeTwoLegged()}) {
    for (const ProjectionKind projection : kEveryProjection) {
      const oracle::Tally tally = tallyOf(character, shapedRig(*character, mode, 5), projection);
      const std::string what = character->name + ", " + nameOf(mode) + ", " + nameOf(projection);
      std::cout << "  " << what << ": " << tally.text() << "\n";
      EXPECT_LE(tally.farShare(), 0.008) << what << "; " << tally.firstFar;
      EXPECT_EQ(tally.unexplained, 0) << what << "; " << tally.firstFar;
      EXPECT_EQ(tally.farUnsought, 0) << what << "; " << tally.firstFar;
      EXPECT_LE(tally.normalsOffShare(), 0.01) << what << "; " << tally.firstOff;
      EXPECT_EQ(tally.guardOff, 0) << what << "; " << tally.firstOff;
      EXPECT_EQ(tally.shadingOff, 0) << what << "; " << tally.firstOff;
      sought += tally.sought;
    }
  }
  EXPECT_GT(sought, 100);
}

TEST(ShapedSurface, SwellMatchesBruteForce) { expectAgreement(SurfaceMode::kSwell); }

TEST(ShapedSurface, ReplaceMatchesBruteForce) { expectAgreement(SurfaceMode::kReplace); }

TEST(ShapedSurface, VectorPathMatchesTheScalarPath) {
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    Agreement seen;
    for (const CharacterPtr& character : {makeLimb(), makeTwoLegged()}) {
      for (std::uint64_t seed = 0; seed < 8; ++seed) {
        Rig rig = shapedRig(*character, mode, seed);
        rig.smoothing.detail = DetailKind::kUniform;
        rig.smoothing.depth = 4;
        addAgreement(*character, rig, {randomPose(character->skeleton, 0.5f, 0.2f, seed)}, seen);
      }
    }
    const std::string what = nameOf(mode);
    print(what, seen);
    EXPECT_GT(seen.projected, 2000) << what;
    // Where two roots meet, rounding decides which one is found.
    EXPECT_LE(seen.beyondAim, seen.projected / 500) << what;
    EXPECT_LE(seen.far, seen.projected / 2000) << what;
    EXPECT_LE(seen.uncertifiedShare(), 0.05) << what;
  }
}

/// Largest step of any vertex between two surfaces.
float step(const Surface& a, const Surface& b) {
  float most = 0.0f;
  for (std::size_t v = 0; v < a.positions.size(); ++v) {
    most = std::max(most, glm::distance(a.positions[v], b.positions[v]));
  }
  return most;
}

TEST(ShapedSurface, SurfaceIsContinuousInEachShapeParameter) {
  const CharacterPtr character = makeLimb();
  Rig start;
  start.groups.push_back({"arm", {}});
  start.primitives.push_back(
      ellipsoidAt(*character, "biceps", "middle", "arm", {0.27f, 1.0f, 0.0f}, {0.1f, 0.4f, 0.12f}));
  const Pose pose = bindPose(character->skeleton);
  for (const ShapeNumber& number : shapeNumbers()) {
    const auto [low, high] = number.range({}, start.primitives[0].reach);
    constexpr int kSteps = 600;
    Smoother smoother(character);
    Surface last;
    Surface now;
    float most = 0.0f;
    float whole = 0.0f;
    for (int i = 0; i <= kSteps; ++i) {
      Rig rig = start;
      number.member(rig.primitives[0].placement.shape) = low + (high - low) * static_cast<float>(i) / kSteps;
      ASSERT_TRUE(smoother.prepare(rig).ok());
      smoother.smooth(pose, now);
      if (i > 0) {
        most = std::max(most, step(now, last));
        whole += step(now, last);
      }
      std::swap(now, last);
    }
    std::cout << "  " << number.name << ": largest step " << most / character->height << " H of "
              << whole / character->height << "\n";
    EXPECT_GT(whole, 1e-3f * character->height) << number.name << ": does nothing";
    EXPECT_LT(most, 2e-3f * character->height) << number.name;
  }
}

}  // namespace
}  // namespace sinew::test
