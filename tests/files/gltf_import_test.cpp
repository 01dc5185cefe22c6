// tests/files/gltf_import_test.cpp: facts about real characters, and the contents of a plain import.

#include "sinew/files/gltf_import.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/geometry/weld.h"
#include "sinew/character/pose.h"
#include "tests/support/characters/characters.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/euler_characteristic.h"
#include "tests/support/temporary_folder.h"

namespace sinew {
namespace {

struct Facts {
  const char* file;
  int triangles;
  int dropped;
  std::size_t vertices;
  bool closed;
  std::size_t joints;
  std::size_t clips;
  std::size_t textures;
  float height;
};

void PrintTo(const Facts& facts, std::ostream* out) { *out << facts.file; }

class RealFile : public testing::TestWithParam<Facts> {};

TEST_P(RealFile, HasTheExpectedFacts) {
  const Facts& facts = GetParam();
  const auto file = test::characterFile(facts.file);
  if (!file) SINEW_SKIP_WITHOUT_CHARACTERS();
  const auto imported = importGltf(*file);
  ASSERT_TRUE(imported.ok()) << imported.error().text();
  const Character& character = *imported.value();
  EXPECT_EQ(character.mesh.triangles.size(), static_cast<std::size_t>(facts.triangles));
  EXPECT_EQ(character.mesh.trianglesDropped, facts.dropped);
  EXPECT_EQ(character.mesh.positions.size(), facts.vertices);
  const Topology topology = topologyOf(character.mesh);
  EXPECT_EQ(topology.closed(), facts.closed);
  EXPECT_TRUE(topology.nonManifoldEdges.empty());
  if (facts.closed) {
    EXPECT_EQ(eulerCharacteristic(topology), 2);
  }
  EXPECT_EQ(character.skeleton.bones.size(), facts.joints);
  EXPECT_EQ(character.skeleton.bindings.size(), facts.joints);
  EXPECT_EQ(character.clips.size(), facts.clips);
  EXPECT_EQ(character.textures.size(), facts.textures);
  EXPECT_NEAR(character.height, facts.height, 1e-3f * facts.height);
  EXPECT_TRUE(character.ignored.empty());
  EXPECT_GE(character.materials.size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Files, RealFile,
                         testing::Values(Facts{"Fox.glb", 576, 0, 290, true, 24, 3, 1, 79.03f},
                                         Facts{"greenman.glb", 356, 0, 180, true, 12, 4, 1, 2.032f},
                                         Facts{"cesium_man.gltf", 4672, 0, 2338, true, 19, 1, 1, 1.507f},
                                         Facts{"rigged_simple.gltf", 188, 0, 96, true, 2, 1, 0, 9.150f},
                                         // 3,238 in the file; in four of them two corners coincide.
                                         Facts{"robot.glb", 3234, 4, 1820, false, 43, 14, 0, 4.559f},
                                         Facts{"SimpleSkin.gltf", 8, 0, 10, false, 2, 1, 0, 2.0f}));

/// The robot's parts touch: welded by position alone, which would join parts of different bones, 14 edges get three or
/// four triangles. Welded with their bindings, none.
TEST(RealRobot, TouchingPartsStaySeparate) {
  const auto file = test::characterFile("robot.glb");
  if (!file) SINEW_SKIP_WITHOUT_CHARACTERS();
  const auto imported = importGltf(*file);
  ASSERT_TRUE(imported.ok());
  const ControlMesh& mesh = imported.value()->mesh;
  TriangleSoup soup;
  soup.positions = mesh.positions;
  soup.uvs.resize(mesh.positions.size());
  for (std::size_t v = 0; v <= mesh.positions.size(); ++v) soup.influenceBegin.push_back(static_cast<int>(v));
  soup.influences.assign(mesh.positions.size(), {0, 1.0f});
  for (const ControlTriangle& t : mesh.triangles) {
    soup.triangles.push_back({static_cast<std::uint32_t>(t.vertices[0]), static_cast<std::uint32_t>(t.vertices[1]),
                              static_cast<std::uint32_t>(t.vertices[2])});
    soup.materials.push_back(0);
  }
  EXPECT_EQ(topologyOf(weld(soup, 1e-6f * imported.value()->height)).nonManifoldEdges.size(), 14u);
}

TEST(RealFox, HasNamesClipsAndATexture) {
  const auto file = test::characterFile("Fox.glb");
  if (!file) SINEW_SKIP_WITHOUT_CHARACTERS();
  const auto imported = importGltf(*file);
  ASSERT_TRUE(imported.ok());
  const Character& fox = *imported.value();
  EXPECT_EQ(fox.name, "Fox");
  EXPECT_EQ(fox.clips[0].name, "Survey");
  EXPECT_NEAR(fox.clips[1].duration, 0.7083f, 1e-3f);
  EXPECT_TRUE(fox.skeleton.findBone("b_LeftLeg01_015").has_value());
  ASSERT_EQ(fox.materials.at(0).baseColorTexture, 0);
  const Texture& texture = fox.textures[0];
  EXPECT_EQ(texture.mimeType, "image/png");
  EXPECT_EQ(texture.rgba.size(), 4u * static_cast<std::size_t>(texture.width * texture.height));
  EXPECT_EQ(std::string(texture.encoded.begin() + 1, texture.encoded.begin() + 4), "PNG");
}

TEST(RealCesiumMan, StandsUpright) {
  const auto file = test::characterFile("cesium_man.gltf");
  if (!file) SINEW_SKIP_WITHOUT_CHARACTERS();
  const auto imported = importGltf(*file);
  ASSERT_TRUE(imported.ok());
  const glm::vec3 extent = boundsOf(imported.value()->mesh.positions).extent();
  EXPECT_GT(extent.y, extent.x);
  EXPECT_GT(extent.y, extent.z);
}

/// All invariants that later stages rely on.
void expectWellFormed(const Character& character) {
  const Skeleton& skeleton = character.skeleton;
  for (std::size_t n = 0; n < skeleton.nodes.size(); ++n) EXPECT_LT(skeleton.nodes[n].parent, static_cast<int>(n));
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    EXPECT_LT(skeleton.bones[b].parent, static_cast<int>(b));
    EXPECT_FALSE(skeleton.bones[b].name.empty());
    EXPECT_TRUE(isFinite(skeleton.bones[b].bindInWorld));
    EXPECT_TRUE(isFinite(skeleton.bones[b].inverseBindInWorld));
  }
  for (std::size_t v = 0; v < character.mesh.positions.size(); ++v) {
    float sum = 0.0f;
    int last = -1;
    for (const Influence& influence : character.mesh.influencesOf(static_cast<int>(v))) {
      EXPECT_GT(influence.binding, last);
      EXPECT_LT(influence.binding, static_cast<int>(skeleton.bindings.size()));
      EXPECT_GT(influence.weight, 0.0f);
      last = influence.binding;
      sum += influence.weight;
    }
    EXPECT_NEAR(sum, 1.0f, 1e-5f);
  }
  for (const ControlTriangle& t : character.mesh.triangles) {
    EXPECT_LT(t.material, static_cast<int>(character.materials.size()));
  }
}

TEST_P(RealFile, IsWellFormed) {
  const auto file = test::characterFile(GetParam().file);
  if (!file) SINEW_SKIP_WITHOUT_CHARACTERS();
  const auto imported = importGltf(*file);
  ASSERT_TRUE(imported.ok());
  expectWellFormed(*imported.value());
}

TEST(GltfImport, PostIsImportedCompletely) {
  const test::TemporaryFolder folder;
  const auto imported = importGltf(folder.write("my post.glb", test::makePost().file.glb()));
  ASSERT_TRUE(imported.ok()) << imported.error().text();
  const Character& post = *imported.value();
  expectWellFormed(post);
  EXPECT_EQ(post.name, "my post");
  EXPECT_EQ(post.mesh.triangles.size(), 20u);
  EXPECT_EQ(post.mesh.positions.size(), 12u);
  EXPECT_TRUE(topologyOf(post.mesh).closed());
  EXPECT_EQ(post.height, 2.0f);
  ASSERT_EQ(post.skeleton.bones.size(), 2u);
  EXPECT_EQ(post.skeleton.bones[1].path, "hip/knee");
  EXPECT_EQ(post.skeleton.nodes.size(), 2u) << "the mesh node is neither a bone nor above one";
  ASSERT_EQ(post.clips.size(), 1u);
  EXPECT_EQ(post.clips[0].name, "bend");
  EXPECT_EQ(post.clips[0].duration, 1.0f);
  EXPECT_TRUE(post.ignored.empty());
  // Outward faces stay outward.
  for (const ControlTriangle& t : post.mesh.triangles) {
    const auto p = [&](std::size_t i) { return post.mesh.positions[static_cast<std::size_t>(t.vertices[i])]; };
    const glm::vec3 center = (p(0) + p(1) + p(2)) / 3.0f - glm::vec3(0, 1, 0);
    EXPECT_GT(glm::dot(glm::cross(p(1) - p(0), p(2) - p(0)), center), 0.0f);
  }
}

/// The same file in its three containers gives the same character.
TEST(GltfImport, ContainersGiveTheSameCharacter) {
  const test::TemporaryFolder folder;
  const test::Post post = test::makePost();
  folder.write("sub/data 1.bin", post.file.binary());
  const auto whole = importGltf(folder.write("a.glb", post.file.glb()));
  ASSERT_TRUE(whole.ok()) << whole.error().text();
  for (const auto& file : {folder.write("a.gltf", post.file.gltf()),
                           folder.write("b.gltf", post.file.gltfWithBufferAt("sub/data%201.bin")),
                           folder.write("c.gltf", post.file.gltfWithBufferAt("./sub/data 1.bin"))}) {
    const auto imported = importGltf(file);
    ASSERT_TRUE(imported.ok()) << imported.error().text();
    EXPECT_EQ(imported.value()->mesh.positions, whole.value()->mesh.positions) << file;
  }
}

}  // namespace
}  // namespace sinew
