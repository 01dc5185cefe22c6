// tests/surface/smoother_test.cpp: public behavior of the pipeline: determinism, edits, refusals, counts.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/geometry/instruction_set.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/oracle/oracle.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/mesh_checks.h"
#include "tests/support/surface/projected.h"

namespace sinew::test {
namespace {

using CharacterPtr = std::shared_ptr<const Character>;

Rig someRig(const Character& character, SurfaceMode mode = SurfaceMode::kSwell) {
  RigRecipe recipe;
  recipe.primitives = 12;
  Rig rig = randomRig(character, recipe, 4);
  rig.surface.mode = mode;
  return rig;
}

Pose clipPose(const Character& character, float time) {
  return samplePose(character.skeleton, character.clips.front(), time);
}

Surface fresh(const CharacterPtr& character, const Rig& rig, const Pose& pose) {
  Smoother smoother(character);
  const auto prepared = smoother.prepare(rig);
  EXPECT_TRUE(prepared.ok()) << prepared.error().text();
  Surface out;
  if (prepared) smoother.smooth(pose, out);
  return out;
}

void expectSame(const Surface& a, const Surface& b, const std::string& what) {
  EXPECT_TRUE(sameBytes(a.positions, b.positions)) << what;
  EXPECT_TRUE(sameBytes(a.normals, b.normals)) << what;
  EXPECT_EQ(a.displacement, b.displacement) << what;
  EXPECT_EQ(a.classes, b.classes) << what;
  EXPECT_EQ(a.refinement->triangles, b.refinement->triangles) << what;
}

constexpr std::array kModes{SurfaceMode::kSwell, SurfaceMode::kReplace};

TEST(Smoother, EqualInputsGiveEqualSurfaces) {
  const CharacterPtr character = makeTwoLegged();
  for (const SurfaceMode mode : kModes) {
    const Rig rig = someRig(*character, mode);
    const std::string what = nameOf(mode);
    const Surface first = fresh(character, rig, clipPose(*character, 0.8f));
    expectSame(first, fresh(character, rig, clipPose(*character, 0.8f)), what);

    // A smoother that saw other poses in any order, one of them far away, gives the same.
    Smoother used(character);
    ASSERT_TRUE(used.prepare(rig).ok());
    Surface surface;
    for (const float time : {0.0f, 0.3f, 1.9f, 0.81f, 0.79f, 0.8f}) used.smooth(clipPose(*character, time), surface);
    expectSame(first, surface, what + ", after other frames");
    used.smooth(randomPose(character->skeleton, 2.0f, 0.5f, 5), surface);
    used.smooth(clipPose(*character, 0.8f), surface);
    expectSame(first, surface, what + ", after a cut");
  }
}

TEST(Smoother, ComparisonSearchesUseTheScalarPath) {
  const CharacterPtr character = makeTwoLegged();
  const Rig rig = someRig(*character);
  const Pose pose = clipPose(*character, 0.8f);
  const Surface newton = fresh(character, rig, pose);
  for (const ProjectionKind projection : {ProjectionKind::kBisection, ProjectionKind::kAnalytic}) {
    Smoother smoother(character, projection);
    ASSERT_TRUE(smoother.prepare(rig).ok());
    Smoother twin = smoother.twin();
    Surface surface, scalar;
    smoother.smooth(pose, surface);
    {
      const InstructionSetScope scope(InstructionSet::kScalar);
      twin.smooth(pose, scalar);
    }
    expectSame(surface, scalar, nameOf(projection));
    EXPECT_EQ(surface.report.projection, projection);
    EXPECT_FALSE(sameBytes(surface.positions, newton.positions)) << nameOf(projection);
  }
}

TEST(Smoother, OutputMemoryIsReusableAcrossDepthsAndCharacters) {
  const CharacterPtr body = makeTwoLegged();
  const CharacterPtr limb = makeLimb();
  Rig rig = someRig(*body);
  rig.smoothing.depth = 6;
  Surface surface = fresh(body, rig, clipPose(*body, 0.2f));
  Smoother smoother(limb);
  const Rig limbRig = someRig(*limb);
  ASSERT_TRUE(smoother.prepare(limbRig).ok());
  smoother.smooth(clipPose(*limb, 0.4f), surface);
  expectSame(surface, fresh(limb, limbRig, clipPose(*limb, 0.4f)), "reused output");
}

TEST(Smoother, EditThenUndoRestoresTheSurface) {
  const CharacterPtr character = makeLimb();
  for (const SurfaceMode mode : kModes) {
    const Rig rig = someRig(*character, mode);
    Smoother smoother(character);
    ASSERT_TRUE(smoother.prepare(rig).ok());
    const Pose pose = clipPose(*character, 1.1f);
    Surface before;
    smoother.smooth(pose, before);

    std::vector<Rig> edits(9, rig);
    edits[0].primitives[3].placement.center += glm::vec3(0.05f);
    edits[1].primitives.pop_back();
    edits[2].smoothing.depth = 7;
    edits[3].surface.iso = 0.4f;
    edits[4].surface.mode = mode == SurfaceMode::kSwell ? SurfaceMode::kReplace : SurfaceMode::kSwell;
    edits[5].links.clear();
    edits[6].primitives[0].territory = std::vector<std::string>{};
    edits[7].primitives.clear();
    edits[8].smoothing.patch = PatchKind::kPhong;
    for (std::size_t i = 0; i < edits.size(); ++i) {
      const std::string what = "edit " + std::to_string(i);
      Surface edited;
      ASSERT_TRUE(smoother.prepare(edits[i]).ok()) << what;
      smoother.smooth(pose, edited);
      expectSame(edited, fresh(character, edits[i], pose), what + " against a fresh smoother");
      ASSERT_TRUE(smoother.prepare(rig).ok()) << what;
      Surface undone;
      smoother.smooth(pose, undone);
      expectSame(before, undone, what + " undone");
    }
  }
}

TEST(Smoother, RefusedRigKeepsThePreviousOne) {
  const CharacterPtr character = makeLimb();
  const Rig rig = someRig(*character);
  Smoother smoother(character);
  ASSERT_TRUE(smoother.prepare(rig).ok());
  const Pose pose = clipPose(*character, 0.6f);
  Surface before;
  smoother.smooth(pose, before);
  std::vector<Rig> bad(7, rig);
  bad[0].primitives[1].placement.radii.y = 0.0f;
  bad[1].primitives[1].reach = 1.0f;
  bad[2].primitives[1].group = "nowhere";
  bad[3].smoothing.depth = 17;
  bad[4].surface.iso = std::numeric_limits<float>::quiet_NaN();
  bad[5].primitives[1].sign = 0;
  bad[6].links.push_back({"group 0", "nowhere"});
  for (std::size_t i = 0; i < bad.size(); ++i) {
    const auto outcome = smoother.prepare(bad[i]);
    ASSERT_FALSE(outcome.ok()) << i;
    EXPECT_FALSE(outcome.error().reason.empty()) << i;
    Surface after;
    smoother.smooth(pose, after);
    expectSame(before, after, "after refusal " + std::to_string(i));
  }
}

TEST(Smoother, TooManyCliquesAreRefused) {
  const CharacterPtr character = makeLimb();
  Rig rig;
  // 8 triples, all linked except within a triple: 3^8 = 6,561 maximal cliques.
  for (int i = 0; i < 24; ++i) rig.groups.push_back({"g" + std::to_string(i), {}});
  for (int i = 0; i < 24; ++i) {
    for (int j = 0; j < i; ++j) {
      if (i / 3 != j / 3) rig.links.push_back({"g" + std::to_string(i), "g" + std::to_string(j)});
    }
  }
  Smoother smoother(character);
  const auto outcome = smoother.prepare(rig);
  ASSERT_FALSE(outcome.ok());
  EXPECT_NE(outcome.error().reason.find("more than 4096 maximal sets"), std::string::npos) << outcome.error().text();
}

TEST(Smoother, UnattachedPrimitivesAreNamedAndHarmless) {
  const CharacterPtr character = makeLimb();
  const Rig rig = someRig(*character);
  Rig more = rig;
  Primitive stray = rig.primitives[0];
  stray.name = "stray";
  stray.bone = "a bone of somebody else";
  more.primitives.insert(more.primitives.begin() + 5, stray);
  Smoother smoother(character);
  ASSERT_TRUE(smoother.prepare(more).ok());
  EXPECT_EQ(smoother.unattached(), std::vector<int>{5});
  Surface surface;
  smoother.smooth(clipPose(*character, 0.9f), surface);
  EXPECT_EQ(surface.report.primitives, 12);
  expectSame(surface, fresh(character, rig, clipPose(*character, 0.9f)), "stray");
  ASSERT_TRUE(smoother.prepare(rig).ok());
  EXPECT_TRUE(smoother.unattached().empty());
}

TEST(Smoother, ReportCountsAreConsistent) {
  for (const CharacterPtr& character : {makeLimb(), makeTwoLegged(), makeStrip(), makeTube()}) {
    for (const SurfaceMode mode : kModes) {
      for (const int depth : {1, 2, 5, 16}) {
        Rig rig = someRig(*character, mode);
        rig.smoothing.depth = depth;
        const Surface surface = fresh(character, rig, clipPose(*character, 0.5f));
        const SmoothingReport& report = surface.report;
        const auto& mesh = character->mesh;
        const int v = static_cast<int>(mesh.positions.size());
        const int e = static_cast<int>(mesh.edges.size());
        const int t = static_cast<int>(mesh.triangles.size());
        EXPECT_EQ(report.mode, mode);
        EXPECT_EQ(report.depth, depth);
        EXPECT_EQ(report.controlTriangles, t);
        EXPECT_EQ(report.refinedTriangles, t * depth * depth);
        EXPECT_EQ(report.refinedVertices, v + e * (depth - 1) + t * (depth - 1) * (depth - 2) / 2);
        EXPECT_EQ(report.refinedVertices, static_cast<int>(surface.positions.size()));
        EXPECT_EQ(surface.normals.size(), surface.positions.size());
        EXPECT_EQ(surface.displacement.size(), surface.positions.size());
        EXPECT_EQ(surface.classes.size(), mesh.triangles.size());
        EXPECT_EQ(report.implicitTriangles + report.straddlingTriangles + report.normalTriangles, t);
        EXPECT_EQ(report.primitives, 12);
        EXPECT_GT(report.cliques, 0);
        EXPECT_GT(report.projected, 0);
        EXPECT_LE(report.unresolved, report.projected);
        EXPECT_TRUE(std::isfinite(report.residualMax));
        EXPECT_LT(report.residualMax, 0.02);
        EXPECT_GE(report.seconds.total(), 0.0);
        if (mode == SurfaceMode::kSwell) {
          EXPECT_EQ(report.unresolved, 0) << "swell always has a root";
        }
      }
    }
  }
}

TEST(Smoother, ClassesFollowOmega) {
  const CharacterPtr character = makeTwoLegged();
  Rig rig = someRig(*character, SurfaceMode::kReplace);
  for (Primitive& primitive : rig.primitives) primitive.placement.radii *= 1.6f;
  const Surface surface = fresh(character, rig, bindPose(character->skeleton));
  const oracle::Oracle oracle(*character, rig);
  int disagreements = 0;
  std::array<int, 3> seen{};
  for (std::size_t t = 0; t < character->mesh.triangles.size(); ++t) {
    double sum = 0.0;
    for (const int v : character->mesh.triangles[t].vertices) sum += oracle.omega(v);
    const TriangleClass expected = sum == 0.0   ? TriangleClass::kNormal
                                   : sum == 3.0 ? TriangleClass::kImplicit
                                                : TriangleClass::kStraddling;
    ++seen[static_cast<std::size_t>(expected)];
    if (surface.classes[t] != expected) ++disagreements;
  }
  EXPECT_LE(disagreements, static_cast<int>(surface.classes.size()) / 100);
  EXPECT_GT(seen[0], 0);
  EXPECT_GT(seen[1], 0);
  EXPECT_GT(seen[2], 0);
}

TEST(Smoother, DisplacementIsMeasuredAlongTheRiseDirection) {
  const CharacterPtr character = makeTwoLegged();
  const Rig rig = someRig(*character);
  Rig bare = rig;
  bare.primitives.clear();
  const Pose pose = clipPose(*character, 0.4f);
  const Surface surface = fresh(character, rig, pose);
  const Surface patch = fresh(character, bare, pose);
  oracle::Oracle oracle(*character, rig);
  oracle.pose(pose);
  int moved = 0;
  int turned = 0;
  int aside = 0;  // Moved out of a fold, along the skin.
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const oracle::Vec rise = oracle.riseAt(oracle::siteOf(character->mesh, *surface.refinement, static_cast<int>(v)));
    const oracle::Vec way = oracle::vec(surface.positions[v]) - oracle::vec(patch.positions[v]);
    const double along = static_cast<double>(surface.displacement[v]);
    EXPECT_NEAR(oracle::dot(way, rise), along, 1e-5 * static_cast<double>(character->height)) << v;
    aside += oracle::length(way - along * rise) > 1e-5 * static_cast<double>(character->height) ? 1 : 0;
    if (surface.displacement[v] == 0.0f) continue;
    ++moved;
    turned += oracle::dot(rise, oracle::vec(patch.normals[v])) < 0.99 ? 1 : 0;
  }
  EXPECT_LE(aside, surface.report.guarded);
  EXPECT_LT(aside, moved / 4);
  EXPECT_GT(moved, 0);
  EXPECT_GT(turned, 0) << "every direction is its normal: nothing was told apart";
}

TEST(Smoother, ReplaceDisplacementIsAlongThePatchNormal) {
  const CharacterPtr character = makeTwoLegged();
  const Rig rig = someRig(*character, SurfaceMode::kReplace);
  Rig bare = rig;
  bare.primitives.clear();
  const Pose pose = clipPose(*character, 0.4f);
  const Surface surface = fresh(character, rig, pose);
  const Surface patch = fresh(character, bare, pose);
  int moved = 0;
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const float expected = glm::dot(surface.positions[v] - patch.positions[v], patch.normals[v]);
    EXPECT_NEAR(surface.displacement[v], expected, 1e-5f * character->height) << v;
    if (surface.displacement[v] != 0.0f) ++moved;
  }
  EXPECT_GT(moved, 0);
}

// docs/design.md with numbers: T = 1/4, h = 0.08, a sphere of radius 0.3 whose center lies on a flat skin.
TEST(Smoother, SwellOverASphereMatchesTheFormula) {
  const CharacterPtr character = makeStrip();
  Rig rig;
  rig.groups.push_back({"a", {}});
  const glm::vec3 center(-0.125f, 1.0f, 0.0f);
  rig.primitives.push_back(ellipsoidAt(*character, "ball", "end", "a", center, glm::vec3(0.3f)));
  rig.primitives[0].territory = std::vector<std::string>{"root", "end"};
  const Surface surface = Projected(*character, rig).at(bindPose(character->skeleton));
  int risen = 0;
  for (const glm::vec3& p : surface.positions) {
    const double s = static_cast<double>(p.z);
    const double x = static_cast<double>(p.x) + 0.125;
    const double y = static_cast<double>(p.y) - 1.0;
    const double inside = std::max(0.0, 1.0 - (x * x + y * y + s * s) / 0.18);
    const double skinRadius = s * (1.0 - std::sqrt(0.5)) / 0.08 + std::sqrt(0.5);
    const double skin = skinRadius < 1.0 ? std::pow(1.0 - skinRadius * skinRadius, 2.0) : 0.0;
    if (x * x + y * y < 0.18) {
      EXPECT_NEAR(skin + inside * inside, 0.25, 2e-5) << p.x << ", " << p.y;
    } else {
      EXPECT_EQ(p.z, 0.0f);
    }
    if (p.z > 0.2f) ++risen;
  }
  EXPECT_GT(risen, 5);
}

// Under `replace` a surface's counts match the brute-force search.
TEST(Smoother, ReplaceCountsUnresolvedVertices) {
  const CharacterPtr character = makeTwoLegged();
  const Rig rig = someRig(*character, SurfaceMode::kReplace);
  const Pose pose = clipPose(*character, 1.3f);
  const Surface surface = fresh(character, rig, pose);
  oracle::Oracle oracle(*character, rig);
  oracle.pose(pose);
  int sought = 0;
  int unresolved = 0;
  for (int v = 0; v < static_cast<int>(surface.positions.size()); ++v) {
    const auto answer = oracle.evaluate(oracle::siteOf(character->mesh, *surface.refinement, v));
    sought += answer.sought ? 1 : 0;
    unresolved += answer.sought && !answer.resolved ? 1 : 0;
  }
  EXPECT_NEAR(surface.report.projected, sought, 0.02 * sought);
  EXPECT_NEAR(surface.report.unresolved, unresolved, 2 + 0.02 * unresolved);
  EXPECT_GT(sought, 0);
}

// A lone ellipsoid far bigger than the skin under it: swell must reach its visible surface or beyond, never stay below.
TEST(Smoother, SkinCoversALoneMuscle) {
  const CharacterPtr character = makeLimb();
  Rig rig;
  rig.groups.push_back({"a", {}});
  const glm::vec3 center(0.0f, 1.0f, 0.0f);
  rig.primitives.push_back(ellipsoidAt(*character, "ball", "middle", "a", center, glm::vec3(0.45f)));
  rig.smoothing.depth = 6;
  const Surface surface = fresh(character, rig, bindPose(character->skeleton));
  int covered = 0;
  for (const glm::vec3& p : surface.positions) {
    if (std::abs(p.y - 1.0f) > 0.1f) continue;
    EXPECT_GT(glm::distance(p, center), 0.45f - 1e-3f);
    EXPECT_LT(glm::distance(p, center), 0.45f * kDefaultReach);
    ++covered;
  }
  EXPECT_GT(covered, 50);
}

}  // namespace
}  // namespace sinew::test
