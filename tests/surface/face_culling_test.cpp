// tests/surface/face_culling_test.cpp: triangles culled for an eye face away from it; all others are unaffected.

#include "core/surface/face_culling.h"

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/rig/mesh_layers.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/dressed_humanoid.h"
#include "tests/support/rigs/trial_scenes.h"
#include "tests/support/surface/eyes.h"

namespace sinew::test {
namespace {

/// Sums over all eyes of one scene and mode.
struct Tally {
  long long eyes = 0;
  long long triangles = 0;
  long long culled = 0;
  long long small = 0;    ///< Refined triangles of culled control triangles.
  long long towards = 0;  ///< Those that face the eye on the complete surface.
  long long changed = 0;  ///< Drawn vertices that differ from the complete surface's in any bit.
};

bool facesEye(const Surface& surface, const std::array<int, 3>& triangle, const glm::vec3& eye) {
  const auto at = [&](std::size_t i) { return glm::dvec3(surface.positions[static_cast<std::size_t>(triangle[i])]); };
  const glm::dvec3 a = at(0);
  return glm::dot(glm::cross(at(1) - a, at(2) - a), a - glm::dvec3(eye)) < 0.0;
}

void compare(const Surface& whole, const Surface& culled, const glm::vec3& eye, Tally& tally) {
  const Refinement& refinement = *whole.refinement;
  for (std::size_t i = 0; i < refinement.triangles.size(); ++i) {
    const std::array<int, 3>& triangle = refinement.triangles[i];
    if (culled.culled[static_cast<std::size_t>(refinement.controlOf[i])] != 0) {
      ++tally.small;
      if (facesEye(whole, triangle, eye)) ++tally.towards;
      continue;
    }
    for (const int vertex : triangle) {
      const auto v = static_cast<std::size_t>(vertex);
      if (whole.positions[v] != culled.positions[v] || whole.normals[v] != culled.normals[v] ||
          whole.displacement[v] != culled.displacement[v]) {
        ++tally.changed;
      }
    }
    if (whole.shadingNormals.empty()) continue;
    for (const std::uint32_t drawn : refinement.drawTriangles[i]) {
      if (whole.shadingNormals[drawn] != culled.shadingNormals[drawn]) ++tally.changed;
    }
  }
}

Tally tallyOf(const TrialScene& scene, const Rig& rig) {
  Tally tally;
  Smoother smoother(scene.character);
  const auto prepared = smoother.prepare(rig);
  EXPECT_TRUE(prepared.ok());
  if (!prepared) return tally;
  Surface whole, culled;
  for (const Pose& pose : spreadPoses(*scene.character, 1)) {
    smoother.smooth(pose, whole);
    EXPECT_TRUE(whole.culled.empty());
    EXPECT_EQ(whole.report.culledTriangles, 0);
    for (const glm::vec3& eye : eyesAround(boundsOf(whole.positions), 12)) {
      smoother.smooth(pose, culled, eye);
      EXPECT_EQ(culled.culled.size(), scene.character->mesh.triangles.size());
      tally.culled += culled.report.culledTriangles;
      tally.triangles += static_cast<long long>(culled.culled.size());
      ++tally.eyes;
      compare(whole, culled, eye, tally);
      EXPECT_TRUE(whole.positions == culled.positions) << scene.name << ": a shadow would differ";
    }
  }
  return tally;
}

TEST(FaceCulling, CullsOnlyBackFacesAndLeavesTheRestUnchanged) {
  std::printf("  %-11s %-8s %6s %8s %12s %10s %8s\n", "scene", "mode", "eyes", "culled", "refined", "towards",
              "changed");
  for (const TrialScene& trial : trialScenes()) {
    const TrialScene scene = oneSided(trial);
    for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
      Rig rig = withMode(scene.rig, mode);
      rig.smoothing.creaseAngle = mode == SurfaceMode::kSwell ? 40.0f : kDefaultCreaseAngle;
      const Tally tally = tallyOf(scene, rig);
      std::printf("  %-11s %-8s %6lld %7.1f%% %12lld %10lld %8lld\n", scene.name.c_str(), nameOf(mode), tally.eyes,
                  100.0 * static_cast<double>(tally.culled) / static_cast<double>(tally.triangles), tally.small,
                  tally.towards, tally.changed);
      const std::string what = scene.name + ", " + nameOf(mode);
      EXPECT_EQ(tally.towards, 0) << what;
      EXPECT_EQ(tally.changed, 0) << what;
      EXPECT_GT(static_cast<double>(tally.culled), leastCulled(scene) * static_cast<double>(tally.triangles)) << what;
    }
  }
}

TEST(FaceCulling, DoubleSidedMaterialsAreNeverCulled) {
  TrialScene scene = oneSided(trialScene("tangle"));
  auto character = std::make_shared<Character>(*scene.character);
  for (Material& material : character->materials) material.doubleSided = true;
  Smoother smoother(character);
  ASSERT_TRUE(smoother.prepare(Rig{}).ok());
  Surface surface;
  const Pose pose = bindPose(character->skeleton);
  for (const glm::vec3& eye : eyesAround(boundsOf(character->mesh.positions), 6)) {
    smoother.smooth(pose, surface, eye);
    EXPECT_EQ(surface.report.culledTriangles, 0);
  }
}

TEST(FaceCulling, CullsAboutHalfFromFarAwayWithoutMuscles) {
  const TrialScene scene = oneSided(trialScene("tangle"));
  Smoother smoother(scene.character);
  ASSERT_TRUE(smoother.prepare(Rig{}).ok());
  Surface surface;
  const Bounds bounds = boundsOf(scene.character->mesh.positions);
  for (const glm::vec3& direction : spreadDirections(12)) {
    smoother.smooth(bindPose(scene.character->skeleton), surface, bounds.center() + 1e5f * direction);
    const double share = surface.report.culledTriangles / static_cast<double>(surface.culled.size());
    EXPECT_GT(share, 0.3);
    EXPECT_LT(share, 0.6);
  }
}

TEST(FaceCulling, ClothIsNeverSkipped) {
  TrialScene scene = oneSided({"dressed", dressedHumanoid(), Rig{}});
  Smoother smoother(scene.character);
  Rig rig;
  rig.smoothing.depth = 2;
  ASSERT_TRUE(smoother.prepare(rig).ok());
  Surface surface;
  smoother.smooth(bindPose(scene.character->skeleton), surface, glm::vec3(0.0f, 1.0f, 30.0f));
  EXPECT_GT(surface.report.culledTriangles, 0);
  const std::vector<SkinLayer> layers = guessLayers(*scene.character);
  for (std::size_t t = 0; t < surface.culled.size(); ++t) {
    const SkinLayer layer = at(layers, scene.character->mesh.triangles[t].part);
    EXPECT_FALSE(layer == SkinLayer::kCloth && surface.culled[t] != 0) << t;
  }
}

}  // namespace
}  // namespace sinew::test
