// tests/surface/face_culling_test.cpp: skin at triangles that face away stays on the patch; other skin is unaffected.

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/character/skinning.h"
#include "core/geometry/at.h"
#include "sinew/surface/smoother.h"
#include "tests/support/rigs/trial_scenes.h"
#include "tests/support/surface/eyes.h"

namespace sinew::test {
namespace {

/// [T] whether all three vertex normals of a triangle point away from the eye.
std::vector<bool> backTriangles(const Character& character, const Pose& pose, const glm::vec3& eye) {
  SkinnedMesh skinned;
  skin(character, pose, skinned);
  std::vector<bool> back;
  for (const ControlTriangle& triangle : character.mesh.triangles) {
    int away = 0;
    for (const int v : triangle.vertices) {
      away += glm::dot(at(skinned.normals, v), at(skinned.positions, v) - eye) > 0.0f ? 1 : 0;
    }
    back.push_back(away == 3);
  }
  return back;
}

/// [V'] whether a refined vertex belongs to some triangle that is not culled.
std::vector<bool> seenVertices(const Refinement& refinement, const std::vector<bool>& back) {
  std::vector<bool> seen(toIndex(refinement.vertexCount), false);
  for (std::size_t i = 0; i < refinement.triangles.size(); ++i) {
    if (back[toIndex(refinement.controlOf[i])]) continue;
    for (const int v : refinement.triangles[i]) seen[toIndex(v)] = true;
  }
  return seen;
}

// Wrapped surfaces are not finished after projection, so that no vertex depends on its neighbors.
TEST(FaceCulling, KeepsSkinThatFacesAwayOnThePatchAndTheRestUnchanged) {
  const TrialScene& scene = trialScene("wrapped");
  Smoother smoother(scene.character);
  ASSERT_TRUE(smoother.prepare(withMode(scene.rig, SurfaceMode::kReplace)).ok());
  Surface whole, culled;
  for (const Pose& pose : spreadPoses(*scene.character, 2)) {
    ASSERT_TRUE(smoother.smooth(pose, whole));
    int kept = 0, moved = 0;
    for (const glm::vec3& eye : eyesAround(boundsOf(whole.positions), 6)) {
      ASSERT_TRUE(smoother.smooth(pose, culled, eye));
      const std::vector<bool> back = backTriangles(*scene.character, pose, eye);
      EXPECT_EQ(culled.report.culledTriangles, std::ranges::count(back, true));
      const std::vector<bool> seen = seenVertices(*whole.refinement, back);
      for (std::size_t v = 0; v < seen.size(); ++v) {
        if (seen[v]) {
          EXPECT_EQ(culled.positions[v], whole.positions[v]) << v;
          EXPECT_EQ(culled.normals[v], whole.normals[v]) << v;
          moved += whole.displacement[v] != 0.0f ? 1 : 0;
        } else {
          EXPECT_EQ(culled.displacement[v], 0.0f) << v;
          kept += whole.displacement[v] != 0.0f ? 1 : 0;
        }
      }
    }
    EXPECT_GT(kept, 0);
    EXPECT_GT(moved, 0);
  }
}

TEST(FaceCulling, CullsAboutHalfFromFarAway) {
  const TrialScene& scene = trialScene("tangle");
  Smoother smoother(scene.character);
  ASSERT_TRUE(smoother.prepare(Rig{}).ok());
  Surface surface;
  const Bounds bounds = boundsOf(scene.character->mesh.positions);
  for (const glm::vec3& direction : spreadDirections(12)) {
    smoother.smooth(bindPose(scene.character->skeleton), surface, bounds.center() + 1e5f * direction);
    const double share = surface.report.culledTriangles / static_cast<double>(scene.character->mesh.triangles.size());
    EXPECT_GT(share, 0.2);
    EXPECT_LT(share, 0.6);
  }
}

TEST(FaceCulling, NothingIsCulledWithoutAnEye) {
  const TrialScene& scene = trialScene("tangle");
  Smoother smoother(scene.character);
  ASSERT_TRUE(smoother.prepare(Rig{}).ok());
  Surface surface;
  const Pose pose = bindPose(scene.character->skeleton);
  smoother.smooth(pose, surface, glm::vec3(0.0f, 0.0f, 100.0f));
  EXPECT_GT(surface.report.culledTriangles, 0);
  smoother.smooth(pose, surface);
  EXPECT_EQ(surface.report.culledTriangles, 0);
}

}  // namespace
}  // namespace sinew::test
