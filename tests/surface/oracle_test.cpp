// tests/surface/oracle_test.cpp: the smoother's vertices match a double-precision brute-force solver.

#include <algorithm>
#include <array>
#include <iostream>

#include <gtest/gtest.h>

#include "core/geometry/instruction_set.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/real_characters.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/long_run.h"
#include "tests/support/oracle/compare.h"
#include "tests/support/rigs/driven_rig.h"
#include "tests/support/rigs/keyed_links.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/every_kind.h"
#include "tests/support/surface/mesh_checks.h"
#include "tests/support/surface/projected.h"

namespace sinew::test {
namespace {

using CharacterPtr = std::shared_ptr<const Character>;

RigRecipe recipeOf(int primitives) {
  RigRecipe recipe;
  recipe.primitives = primitives;
  recipe.groups = primitives == 1 ? 1 : primitives < 10 ? 3 : 6;
  if (primitives == 1) recipe.carveChance = 0.0f;
  return recipe;
}

/// The bind pose, then `count` poses spread over the character's first clip.
std::vector<Pose> posesOf(const Character& character, int count) {
  std::vector<Pose> out{bindPose(character.skeleton)};
  const AnimationClip& clip = character.clips.back();
  for (int i = 0; i < count; ++i) {
    const float time = clip.duration * (static_cast<float>(i) + 0.37f) / static_cast<float>(count);
    out.push_back(samplePose(character.skeleton, clip, time));
  }
  return out;
}

oracle::Tally tallyOf(const CharacterPtr& character, const Rig& rig, int poses, int wanted,
                      ProjectionKind projection = ProjectionKind::kNewton) {
  Smoother smoother(character, projection);
  const auto prepared = smoother.prepare(rig);
  EXPECT_TRUE(prepared.ok()) << prepared.error().text();
  if (!prepared) return {};
  oracle::Oracle oracle(*character, rig, projection);
  Projected projected(*character, rig, projection);
  oracle::Tally total;
  Surface surface;
  int first = 0;
  for (const Pose& pose : posesOf(*character, poses)) {
    smoother.smooth(pose, surface);
    EXPECT_TRUE(allFinite(surface.positions));
    EXPECT_TRUE(allFinite(surface.normals));
    EXPECT_TRUE(allUnit(surface.normals));
    oracle.pose(pose);
    const int stride = std::max(1, static_cast<int>(surface.positions.size()) * (poses + 1) / wanted);
    const Surface& raw = projected.at(pose);
    const oracle::Stages stages(oracle, projected.bindPatch(), projected.patch(), raw);
    total.add(oracle::compare(oracle, *character, stages, surface, stride, first++ % stride));
  }
  return total;
}

void expectAgreement(const std::string& what, const oracle::Tally& tally) {
  std::cout << "  " << what << ": " << tally.text() << "\n";
  EXPECT_GT(tally.compared, 0);
  EXPECT_LE(tally.farShare(), 0.008) << what << "; " << tally.firstFar;
  EXPECT_EQ(tally.unexplained, 0) << what << "; " << tally.firstFar;
  EXPECT_EQ(tally.farUnsought, 0) << what << "; " << tally.firstFar;
  EXPECT_LE(tally.normalsOffShare(), 0.01) << what << "; " << tally.firstOff;
  EXPECT_EQ(tally.guardOff, 0) << what << "; " << tally.firstOff;
  EXPECT_EQ(tally.shadingOff, 0) << what << "; " << tally.firstOff;
}

void expectSwellAgrees(const CharacterPtr& character, int primitives, int wanted) {
  int sought = 0;
  for (const ProjectionKind projection : kEveryProjection) {
    const Rig rig = randomRig(*character, recipeOf(primitives), static_cast<std::uint64_t>(primitives));
    const oracle::Tally tally = tallyOf(character, rig, 5, wanted, projection);
    expectAgreement(character->name + ", swell, " + nameOf(projection) + ", " + std::to_string(primitives), tally);
    sought += tally.sought;
  }
  EXPECT_GT(sought, 0) << "no primitive reached the skin: the comparison says nothing";
}

/// `replace` is for bodies that primitives wrap: fat ellipsoids around every bone.
Rig wrappingRig(const Character& character, int primitives) {
  RigRecipe recipe = recipeOf(primitives);
  recipe.carveChance = 0.05f;
  recipe.radiusLow = 0.06f;
  recipe.radiusHigh = 0.14f;
  Rig rig = randomRig(character, recipe, 77);
  rig.surface.mode = SurfaceMode::kReplace;
  return rig;
}

void expectReplaceAgrees(const CharacterPtr& character, ProjectionKind projection, int primitives, int wanted) {
  const Rig rig = wrappingRig(*character, primitives);
  const oracle::Tally tally = tallyOf(character, rig, 5, wanted, projection);
  expectAgreement(character->name + ", replace, " + nameOf(projection) + ", " + std::to_string(primitives), tally);
  EXPECT_GT(tally.sought, 0);
}

void expectReplaceAgrees(ProjectionKind projection) {
  for (const CharacterPtr& character : {makeLimb(), makeTwoLegged(), makeStrip(), makeTube()}) {
    for (const int primitives : {5, 40}) expectReplaceAgrees(character, projection, primitives, 1500);
  }
  for (const char* file : {"Fox.glb", "greenman.glb"}) {
    if (const CharacterPtr character = realCharacter(file)) expectReplaceAgrees(character, projection, 40, 1500);
  }
}

// The comparison must detect deliberate errors.
TEST(Oracle, ComparisonDetectsWrongSurfaces) {
  const CharacterPtr character = makeLimb();
  const Rig rig = randomRig(*character, recipeOf(12), 2);
  Smoother smoother(character);
  ASSERT_TRUE(smoother.prepare(rig).ok());
  const oracle::Oracle oracle(*character, rig);
  Surface right;
  smoother.smooth(bindPose(character->skeleton), right);
  Projected projected(*character, rig);
  const Surface& raw = projected.at(bindPose(character->skeleton));
  const oracle::Stages stages(oracle, projected.bindPatch(), projected.patch(), raw);
  const oracle::Tally good = oracle::compare(oracle, *character, stages, right, 1, 0);
  EXPECT_EQ(good.far + good.farUnsought + good.normalsOff + good.guardOff + good.shadingOff, 0)
      << good.text() << "; " << good.firstFar << good.firstOff;
  ASSERT_GT(good.sought, 50);

  Surface wrong = right;
  for (glm::vec3& p : wrong.positions) p.y += 2e-4f * character->height;
  const oracle::Tally moved = oracle::compare(oracle, *character, stages, wrong, 1, 0);
  // A guarded vertex is compared as before.
  EXPECT_EQ(moved.far + moved.farUnsought + moved.guardOff, moved.compared);
  wrong = right;
  for (glm::vec3& n : wrong.normals) n = glm::normalize(n + glm::vec3(0.05f, -0.04f, 0.03f));
  EXPECT_GT(oracle::compare(oracle, *character, stages, wrong, 1, 0).shadingOff, good.sought / 2);
}

// Deliberate errors: inverted triangles left as they are, and field normals not limited by their faces.
TEST(Oracle, ComparisonDetectsUnfinishedSurfaces) {
  const CharacterPtr character = makeTwoLegged();
  const Rig rig = randomRig(*character, recipeOf(40), 40);
  Smoother smoother(character);
  ASSERT_TRUE(smoother.prepare(rig).ok());
  oracle::Oracle oracle(*character, rig);
  Projected projected(*character, rig);
  const Pose pose = posesOf(*character, 1).back();
  oracle.pose(pose);
  Surface right;
  smoother.smooth(pose, right);
  const Surface& raw = projected.at(pose);
  const oracle::Stages stages(oracle, projected.bindPatch(), projected.patch(), raw);
  const oracle::Tally good = oracle::compare(oracle, *character, stages, right, 1, 0);
  EXPECT_EQ(good.far + good.farUnsought + good.guardOff + good.shadingOff, 0) << good.text() << "; " << good.firstOff;
  ASSERT_GT(good.guarded, 5);

  Surface turned = right;
  turned.positions = raw.positions;
  EXPECT_GT(oracle::compare(oracle, *character, stages, turned, 1, 0).guardOff, good.guarded / 2);
  Surface unfiltered = right;
  unfiltered.normals = raw.normals;
  EXPECT_GT(oracle::compare(oracle, *character, stages, unfiltered, 1, 0).shadingOff, good.sought / 20);
}

// A deliberate error: the maximum where the oracle wants soft grooves.
TEST(Oracle, ComparisonDetectsMissingGrooves) {
  const CharacterPtr character = makeTwoLegged();
  Rig rig = randomRig(*character, recipeOf(40), 40);
  Smoother smoother(character);
  ASSERT_TRUE(smoother.prepare(rig).ok());
  Surface sharp;
  smoother.smooth(bindPose(character->skeleton), sharp);
  Projected projected(*character, rig);
  const Surface& raw = projected.at(bindPose(character->skeleton));
  rig.surface.grooves = 0.05f;
  const oracle::Oracle oracle(*character, rig);
  const oracle::Stages stages(oracle, projected.bindPatch(), projected.patch(), raw);
  const oracle::Tally tally = oracle::compare(oracle, *character, stages, sharp, 1, 0);
  EXPECT_GT(tally.unexplained, 20) << tally.text();
}

TEST(Oracle, SwellMatchesOnSyntheticCharacters) {
  for (const CharacterPtr& character : {makeLimb(), makeTwoLegged(), makeStrip(), makeTube()}) {
    for (const int primitives : {1, 5, 40}) expectSwellAgrees(character, primitives, longRun() ? 2500 : 600);
  }
}

TEST(Oracle, ReplaceByNewtonMatches) { expectReplaceAgrees(ProjectionKind::kNewton); }

TEST(Oracle, ReplaceAlongNormalsMatches) {
  const CharacterPtr character = makeTwoLegged();
  Rig rig = wrappingRig(*character, 40);
  rig.smoothing.alongNormals = true;
  const oracle::Tally tally = tallyOf(character, rig, 5, 1500);
  expectAgreement("two-legged, replace, along normals", tally);
  EXPECT_GT(tally.sought, 0);
}

TEST(Oracle, ReplaceByAnalyticMatches) { expectReplaceAgrees(ProjectionKind::kAnalytic); }

TEST(Oracle, ReplaceByBisectionMatches) { expectReplaceAgrees(ProjectionKind::kBisection); }

TEST(Oracle, EveryPatchMatches) {
  const CharacterPtr character = makeTwoLegged();
  for (const PatchKind patch : {PatchKind::kPn, PatchKind::kPhong, PatchKind::kFlat}) {
    Rig rig = randomRig(*character, recipeOf(12), 3);
    rig.smoothing.patch = patch;
    rig.smoothing.depth = 4;
    expectAgreement(std::string("two-legged, swell, ") + nameOf(patch), tallyOf(character, rig, 3, 3000));
  }
}

TEST(Oracle, SpheresMatchOnTheirFastPath) {
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    for (const ProjectionKind projection : kEveryProjection) {
      const CharacterPtr character = makeTwoLegged();
      Rig rig = mode == SurfaceMode::kSwell ? randomRig(*character, recipeOf(20), 4) : wrappingRig(*character, 20);
      for (Primitive& p : rig.primitives) p.placement.radii = glm::vec3(p.placement.radii.x);
      expectAgreement(std::string("two-legged, spheres, ") + nameOf(mode) + ", " + nameOf(projection),
                      tallyOf(character, rig, 3, 1500, projection));
    }
  }
}

TEST(Oracle, OtherIsoAndSkinBlendMatch) {
  const CharacterPtr character = makeLimb();
  for (const float iso : {0.05f, 0.5f, 0.9f}) {
    for (const float blend : {0.01f, 0.15f}) {
      Rig rig = randomRig(*character, recipeOf(12), 9);
      rig.surface.iso = iso;
      rig.surface.skinBlend = blend;
      expectAgreement("limb, iso " + std::to_string(iso) + ", blend " + std::to_string(blend),
                      tallyOf(character, rig, 2, 1500));
    }
  }
}

/// Crowded muscles of six groups, of which some are linked; every third with wide grooves.
Rig groovedRig(const Character& character, SurfaceMode mode, std::uint64_t seed) {
  RigRecipe recipe = recipeOf(40);
  constexpr std::array kLinkChances{0.15f, 0.4f, 0.7f};
  recipe.linkChance = kLinkChances[seed % kLinkChances.size()];
  recipe.shapedChance = seed % 2 == 0 ? 0.0f : 0.3f;
  recipe.groovesChance = 1.0f;
  recipe.radiusHigh = 0.14f;
  if (mode == SurfaceMode::kReplace) {
    recipe.carveChance = 0.05f;
    recipe.radiusLow = 0.06f;
  }
  Rig rig = randomRig(character, recipe, seed + 50);
  rig.surface.mode = mode;
  if (seed % 3 == 1) rig.surface.grooves = std::min(0.3f, 6.0f * rig.surface.grooves);
  return rig;
}

/// @return vertices where grooves meet
int expectGroovesAgree(const CharacterPtr& character, SurfaceMode mode, ProjectionKind projection, std::uint64_t seed,
                       int wanted, const std::string& by = "") {
  const Rig rig = groovedRig(*character, mode, seed);
  const oracle::Tally tally = tallyOf(character, rig, 3, longRun() ? 2500 : wanted, projection);
  const std::string what = character->name + ", grooves " + std::to_string(rig.surface.grooves) + ", " + nameOf(mode) +
                           ", " + nameOf(projection) + by;
  expectAgreement(what, tally);
  EXPECT_LE(tally.roughShare(), 0.01) << what;
  EXPECT_GT(tally.inGrooves, 0) << what;
  return tally.whereGroovesMeet;
}

TEST(Oracle, SoftGroovesMatch) {
  int meeting = 0;
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    std::uint64_t seed = 0;
    for (const CharacterPtr& character : {makeLimb(), makeTwoLegged(), makeTube()}) {
      for (int i = 0; i < (longRun() ? 6 : 1); ++i, ++seed) {
        for (const ProjectionKind projection : kEveryProjection) {
          meeting += expectGroovesAgree(character, mode, projection, seed, 400);
        }
      }
    }
  }
  EXPECT_GT(meeting, 50);
}

// Of the other instruction sets, EveryInstructionSetGivesTheSameBitsOnRandomRigs shows that they agree.
TEST(Oracle, SoftGroovesMatchByScalars) {
  const CharacterPtr character = makeTwoLegged();
  const InstructionSetScope scope(InstructionSet::kScalar);
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    for (const std::uint64_t seed : {7u, 8u}) {
      expectGroovesAgree(character, mode, ProjectionKind::kNewton, seed, 200, ", scalar");
    }
  }
}

// So narrow that the maximum is what they come to.
TEST(Oracle, NarrowestGroovesMatch) {
  const CharacterPtr character = makeTwoLegged();
  Rig rig = groovedRig(*character, SurfaceMode::kSwell, 1);
  rig.surface.grooves = 1e-5f;
  expectAgreement("two-legged, narrowest grooves", tallyOf(character, rig, 3, 1500));
}

TEST(Oracle, LinksInPartMatch) {
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    std::uint64_t seed = 20;
    for (const CharacterPtr& character : {makeLimb(), makeTwoLegged()}) {
      for (const float grooves : {0.0f, 0.02f}) {
        if (!longRun() && (grooves > 0.0f) == (character->name == "limb")) continue;
        for (const ProjectionKind projection : kEveryProjection) {
          RigRecipe recipe = recipeOf(30);
          recipe.linkChance = 0.7f;
          recipe.partChance = 0.7f;
          recipe.shapedChance = grooves > 0.0f ? 0.2f : 0.0f;
          recipe.radiusHigh = 0.14f;
          if (mode == SurfaceMode::kReplace) {
            recipe.carveChance = 0.05f;
            recipe.radiusLow = 0.06f;
          }
          Rig rig = randomRig(*character, recipe, ++seed);
          rig.surface.mode = mode;
          rig.surface.grooves = grooves;
          expectAgreement(character->name + ", links in part, grooves " + std::to_string(grooves) + ", " +
                              nameOf(mode) + ", " + nameOf(projection),
                          tallyOf(character, rig, 3, longRun() ? 2500 : 400, projection));
        }
      }
    }
  }
}

TEST(Oracle, LinksInPartMatchByScalars) {
  const CharacterPtr character = makeTwoLegged();
  const InstructionSetScope scope(InstructionSet::kScalar);
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    for (const float grooves : {0.0f, 0.05f}) {
      Rig rig = groovedRig(*character, mode, 8);
      rig.surface.grooves = grooves;
      for (std::size_t i = 0; i < rig.links.size(); ++i) rig.links[i].amount = 0.2f * static_cast<float>(1 + i % 5);
      expectAgreement(std::string("two-legged, links in part, grooves ") + std::to_string(grooves) + ", " +
                          nameOf(mode) + ", scalar",
                      tallyOf(character, rig, 3, 200));
    }
  }
}

TEST(Oracle, AnimatedLinksMatchAtEachMoment) {
  const CharacterPtr character = makeTwoLegged();
  const AnimationClip& clip = character->clips.back();
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    for (const float grooves : {0.0f, 0.02f}) {
      Rig rig = groovedRig(*character, mode, 5);
      rig.surface.grooves = grooves;
      rig = withKeyedLinks(std::move(rig), clip, 5);
      Smoother smoother(character);
      ASSERT_TRUE(smoother.prepare(rig).ok());
      Surface surface;
      oracle::Tally total;
      for (const float part : {0.1f, 0.75f}) {
        const Pose pose = samplePose(character->skeleton, clip, part * clip.duration);
        smoother.smooth(pose, surface);
        const Rig now = withoutKeys(drivenRig(rig, *character, pose));
        oracle::Oracle oracle(*character, now);
        oracle.pose(pose);
        Projected projected(*character, now);
        const Surface& raw = projected.at(pose);
        const oracle::Stages stages(oracle, projected.bindPatch(), projected.patch(), raw);
        const int stride = std::max(1, static_cast<int>(surface.positions.size()) / 300);
        total.add(oracle::compare(oracle, *character, stages, surface, stride, 0));
      }
      expectAgreement(std::string("two-legged, keyed links, grooves ") + std::to_string(grooves) + ", " + nameOf(mode),
                      total);
      EXPECT_GT(total.sought, 0);
    }
  }
}

TEST(Oracle, OtherAmountsMatch) {
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    const CharacterPtr character = makeTwoLegged();
    Rig rig = mode == SurfaceMode::kSwell ? randomRig(*character, recipeOf(20), 31) : wrappingRig(*character, 20);
    constexpr std::array kAmounts{0.0f, 0.4f, 0.8f, 1.3f, 2.0f};
    for (std::size_t i = 0; i < rig.primitives.size(); ++i) rig.primitives[i].amount = kAmounts[i % kAmounts.size()];
    expectAgreement(std::string("two-legged, amounts, ") + nameOf(mode), tallyOf(character, rig, 3, 1500));
  }
}

TEST(Oracle, NonuniformBoneScaleMatches) {
  const CharacterPtr character = makeTwoLegged();
  for (const float grooves : {0.0f, 0.03f}) {
    Rig rig = randomRig(*character, recipeOf(20), 21);
    rig.surface.grooves = grooves;
    Smoother smoother(character);
    ASSERT_TRUE(smoother.prepare(rig).ok());
    oracle::Oracle oracle(*character, rig);
    Projected projected(*character, rig);
    oracle::Tally total;
    Surface surface;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const Pose pose = randomPose(character->skeleton, 0.6f, 0.35f, seed);
      smoother.smooth(pose, surface);
      oracle.pose(pose);
      const Surface& raw = projected.at(pose);
      const oracle::Stages stages(oracle, projected.bindPatch(), projected.patch(), raw);
      total.add(oracle::compare(oracle, *character, stages, surface, 5, static_cast<int>(seed)));
    }
    expectAgreement("two-legged, stretched bones, grooves " + std::to_string(grooves), total);
  }
}

TEST(Oracle, SwellMatchesOnRealCharacters) {
  int found = 0;
  for (const char* file : {"Fox.glb", "greenman.glb"}) {
    const CharacterPtr character = realCharacter(file);
    if (!character) continue;
    ++found;
    for (const int primitives : {1, 5, 40}) expectSwellAgrees(character, primitives, 4000);
  }
  if (found == 0) GTEST_SKIP() << "left out: real characters are not at hand";
}

}  // namespace
}  // namespace sinew::test
