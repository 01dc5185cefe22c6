// tests/surface/identity_test.cpp: beyond every muscle's reach the surface is the patch; every depth is watertight.

#include <gtest/gtest.h>

#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/oracle/oracle.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/every_kind.h"
#include "tests/support/surface/mesh_checks.h"

namespace sinew::test {
namespace {

using CharacterPtr = std::shared_ptr<const Character>;

std::vector<CharacterPtr> characters() { return {makeLimb(), makeTwoLegged(), makeStrip(), makeTube()}; }

Pose bentPose(const Character& character) { return samplePose(character.skeleton, character.clips.front(), 0.7f); }

Surface surfaceOf(const CharacterPtr& character, const Rig& rig, const Pose& pose) {
  Smoother smoother(character);
  const auto prepared = smoother.prepare(rig);
  EXPECT_TRUE(prepared.ok()) << prepared.error().text();
  Surface out;
  if (prepared) smoother.smooth(pose, out);
  return out;
}

TEST(SurfaceIdentity, EmptyRigIsThePatchAtEveryDepth) {
  for (const CharacterPtr& character : characters()) {
    for (const PatchKind patch : {PatchKind::kPn, PatchKind::kPhong, PatchKind::kFlat}) {
      for (int depth = 1; depth <= kMaxDepth; ++depth) {
        Rig rig;
        rig.smoothing.depth = depth;
        rig.smoothing.patch = patch;
        oracle::Oracle oracle(*character, rig);
        const Pose pose = bentPose(*character);
        oracle.pose(pose);
        const Surface surface = surfaceOf(character, rig, pose);
        const double height = static_cast<double>(character->height);
        const int count = static_cast<int>(surface.positions.size());
        for (int v = 0; v<count; v += depth> 4 ? 7 : 1) {
          const auto answer = oracle.evaluate(oracle::siteOf(character->mesh, *surface.refinement, v));
          const auto i = static_cast<std::size_t>(v);
          ASSERT_LT(oracle::length(oracle::vec(surface.positions[i]) - answer.position), 1e-5 * height)
              << character->name << ", " << nameOf(patch) << ", depth " << depth << ", vertex " << v;
          ASSERT_LT(oracle::length(oracle::vec(surface.normals[i]) - answer.normal), 1e-3)
              << character->name << ", " << nameOf(patch) << ", depth " << depth << ", vertex " << v;
        }
      }
    }
  }
}

TEST(SurfaceIdentity, DepthOneIsTheSkinnedControlMesh) {
  for (const CharacterPtr& character : characters()) {
    for (const PatchKind patch : kEveryPatch) {
      Rig rig;
      rig.smoothing.depth = 1;
      rig.smoothing.patch = patch;
      const Surface surface = surfaceOf(character, rig, bindPose(character->skeleton));
      ASSERT_EQ(surface.positions.size(), character->mesh.positions.size());
      for (std::size_t v = 0; v < surface.positions.size(); ++v) {
        EXPECT_LT(glm::distance(surface.positions[v], character->mesh.positions[v]), 1e-5f * character->height);
        EXPECT_LT(glm::distance(surface.normals[v], character->mesh.normals[v]), 1e-4f);
      }
    }
  }
}

TEST(SurfaceIdentity, SkinOutOfReachIsThePatchBitForBit) {
  for (const CharacterPtr& character : characters()) {
    for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
      int outside = 0;
      int untouched = 0;
      int moved = 0;
      for (int depth = 1; depth <= kMaxDepth; ++depth) {
        RigRecipe recipe;
        recipe.primitives = 3;
        Rig rig = randomRig(*character, recipe, static_cast<std::uint64_t>(depth));
        rig.surface.mode = mode;
        rig.smoothing.depth = depth;
        Rig empty = rig;
        empty.primitives.clear();
        const Pose pose = bentPose(*character);
        const Surface with = surfaceOf(character, rig, pose);
        const Surface without = surfaceOf(character, empty, pose);
        oracle::Oracle oracle(*character, rig);
        oracle.pose(pose);
        // Normals change up to one edge away from a moved vertex.
        const std::vector<bool> reshaded =
            grown(with.refinement->triangles, movedBetween(with.positions, without.positions), 1);
        for (std::size_t v = 0; v<with.positions.size(); v += depth> 6 ? 5 : 1) {
          const auto site = oracle::siteOf(character->mesh, *with.refinement, static_cast<int>(v));
          const auto weights = oracle.weightsAt(site);
          double omega = 0.0;
          for (std::size_t i = 0; i < 3 && mode == SurfaceMode::kReplace; ++i) {
            omega += site.barycentric[i] * oracle.omega(site.vertices[i]);
          }
          const double nearest = oracle.field().nearest(oracle::vec(without.positions[v]), weights);
          const bool same = sameBits(with.positions[v], without.positions[v]);
          if (!same) ++moved;
          if (mode == SurfaceMode::kSwell ? nearest < 1.0 + 1e-4 : omega > 0.0) continue;
          ++outside;
          ASSERT_TRUE(same) << character->name << ", " << nameOf(mode) << ", depth " << depth << ", vertex " << v;
          if (reshaded[v]) continue;
          ++untouched;
          ASSERT_TRUE(sameBits(with.normals[v], without.normals[v]))
              << character->name << ", " << nameOf(mode) << ", depth " << depth << ", vertex " << v;
        }
      }
      EXPECT_GT(outside, 100) << character->name;
      EXPECT_GT(untouched, 100) << character->name;
      EXPECT_GT(moved, 0) << character->name << ": nothing moved, so nothing was shown";
    }
  }
}

TEST(SurfaceIdentity, EveryDepthKeepsTheTopology) {
  for (const CharacterPtr& character : characters()) {
    const EdgeCensus control = censusOf(trianglesOf(character->mesh));
    for (int depth = 1; depth <= kMaxDepth; ++depth) {
      Rig rig;
      rig.smoothing.depth = depth;
      const Surface surface = surfaceOf(character, rig, bindPose(character->skeleton));
      const EdgeCensus census = censusOf(surface.refinement->triangles);
      EXPECT_EQ(census.euler(), control.euler()) << character->name << " depth " << depth;
      EXPECT_EQ(census.triangles, control.triangles * depth * depth);
      EXPECT_EQ(census.borderEdges, control.borderEdges * depth);
      EXPECT_EQ(census.crowdedEdges, 0);
      EXPECT_EQ(census.inconsistentEdges, 0);
      EXPECT_EQ(census.vertices, static_cast<int>(surface.positions.size())) << "every vertex is used";
    }
  }
}

TEST(SurfaceIdentity, EveryPatchIsFiniteWithUnitNormals) {
  for (const CharacterPtr& character : characters()) {
    for (const PatchKind patch : kEveryPatch) {
      for (int depth = 1; depth <= kMaxDepth; depth += depth < 4 ? 1 : 4) {
        Rig rig;
        rig.smoothing.depth = depth;
        rig.smoothing.patch = patch;
        const Surface surface = surfaceOf(character, rig, bentPose(*character));
        EXPECT_TRUE(allFinite(surface.positions)) << nameOf(patch);
        EXPECT_TRUE(allFinite(surface.normals)) << nameOf(patch);
        EXPECT_TRUE(allUnit(surface.normals)) << character->name << ", " << nameOf(patch) << ", depth " << depth;
      }
    }
  }
}

/// Longest side of any triangle.
float longestSide(std::span<const glm::vec3> positions, std::span<const std::array<int, 3>> triangles) {
  float out = 0.0f;
  for (const auto& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = static_cast<std::size_t>(t[i]);
      const auto b = static_cast<std::size_t>(t[(i + 1) % 3]);
      out = std::max(out, glm::distance(positions[a], positions[b]));
    }
  }
  return out;
}

// Edge vertices are shared, so a patch that missed its edges would show as long thin triangles next to them.
TEST(SurfaceIdentity, PatchesMeetTheirEdges) {
  constexpr int kFinest = 16;
  for (const CharacterPtr& character : characters()) {
    for (const PatchKind patch : kEveryPatch) {
      Rig rig;
      rig.smoothing.depth = kFinest;
      rig.smoothing.patch = patch;
      const Surface surface = surfaceOf(character, rig, bindPose(character->skeleton));
      const float control = longestSide(character->mesh.positions, trianglesOf(character->mesh));
      const float refined = longestSide(surface.positions, surface.refinement->triangles);
      EXPECT_LT(refined, 2.0f * control / kFinest) << character->name << ", " << nameOf(patch);
    }
  }
}

// Adjacent refined triangles must not fold: in the bind pose a patch's small triangles face along their corners'
// normals.
TEST(SurfaceIdentity, SmallTrianglesFaceOutwards) {
  for (const CharacterPtr& character : characters()) {
    for (const PatchKind patch : kEveryPatch) {
      Rig rig;
      rig.smoothing.depth = 5;
      rig.smoothing.patch = patch;
      const Surface surface = surfaceOf(character, rig, bindPose(character->skeleton));
      int inwards = 0;
      for (const auto& t : surface.refinement->triangles) {
        const auto at = [&](std::size_t i) { return surface.positions[static_cast<std::size_t>(t[i])]; };
        const glm::vec3 face = glm::cross(at(1) - at(0), at(2) - at(0));
        if (glm::dot(face, surface.normals[static_cast<std::size_t>(t[0])]) < 0.0f) ++inwards;
      }
      EXPECT_EQ(inwards, 0) << character->name << ", " << nameOf(patch);
    }
  }
}

// There are several definitions of a spherigon; all of them put a sphere's points on the sphere.
TEST(SurfaceIdentity, SpherigonBulgesLikeASphere) {
  const CharacterPtr character = makeLimb();
  Rig rig;
  rig.smoothing.depth = 6;
  const auto deviation = [&](PatchKind patch) {
    rig.smoothing.patch = patch;
    const Surface surface = surfaceOf(character, rig, bindPose(character->skeleton));
    float worst = 0.0f;
    for (const glm::vec3& p : surface.positions) {
      const glm::vec3 axis(0.0f, glm::clamp(p.y, 0.3f, 1.7f), 0.0f);
      worst = std::max(worst, std::abs(glm::distance(p, axis) - 0.3f));
    }
    return worst;
  };
  EXPECT_LT(deviation(PatchKind::kSpherigon), 0.4f * deviation(PatchKind::kFlat));
}

}  // namespace
}  // namespace sinew::test
