// tests/character/skinning_test.cpp: skinned characters match an independent double-precision skinning of the raw
// files.

#include "core/character/skinning.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/geometry/normals.h"
#include "sinew/files/gltf_import.h"
#include "tests/support/characters/characters.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/characters/gltf_oracle.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/temporary_folder.h"

namespace sinew {
namespace {

class RealCharacter : public testing::TestWithParam<const char*> {};

TEST_P(RealCharacter, SkinningMatchesTheFile) {
  const auto file = test::characterFile(GetParam());
  if (!file) SINEW_SKIP_WITHOUT_CHARACTERS();
  test::expectSkinsLikeTheFile(*file);
}

/// In the bind pose every vertex stays at its place in the control mesh.
TEST_P(RealCharacter, BindPoseKeepsTheMesh) {
  const auto file = test::characterFile(GetParam());
  if (!file) SINEW_SKIP_WITHOUT_CHARACTERS();
  const auto imported = importGltf(*file);
  ASSERT_TRUE(imported.ok()) << imported.error().text();
  const Character& character = *imported.value();
  SkinnedMesh skinned;
  skin(character, bindPose(character.skeleton), skinned);
  ASSERT_EQ(skinned.positions.size(), character.mesh.positions.size());
  for (std::size_t v = 0; v < skinned.positions.size(); ++v) {
    EXPECT_LE(glm::distance(skinned.positions[v], character.mesh.positions[v]), 1e-5f * character.height);
    EXPECT_GE(glm::dot(skinned.normals[v], character.mesh.normals[v]), 0.999f);
  }
}

INSTANTIATE_TEST_SUITE_P(Files, RealCharacter,
                         testing::Values("Fox.glb", "greenman.glb", "robot.glb", "cesium_man.gltf",
                                         "rigged_simple.gltf", "SimpleSkin.gltf", "RobotExpressive.glb"));

TEST(Skinning, BentPostMatchesTheFile) {
  const test::TemporaryFolder folder;
  test::expectSkinsLikeTheFile(folder.write("post.glb", test::makePost().file.glb()));
}

/// Computed by hand: the knee rotates its ring by 90 degrees about x, so that up becomes forward.
TEST(Skinning, BentPostMatchesAHandCalculation) {
  const test::TemporaryFolder folder;
  const auto imported = importGltf(folder.write("post.glb", test::makePost().file.glb()));
  ASSERT_TRUE(imported.ok()) << imported.error().text();
  const Character& character = *imported.value();
  SkinnedMesh skinned;
  skin(character, samplePose(character.skeleton, character.clips.at(0), 1.0f), skinned);
  for (std::size_t v = 0; v < skinned.positions.size(); ++v) {
    const glm::vec3 p = character.mesh.positions[v];
    const glm::vec3 turned(p.x, 1.0f - p.z, p.y - 1.0f);
    const float knee = 0.5f * p.y;
    const glm::vec3 expected = (1.0f - knee) * p + knee * turned;
    EXPECT_LE(glm::distance(skinned.positions[v], expected), 1e-6f) << v;
    EXPECT_NEAR(glm::length(skinned.normals[v]), 1.0f, 1e-5f);
  }
}

/// Wedges of faces that rotate with one bone keep their faces' normals; uncreased ones equal their vertex's, bit for
/// bit.
TEST(Skinning, CreasedWedgesRotateWithTheirVertices) {
  const auto character = test::makeCube();
  const ControlMesh sharp = creased(character->mesh, 30.0f);
  const Pose pose = samplePose(character->skeleton, character->clips.at(0), 0.5f);
  SkinnedMesh skinned;
  skin(*character, pose, skinned);
  std::vector<glm::vec3> normals;
  skinWedgeNormals(*character, sharp.wedges, skinned, normals);
  ASSERT_EQ(normals.size(), sharp.wedges.size());
  for (const ControlTriangle& triangle : sharp.triangles) {
    std::array<glm::vec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = skinned.positions[static_cast<std::size_t>(triangle.vertices[i])];
    const glm::vec3 face = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
    const bool rigid = std::ranges::all_of(triangle.vertices, [&](int v) {
      return sharp.positions[static_cast<std::size_t>(v)].y ==
             sharp.positions[static_cast<std::size_t>(triangle.vertices[0])].y;
    });
    for (const int wedge : triangle.wedges) {
      const glm::vec3 normal = normals[static_cast<std::size_t>(wedge)];
      EXPECT_NEAR(glm::length(normal), 1.0f, 1e-5f);
      EXPECT_LT(glm::distance(normal, rigid ? face : normal), 1e-5f);
    }
  }
  skinWedgeNormals(*character, character->mesh.wedges, skinned, normals);
  for (std::size_t w = 0; w < normals.size(); ++w) {
    EXPECT_EQ(normals[w], skinned.normals[static_cast<std::size_t>(character->mesh.wedges[w].vertex)]);
  }
}

}  // namespace
}  // namespace sinew
