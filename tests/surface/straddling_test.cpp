// tests/surface/straddling_test.cpp: triangle classes of the wrapped body, and the paper's blend on straddling
// triangles.

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/character/skinning.h"
#include "core/rig/attachment.h"
#include "core/surface/patches/patch.h"
#include "core/surface/projection/replace.h"
#include "sinew/surface/smoother.h"
#include "tests/support/oracle/oracle.h"
#include "tests/support/rigs/trial_scenes.h"

namespace sinew::test {
namespace {

/// Bone with the largest weight on a control vertex.
std::string boneOf(const Character& character, int vertex) {
  const auto influences = character.mesh.influencesOf(vertex);
  const Influence strongest = *std::ranges::max_element(influences, {}, &Influence::weight);
  return character.skeleton
      .bones[static_cast<std::size_t>(character.skeleton.bindings[static_cast<std::size_t>(strongest.binding)].bone)]
      .name;
}

Surface smoothed(const TrialScene& scene, const Rig& rig, const Pose& pose) {
  Smoother smoother(scene.character);
  EXPECT_TRUE(smoother.prepare(rig).ok());
  Surface out;
  smoother.smooth(pose, out);
  return out;
}

TEST(Straddling, WrappedBodyHasAllThreeClasses) {
  const TrialScene& scene = trialScene("wrapped");
  ASSERT_EQ(scene.rig.surface.mode, SurfaceMode::kReplace);
  const Surface surface = smoothed(scene, scene.rig, bindPose(scene.character->skeleton));
  std::array<int, 3> seen{};
  for (std::size_t t = 0; t < surface.classes.size(); ++t) {
    ++seen[static_cast<std::size_t>(surface.classes[t])];
    for (const int v : scene.character->mesh.triangles[t].vertices) {
      const std::string bone = boneOf(*scene.character, v);
      if (bone == "belly" || bone == "pelvis" || bone.starts_with("thigh")) {
        EXPECT_NE(surface.classes[t], TriangleClass::kNormal) << "triangle " << t << " on " << bone;
      }
    }
  }
  std::printf("  normal %d, straddling %d, implicit %d\n", seen[0], seen[1], seen[2]);
  EXPECT_GT(seen[0], 20);
  EXPECT_GT(seen[1], 20);
  EXPECT_GT(seen[2], 200);
}

// Where a vertex of an implicit triangle stays on its patch, brute force does not find the surface either: in the
// armpits of the moving body the ray runs along the arm, beyond the search length.
TEST(Straddling, ImplicitTrianglesOfTheWrappedBodyFindTheSurface) {
  const TrialScene& scene = trialScene("wrapped");
  Rig empty = scene.rig;
  empty.primitives.clear();
  oracle::Oracle oracle(*scene.character, scene.rig);
  for (const Pose& pose : spreadPoses(*scene.character, 6)) {
    const Surface surface = smoothed(scene, scene.rig, pose);
    const Surface patch = smoothed(scene, empty, pose);
    std::set<int> left;
    int vertices = 0;
    for (std::size_t i = 0; i < surface.refinement->triangles.size(); ++i) {
      if (surface.classes[static_cast<std::size_t>(surface.refinement->controlOf[i])] != TriangleClass::kImplicit)
        continue;
      for (const int v : surface.refinement->triangles[i]) {
        ++vertices;
        if (surface.positions[static_cast<std::size_t>(v)] == patch.positions[static_cast<std::size_t>(v)])
          left.insert(v);
      }
    }
    std::printf("  %zu left on their patch on implicit triangles, %d unresolved in all\n", left.size(),
                surface.report.unresolved);
    EXPECT_GT(vertices, 1000);
    oracle.pose(pose);
    for (const int v : left) {
      const auto site = oracle::siteOf(scene.character->mesh, *surface.refinement, v);
      const oracle::Answer answer = oracle.evaluate(site);
      EXPECT_TRUE(!answer.resolved || answer.weight == 0.0) << "vertex " << v << " has a way to the surface";
    }
  }
}

/// Barycentric omega of every refined vertex from the brute-force solver's at the control vertices.
std::vector<double> omegas(const TrialScene& scene, const Rig& rig, const Refinement& refinement) {
  const oracle::Oracle oracle(*scene.character, rig);
  std::vector<double> out;
  for (int v = 0; v < refinement.vertexCount; ++v) {
    const oracle::Site site = oracle::siteOf(scene.character->mesh, refinement, v);
    double omega = 0.0;
    for (std::size_t i = 0; i < 3; ++i) omega += site.barycentric[i] * oracle.omega(site.vertices[i]);
    out.push_back(omega);
  }
  return out;
}

/// Pure projections: every control vertex counts as implicit.
Surface projectedAlone(const TrialScene& scene, const Rig& rig, const Pose& pose, const Surface& patch) {
  const Character& character = *scene.character;
  const Attachment attachment = attach(rig, character).value();
  const CandidateLists lists = makeCandidateLists(character.mesh, attachment);
  std::vector<PosedPrimitive> posed;
  poseField(attachment.primitives, pose.boneInWorld, 0.0f, posed);
  Rig flatRig = rig;
  flatRig.primitives.clear();
  flatRig.smoothing.patch = PatchKind::kFlat;
  const Surface bindFlat = smoothed(scene, flatRig, bindPose(character.skeleton));
  const Surface flat = smoothed(scene, flatRig, pose);
  std::vector<glm::vec3> anchors;
  poseAnchors(findAnchors(character.skeleton, bindFlat.positions), pose, anchors);
  Surface out = patch;
  const ImplicitWeights weights{std::vector<float>(character.mesh.positions.size(), 1.0f), true, 0};
  const ReplaceSettings settings{rig.surface.iso, 0.2f * character.height, ProjectionKind::kNewton,
                                 1e-6 * static_cast<double>(character.height)};
  ProjectionScratch scratch;
  replace(character.mesh, {posed, &lists}, settings, {flat.positions, flat.normals, anchors}, weights, out, scratch);
  return out;
}

// p' = omega p_implicit + (1 - omega) p_normal, and the normals likewise.
TEST(Straddling, PositionsMatchThePapersBlend) {
  const TrialScene& scene = trialScene("wrapped");
  const float height = scene.character->height;
  const Rig rig = withMode(scene.rig, SurfaceMode::kReplace);
  Rig empty = rig;
  empty.primitives.clear();
  int between = 0;
  for (const Pose& pose : spreadPoses(*scene.character, 3)) {
    const Surface mixed = smoothed(scene, rig, pose);
    const Surface patch = smoothed(scene, empty, pose);
    const Surface implicit = projectedAlone(scene, rig, pose, patch);
    const std::vector<double> omega = omegas(scene, rig, *mixed.refinement);
    for (std::size_t v = 0; v < omega.size(); ++v) {
      const auto w = static_cast<float>(omega[v]);
      const glm::vec3 expected = w * implicit.positions[v] + (1.0f - w) * patch.positions[v];
      ASSERT_LT(glm::distance(mixed.positions[v], expected), 1e-5f * height) << "vertex " << v;
      const bool told = glm::distance(implicit.positions[v], patch.positions[v]) > 1e-3f * height;
      between += told && w > 0.01f && w < 0.99f ? 1 : 0;
    }
  }
  std::printf("  %d mixed vertices\n", between);
  EXPECT_GT(between, 100);
}

}  // namespace
}  // namespace sinew::test
