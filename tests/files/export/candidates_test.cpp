// tests/files/export/candidates_test.cpp: joints that the fit may use.

#include "core/files/fit/joint_fit.h"

#include <algorithm>
#include <set>

#include "core/files/fit/weight_fit.h"
#include "sinew/surface/refinement.h"
#include "tests/files/export/export_scenes.h"

namespace sinew::exporting {
namespace {

TEST(Candidates, StartWithTheVertexsOwnAndAreUnique) {
  for (const char* name : {"humanoid-flex", "horse"}) {
    const test::ExportScene scene = test::bundledScene(name);
    const Refinement refinement = refine(scene.character->mesh, 2);
    const auto own = interpolatedWeights(scene.character->mesh, refinement);
    const auto candidates = weightCandidates(*scene.character, scene.rig, refinement, own);
    ASSERT_TRUE(candidates.ok());
    ASSERT_EQ(candidates->size(), own.size());
    for (std::size_t v = 0; v < own.size(); ++v) {
      const std::vector<int>& list = candidates.value()[v];
      EXPECT_LE(list.size(), kMostCandidates);
      EXPECT_EQ(std::set<int>(list.begin(), list.end()).size(), list.size());
      const FourWeights four = fourLargest(own[v]);
      for (std::size_t i = 0; i < kMostWeights && four.binding[i] >= 0; ++i) EXPECT_EQ(list[i], four.binding[i]);
    }
  }
}

/// A joint without skin is a candidate only where a muscle on it reaches.
TEST(Candidates, IncludeBonesOfMuscles) {
  test::ExportScene scene = test::bundledScene("horse");
  const Refinement refinement = refine(scene.character->mesh, 2);
  const auto own = interpolatedWeights(scene.character->mesh, refinement);
  const int belly = *scene.character->skeleton.findBone("belly");
  const auto named = [&] {
    const auto candidates = weightCandidates(*scene.character, scene.rig, refinement, own);
    EXPECT_TRUE(candidates.ok());
    return std::ranges::count_if(candidates.value(),
                                 [&](const auto& list) { return std::ranges::count(list, belly) > 0; });
  };
  EXPECT_EQ(named(), 0);
  Primitive& muscle = scene.rig.primitives.front();
  muscle.bone = "belly";
  muscle.mirror.clear();
  muscle.placement.center = glm::vec3(0.0f);
  muscle.placement.radii = glm::vec3(0.2f);
  for (Primitive& other : scene.rig.primitives) {
    if (other.mirror == muscle.name) other.mirror.clear();
  }
  EXPECT_GT(named(), 0);
  EXPECT_LT(named(), static_cast<std::ptrdiff_t>(own.size()));
}

TEST(InterpolatedWeights, MatchTheFileAtVerticesAndAreAveragedOnEdges) {
  const test::ExportScene scene = test::bundledScene("horse");
  const ControlMesh& mesh = scene.character->mesh;
  const Refinement refinement = refine(mesh, 2);
  const auto shares = interpolatedWeights(mesh, refinement);
  const auto weightOf = [](const std::vector<Share>& list, int binding) {
    const auto found = std::ranges::find(list, binding, &Share::binding);
    return found == list.end() ? 0.0 : found->weight;
  };
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto& middle = shares[static_cast<std::size_t>(refinement.edgeVertex(static_cast<int>(e), 1))];
    double sum = 0.0;
    for (const Share& share : middle) {
      double mean = 0.0;
      for (const int end : mesh.edges[e].vertices) {
        mean += 0.5 * weightOf(shares[static_cast<std::size_t>(end)], share.binding);
      }
      EXPECT_NEAR(share.weight, mean, 1e-9);
      sum += share.weight;
    }
    EXPECT_NEAR(sum, 1.0, 1e-5);
  }
  for (int v = 0; v < refinement.controlVertices; ++v) {
    for (const Influence& influence : mesh.influencesOf(v)) {
      EXPECT_EQ(weightOf(shares[static_cast<std::size_t>(v)], influence.binding),
                static_cast<double>(influence.weight));
    }
  }
}

}  // namespace
}  // namespace sinew::exporting
