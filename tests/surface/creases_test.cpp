// tests/surface/creases_test.cpp: shading normals at creases; the geometry is unaffected.

#include "core/geometry/normals.h"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/every_kind.h"
#include "tests/support/surface/mesh_checks.h"

namespace sinew::test {
namespace {

using CharacterPtr = std::shared_ptr<const Character>;

Surface smoothed(const CharacterPtr& character, const Rig& rig, const Pose& pose) {
  Smoother smoother(character);
  const auto prepared = smoother.prepare(rig);
  EXPECT_TRUE(prepared.ok()) << prepared.error().text();
  Surface surface;
  if (prepared) smoother.smooth(pose, surface);
  return surface;
}

Rig creasedRig(Rig rig, float degrees) {
  rig.smoothing.creaseAngle = degrees;
  return rig;
}

void expectSameGeometry(const Surface& a, const Surface& b, const std::string& what) {
  EXPECT_TRUE(sameBytes(a.positions, b.positions)) << what;
  EXPECT_TRUE(sameBytes(a.normals, b.normals)) << what;
  EXPECT_EQ(a.displacement, b.displacement) << what;
  EXPECT_EQ(a.classes, b.classes) << what;
  EXPECT_EQ(a.refinement->triangles, b.refinement->triangles) << what;
}

std::vector<glm::vec3> shadingNormals(const Surface& surface) {
  std::vector<glm::vec3> normals;
  for (std::size_t d = 0; d < surface.refinement->drawVertex.size(); ++d) normals.push_back(shadingNormal(surface, d));
  return normals;
}

glm::vec3 controlFaceNormal(const ControlMesh& mesh, std::size_t triangle) {
  const auto [a, b, c] = mesh.triangles[triangle].vertices;
  const glm::vec3 p = mesh.positions[static_cast<std::size_t>(a)];
  return glm::normalize(
      glm::cross(mesh.positions[static_cast<std::size_t>(b)] - p, mesh.positions[static_cast<std::size_t>(c)] - p));
}

TEST(ShadingCreases, CubeFacesAreFlatAtEveryDepthWithUnchangedShape) {
  const CharacterPtr cube = makeCube();
  for (const PatchKind patch : kEveryPatch) {
    for (int depth = 1; depth <= kMaxDepth; ++depth) {
      Rig rig;
      rig.smoothing.depth = depth;
      rig.smoothing.patch = patch;
      const std::string what = std::string(nameOf(patch)) + ", depth " + std::to_string(depth);
      const Pose pose = bindPose(cube->skeleton);
      const Surface smooth = smoothed(cube, rig, pose);
      const Surface sharp = smoothed(cube, creasedRig(rig, 30.0f), pose);
      expectSameGeometry(smooth, sharp, what);
      EXPECT_TRUE(smooth.shadingNormals.empty());
      EXPECT_TRUE(isClosed(sharp.refinement->triangles)) << what;
      ASSERT_EQ(sharp.shadingNormals.size(), sharp.refinement->drawVertex.size());
      const auto perFace = static_cast<std::size_t>(depth * depth);
      for (std::size_t t = 0; t < sharp.refinement->drawTriangles.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
          const std::uint32_t drawn = sharp.refinement->drawTriangles[t][i];
          ASSERT_EQ(sharp.refinement->drawVertex[drawn], sharp.refinement->triangles[t][i]);
          const glm::vec3 face = controlFaceNormal(cube->mesh, t / perFace);
          ASSERT_LT(glm::distance(shadingNormal(sharp, drawn), face), 1e-5f) << what;
        }
      }
    }
  }
}

TEST(ShadingCreases, AngleWithoutCreasesChangesNothing) {
  for (const CharacterPtr& character : {makeLimb(), makeTwoLegged(), makeTube()}) {
    const Rig rig = randomRig(*character, {}, 3);
    const Pose pose = samplePose(character->skeleton, character->clips.front(), 0.7f);
    const Surface before = smoothed(character, rig, pose);
    const Surface after = smoothed(character, creasedRig(rig, 179.0f), pose);
    expectSameGeometry(before, after, character->name);
    EXPECT_TRUE(after.shadingNormals.empty()) << character->name;
    EXPECT_EQ(before.refinement->drawVertex, after.refinement->drawVertex);
    EXPECT_EQ(before.refinement->drawUv, after.refinement->drawUv);
    EXPECT_EQ(before.refinement->drawTriangles, after.refinement->drawTriangles);
    const std::vector<glm::vec3> shading = shadingNormals(before);
    for (std::size_t d = 0; d < shading.size(); ++d) {
      ASSERT_TRUE(sameBits(shading[d], before.normals[static_cast<std::size_t>(before.refinement->drawVertex[d])]));
    }
  }
}

TEST(ShadingCreases, CreasesFollowThePose) {
  const CharacterPtr cube = makeCube();
  Rig rig;
  rig.smoothing.creaseAngle = 30.0f;
  rig.smoothing.depth = 4;
  const Surface rest = smoothed(cube, rig, bindPose(cube->skeleton));
  Pose turned = bindPose(cube->skeleton);
  const glm::mat4 turn = glm::mat4_cast(glm::angleAxis(1.1f, glm::normalize(glm::vec3(1, 2, 3))));
  for (glm::mat4& bone : turned.boneInWorld) bone = turn * bone;
  const Surface moved = smoothed(cube, rig, turned);
  for (std::size_t d = 0; d < rest.shadingNormals.size(); ++d) {
    ASSERT_LT(glm::distance(moved.shadingNormals[d], glm::mat3(turn) * rest.shadingNormals[d]), 1e-5f);
  }

  // Bent: the lower four corners stay with their bone, the upper four rotate with theirs, face normals included.
  const Pose bent = samplePose(cube->skeleton, cube->clips.front(), 0.5f);
  const Surface sheared = smoothed(cube, rig, bent);
  const ControlMesh mesh = creased(cube->mesh, 30.0f);
  for (std::size_t w = 0; w < mesh.wedges.size(); ++w) {
    const bool upper = mesh.positions[static_cast<std::size_t>(mesh.wedges[w].vertex)].y > 0.5f;
    const glm::mat3 bone(bent.boneInWorld[upper ? 1 : 0]);
    ASSERT_LT(glm::distance(sheared.shadingNormals[w], bone * mesh.wedges[w].normal), 1e-5f) << w;
  }
}

TEST(ShadingCreases, MuscleIsVisibleOnACreasedFace) {
  const CharacterPtr cube = makeCube();
  Rig rig;
  rig.smoothing.depth = 8;
  rig.smoothing.creaseAngle = 30.0f;
  rig.smoothing.patch = PatchKind::kFlat;  // So that the patch's normal differs from the face's near the corners only.
  rig.groups.push_back({"g", {}});
  rig.primitives.push_back(ellipsoidAt(*cube, "bump", "root", "g", {0.5f, 0.5f, 1.0f}, glm::vec3(0.2f)));
  rig.primitives[0].territory = std::vector<std::string>{"root", "end"};
  const Pose pose = bindPose(cube->skeleton);
  const Surface surface = smoothed(cube, rig, pose);
  Rig bare = rig;
  bare.primitives.clear();
  const Surface patch = smoothed(cube, bare, pose);
  std::size_t tilted = 0;
  for (std::size_t d = 0; d < surface.shadingNormals.size(); ++d) {
    const auto v = static_cast<std::size_t>(surface.refinement->drawVertex[d]);
    const glm::vec3 expected = glm::normalize(surface.normals[v] + (patch.shadingNormals[d] - patch.normals[v]));
    ASSERT_LT(glm::distance(surface.shadingNormals[d], expected), 1e-5f);
    if (surface.displacement[v] == 0.0f && sameBits(surface.normals[v], patch.normals[v])) {
      ASSERT_TRUE(sameBits(surface.shadingNormals[d], patch.shadingNormals[d]));
    } else if (glm::distance(surface.shadingNormals[d], patch.shadingNormals[d]) > 0.1f) {
      ++tilted;
    }
  }
  EXPECT_GT(tilted, 10u);
}

TEST(ShadingCreases, SmoothEdgesShowNoSeamBetweenCreasedWedges) {
  // The tube's caps are creased and its seam is not: along the seam, both sides have the same normals.
  const CharacterPtr tube = makeTube();
  Rig rig = randomRig(*tube, {}, 8);
  rig.smoothing.depth = 5;
  rig.smoothing.creaseAngle = 70.0f;
  const Surface surface = smoothed(tube, rig, samplePose(tube->skeleton, tube->clips.front(), 0.6f));
  ASSERT_FALSE(surface.shadingNormals.empty());
  const ControlMesh mesh = creased(tube->mesh, 70.0f);
  int compared = 0;
  for (const DrawnRun& a : surface.refinement->drawRuns) {
    for (const DrawnRun& b : surface.refinement->drawRuns) {
      if (a.edge != b.edge || a.first >= b.first) continue;
      const auto sameEnd = [&](std::size_t end) {
        const Wedge& p = mesh.wedges[static_cast<std::size_t>(a.wedges[end])];
        const Wedge& q = mesh.wedges[static_cast<std::size_t>(b.wedges[end])];
        return p.creased == q.creased && (!p.creased || p.normal == q.normal);
      };
      if (!sameEnd(0) || !sameEnd(1)) continue;
      for (int step = 0; step < surface.refinement->edgeVertices(a.edge); ++step) {
        ASSERT_TRUE(sameBits(shadingNormal(surface, static_cast<std::size_t>(a.first + step)),
                             shadingNormal(surface, static_cast<std::size_t>(b.first + step))));
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 20);
}

TEST(ShadingCreases, AngleChangeMatchesAFreshSmoother) {
  const CharacterPtr character = makeTube();
  const Rig rig = randomRig(*character, {}, 5);
  const Pose pose = samplePose(character->skeleton, character->clips.front(), 1.3f);
  Smoother smoother(character);
  Surface surface;
  for (const float degrees : {180.0f, 20.0f, 70.0f, 20.0f, 179.5f, 0.0f, 0.0f, 180.0f}) {
    for (const int depth : {2, 3}) {
      Rig edited = creasedRig(rig, degrees);
      edited.smoothing.depth = depth;
      ASSERT_TRUE(smoother.prepare(edited).ok());
      smoother.smooth(pose, surface);
      const Surface fresh = smoothed(character, edited, pose);
      const std::string what = std::to_string(degrees);
      expectSameGeometry(surface, fresh, what);
      EXPECT_TRUE(sameBytes(surface.shadingNormals, fresh.shadingNormals)) << what;
      EXPECT_EQ(surface.refinement->drawTriangles, fresh.refinement->drawTriangles) << what;
    }
  }
  // An edit that does not affect creases keeps the tables, so that nothing is uploaded again.
  Rig edited = creasedRig(rig, 20.0f);
  ASSERT_TRUE(smoother.prepare(edited).ok());
  smoother.smooth(pose, surface);
  const auto before = surface.refinement;
  edited.primitives.pop_back();
  ASSERT_TRUE(smoother.prepare(edited).ok());
  smoother.smooth(pose, surface);
  EXPECT_EQ(before, surface.refinement);
}

TEST(ShadingCreases, RandomRigsAndPosesGiveUnitNormalsAndUntouchedGeometry) {
  for (const CharacterPtr& character : {makeCube(), makeTwoLegged(), makeTube(), makeStrip()}) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      RigRecipe recipe;
      recipe.carveChance = 0.3f;
      Rig rig = randomRig(*character, recipe, seed);
      rig.surface.mode = seed % 2 == 0 ? SurfaceMode::kSwell : SurfaceMode::kReplace;
      rig.smoothing.patch = kEveryPatch[seed % 4];
      rig.smoothing.depth = 1 + static_cast<int>(seed);
      const Pose pose = randomPose(character->skeleton, 1.5f, 0.4f, seed);
      const std::string what = character->name + ", seed " + std::to_string(seed);
      const Surface smooth = smoothed(character, rig, pose);
      for (const float degrees : {0.0f, 25.0f}) {
        const Surface sharp = smoothed(character, creasedRig(rig, degrees), pose);
        expectSameGeometry(smooth, sharp, what);
        EXPECT_TRUE(allFinite(sharp.shadingNormals)) << what;
        EXPECT_TRUE(allUnit(sharp.shadingNormals)) << what;
      }
    }
  }
}

}  // namespace
}  // namespace sinew::test
