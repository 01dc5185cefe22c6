// tests/viewport/tools/drawn_rise_test.cpp: a freshly drawn muscle is visible on the skin, and not a lump.

#include <algorithm>
#include <cstdio>

#include <gtest/gtest.h>

#include "sinew/files/gltf_import.h"
#include "tests/viewport/tools/laid_muscles.h"

namespace sinew::test {
namespace {

/// Rise of the skin over each muscle of the rig alone in the bind pose, fractions of H, ascending.
std::vector<float> risesOf(const std::shared_ptr<const Character>& character, const Rig& rig) {
  const Pose pose = bindPose(character->skeleton);
  const auto surfaceOf = [&](const Rig& of) {
    Smoother smoother(character);
    Surface surface;
    EXPECT_TRUE(smoother.prepare(of).ok());
    smoother.smooth(pose, surface);
    return surface;
  };
  std::vector<float> rises;
  for (const Primitive& muscle : rig.primitives) {
    Rig alone = rig;
    alone.smoothing.detail = DetailKind::kUniform;  // The same vertices with and without the muscle.
    alone.smoothing.depth = 2;
    alone.primitives.clear();
    const Surface bare = surfaceOf(alone);
    alone.primitives.push_back(muscle);
    alone.primitives[0].mirror.clear();
    const Surface lifted = surfaceOf(alone);
    float most = 0.0f;
    for (std::size_t v = 0; v < bare.positions.size(); ++v) {
      most = std::max(most, glm::dot(lifted.positions[v] - bare.positions[v], bare.normals[v]));
    }
    rises.push_back(most / character->height);
  }
  std::ranges::sort(rises);
  return rises;
}

TEST(DrawnMuscleHeight, IsVisibleAndModerate) {
  for (const char* name : {"humanoid", "horse", "demo"}) {
    const auto character =
        importGltf(std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / (std::string(name) + ".glb"));
    ASSERT_TRUE(character.ok()) << name;
    const std::vector<float> rises = risesOf(character.value(), layMuscles(character.value(), 12));
    ASSERT_GE(rises.size(), 10u) << name;
    std::printf("  %-9s rise of %zu drawn muscles: %.2f to %.2f %% of H, median %.2f %%\n", name, rises.size(),
                100.0 * static_cast<double>(rises.front()), 100.0 * static_cast<double>(rises.back()),
                100.0 * static_cast<double>(rises[rises.size() / 2]));
    EXPECT_GE(rises[rises.size() / 2], 0.008f) << name;
    EXPECT_LE(rises[rises.size() / 2], 0.015f) << name;
    EXPECT_GE(rises.front(), 0.006f) << name;
    EXPECT_LE(rises.back(), 0.019f) << name;
  }
}

}  // namespace
}  // namespace sinew::test
