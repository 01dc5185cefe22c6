// tests/files/gltf_traps_test.cpp: unusual features that glTF allows and real files use, each added to the same small
// post.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/character/skinning.h"
#include "core/geometry/weld.h"
#include "sinew/files/gltf_import.h"
#include "tests/files/mentions.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/characters/gltf_oracle.h"
#include "tests/support/temporary_folder.h"

namespace sinew {
namespace {

using nlohmann::ordered_json;
using test::makePost;
using test::mentions;
using test::Post;

class GltfTrap : public testing::Test {
 protected:
  /// Imports a post; by default also compares it with an independent skinning.
  std::shared_ptr<const Character> import(const Post& post, bool compare = true) {
    const auto file = folder_.write("post.glb", post.file.glb());
    if (compare) test::expectSkinsLikeTheFile(file);
    const auto imported = importGltf(file);
    if (!imported) {
      ADD_FAILURE() << imported.error().text();
      return std::make_shared<Character>();
    }
    return imported.value();
  }

  test::TemporaryFolder folder_;
};

void expectPost(const Character& character) {
  EXPECT_EQ(character.mesh.positions.size(), 12u);
  EXPECT_EQ(character.mesh.triangles.size(), 20u);
  EXPECT_TRUE(topologyOf(character.mesh).closed());
}

TEST_F(GltfTrap, SparsePositionsAreImported) {
  Post post = makePost();
  ordered_json& accessor = post.file.json["accessors"][post.attributes()["POSITION"].get<std::size_t>()];
  const int indices = post.file.viewOf(std::vector<std::uint8_t>{8, 11});
  const int values = post.file.viewOf(std::vector<float>{-0.7f, 2, 0.7f, -0.7f, 3, -0.7f});
  accessor["sparse"] = {{"count", 2},
                        {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                        {"values", {{"bufferView", values}}}};
  const auto character = import(post);
  expectPost(*character);
  EXPECT_EQ(character->height, 3.0f);
}

TEST_F(GltfTrap, SparseAccessorWithoutABaseStartsFromZero) {
  Post post = makePost();
  std::vector<std::uint16_t> all(12);
  for (std::uint16_t i = 0; i < 12; ++i) all[i] = i;
  ordered_json& accessor = post.file.json["accessors"][post.attributes()["POSITION"].get<std::size_t>()];
  const int indices = post.file.viewOf(all);
  accessor["sparse"] = {{"count", 12},
                        {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                        {"values", {{"bufferView", accessor["bufferView"]}}}};
  accessor.erase("bufferView");
  expectPost(*import(post, false));
}

TEST_F(GltfTrap, MoreThanFourJointsPerVertexAreImported) {
  Post post = makePost();
  std::vector<std::uint8_t> joints(48, 0);
  std::vector<float> weights(48, 0.0f);
  for (std::size_t v = 0; v < 12; ++v) {
    joints[4 * v] = 1;
    weights[4 * v] = 1.0f;  // half of the total; the first set already sums to 1
  }
  post.attributes()["JOINTS_1"] = post.file.accessor(joints, "VEC4");
  post.attributes()["WEIGHTS_1"] = post.file.accessor(weights, "VEC4");
  const auto character = import(post);
  expectPost(*character);
  ASSERT_EQ(character->mesh.influencesOf(0).size(), 2u);
  EXPECT_NEAR(character->mesh.influencesOf(0)[1].weight, 0.5f, 1e-6f);
}

TEST_F(GltfTrap, NormalizedIntegerWeightsAndShortJointsAreImported) {
  for (const bool bytes : {true, false}) {
    Post post = makePost();
    std::vector<std::uint8_t> asBytes;
    std::vector<std::uint16_t> asShorts;
    std::vector<std::uint16_t> joints(post.joints.begin(), post.joints.end());
    for (const float weight : post.weights) {
      asBytes.push_back(static_cast<std::uint8_t>(std::lround(weight * 255.0f)));
      asShorts.push_back(static_cast<std::uint16_t>(std::lround(weight * 65535.0f)));
    }
    post.attributes()["WEIGHTS_0"] =
        bytes ? post.file.accessor(asBytes, "VEC4", true) : post.file.accessor(asShorts, "VEC4", true);
    post.attributes()["JOINTS_0"] = post.file.accessor(joints, "VEC4");
    expectPost(*import(post));
  }
}

TEST_F(GltfTrap, WeightsAreNormalized) {
  Post post = makePost();
  for (float& weight : post.weights) weight *= 3.0f;
  post.attributes()["WEIGHTS_0"] = post.file.accessor(post.weights, "VEC4");
  const auto character = import(post);
  EXPECT_NEAR(character->mesh.influencesOf(0)[0].weight, 1.0f, 1e-6f);
}

TEST_F(GltfTrap, NegativeWeightsAreZeroWithANote) {
  Post post = makePost();
  for (std::size_t v = 0; v < 12; ++v) {
    post.weights[4 * v + 2] = -0.25f;
    post.joints[4 * v + 2] = 1;
  }
  post.attributes()["JOINTS_0"] = post.file.accessor(post.joints, "VEC4");
  post.attributes()["WEIGHTS_0"] = post.file.accessor(post.weights, "VEC4");
  const auto character = import(post, false);
  EXPECT_TRUE(mentions(*character, "skin weights below 0 are ignored: they count as 0"));
  ASSERT_EQ(character->mesh.influencesOf(0).size(), 1U);
  EXPECT_EQ(character->mesh.influencesOf(0)[0].weight, 1.0f);
  EXPECT_FALSE(mentions(*import(makePost()), "below 0"));
}

TEST_F(GltfTrap, ZeroWeightsFollowTheFirstJoint) {
  Post post = makePost();
  std::fill(post.weights.begin(), post.weights.end(), 0.0f);
  for (std::size_t v = 0; v < 12; ++v) post.joints[4 * v] = 1;
  post.attributes()["WEIGHTS_0"] = post.file.accessor(post.weights, "VEC4");
  post.attributes()["JOINTS_0"] = post.file.accessor(post.joints, "VEC4");
  const auto character = import(post, false);
  EXPECT_EQ(character->mesh.influencesOf(3)[0].binding, 1);
  EXPECT_TRUE(mentions(*character, "weights are all zero"));
}

TEST_F(GltfTrap, InterleavedVerticesAreImported) {
  Post post = makePost();
  std::vector<float> rows;
  for (std::size_t v = 0; v < 12; ++v) {
    rows.insert(rows.end(), post.positions.begin() + static_cast<long>(3 * v),
                post.positions.begin() + static_cast<long>(3 * v + 3));
    rows.insert(rows.end(), post.weights.begin() + static_cast<long>(4 * v),
                post.weights.begin() + static_cast<long>(4 * v + 4));
  }
  const int view = post.file.viewOf(rows);
  post.file.json["bufferViews"][static_cast<std::size_t>(view)]["byteStride"] = 28;
  for (const char* name : {"POSITION", "WEIGHTS_0"}) {
    ordered_json& accessor = post.file.json["accessors"][post.attributes()[name].get<std::size_t>()];
    accessor["bufferView"] = view;
    accessor["byteOffset"] = std::string(name) == "POSITION" ? 0 : 12;
  }
  expectPost(*import(post));
}

TEST_F(GltfTrap, UnindexedPrimitivesAreImported) {
  Post post = makePost();
  std::vector<float> positions;
  std::vector<float> weights;
  std::vector<std::uint8_t> joints;
  for (const std::uint16_t i : post.indices) {
    for (std::size_t c = 0; c < 3; ++c) positions.push_back(post.positions[3 * i + c]);
    for (std::size_t c = 0; c < 4; ++c) weights.push_back(post.weights[4 * i + c]);
    for (std::size_t c = 0; c < 4; ++c) joints.push_back(post.joints[4 * i + c]);
  }
  post.attributes()["POSITION"] = post.file.accessor(positions, "VEC3");
  post.attributes()["WEIGHTS_0"] = post.file.accessor(weights, "VEC4");
  post.attributes()["JOINTS_0"] = post.file.accessor(joints, "VEC4");
  post.primitive().erase("indices");
  expectPost(*import(post));
}

TEST_F(GltfTrap, StripsAndFansKeepTheirWinding) {
  Post post = makePost();
  const std::vector<std::uint8_t> around{0, 4, 1, 5, 2, 6, 3, 7, 0, 4};  // lower wall as a strip, flipped below
  const std::vector<std::uint8_t> upper{4, 8, 5, 9, 6, 10, 7, 11, 4, 8};
  const auto reversed = [](std::vector<std::uint8_t> strip) {
    for (std::size_t i = 0; i + 1 < strip.size(); i += 2) std::swap(strip[i], strip[i + 1]);
    return strip;
  };
  ordered_json base = post.primitive();
  ordered_json& primitives = post.file.json["meshes"][0]["primitives"];
  primitives = ordered_json::array();
  const auto add = [&](const std::vector<std::uint8_t>& indices, int mode) {
    base["indices"] = post.file.accessor(indices, "SCALAR");
    base["mode"] = mode;
    primitives.push_back(base);
  };
  add(reversed(around), 5);
  add(reversed(upper), 5);
  add({3, 2, 1, 0}, 6);
  add({8, 9, 10, 11}, 6);
  const auto character = import(post, false);
  expectPost(*character);
  for (const ControlTriangle& t : character->mesh.triangles) {
    const auto p = [&](std::size_t i) { return character->mesh.positions[static_cast<std::size_t>(t.vertices[i])]; };
    const glm::vec3 center = (p(0) + p(1) + p(2)) / 3.0f - glm::vec3(0, 1, 0);
    EXPECT_GT(glm::dot(glm::cross(p(1) - p(0), p(2) - p(0)), center), 0.0f);
  }
}

TEST_F(GltfTrap, PointsLinesAndFurtherColorsAreReported) {
  Post post = makePost();
  post.attributes()["COLOR_1"] = post.file.accessor(std::vector<float>(48, 1.0f), "VEC4");
  ordered_json points = post.primitive();
  points["mode"] = 0;
  post.file.json["meshes"][0]["primitives"].push_back(points);
  post.file.json["cameras"].push_back({{"type", "perspective"}});
  post.file.json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_texture_transform"};
  ordered_json weights = {{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}};
  post.file.json["animations"][0]["channels"].push_back(weights);
  const auto character = import(post, false);
  expectPost(*character);
  for (const char* what :
       {"points or lines", "vertex colours beyond the first set", "cameras", "KHR_lights_punctual", "weights"}) {
    EXPECT_TRUE(mentions(*character, what)) << what;
  }
  EXPECT_FALSE(mentions(*character, "KHR_texture_transform"));
}

TEST_F(GltfTrap, OnlyTheDefaultSceneIsImported) {
  Post post = makePost();
  post.file.json["nodes"].push_back({{"mesh", 0}});
  post.file.json["scenes"].push_back({{"nodes", {3}}});
  const auto character = import(post, false);
  expectPost(*character);
  EXPECT_EQ(character->skeleton.bones.size(), 2u);
  EXPECT_TRUE(mentions(*character, "scenes (1)"));
  EXPECT_TRUE(mentions(*character, "meshes outside"));
}

TEST_F(GltfTrap, QuantizedPositionsAreImported) {
  Post post = makePost();
  std::vector<std::int16_t> positions;
  for (const float p : post.positions) positions.push_back(static_cast<std::int16_t>(std::lround(100.0f * p)));
  post.attributes()["POSITION"] = post.file.accessor(positions, "VEC3");
  post.file.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  post.file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  // The inverse bind matrices of the file take meters, so scale the root instead: hip and knee now in centimeters.
  post.file.json["skins"][0].erase("inverseBindMatrices");
  const auto character = import(post, false);
  EXPECT_EQ(character->height, 200.0f);
}

/// KHR_texture_transform is applied to the uv: rotation by 90 degrees, scale, translation.
TEST_F(GltfTrap, TextureTransformIsAppliedToTheUv) {
  Post post = makePost();
  std::vector<std::uint16_t> uv;
  for (std::size_t v = 0; v < 12; ++v) uv.insert(uv.end(), {65535, 0});
  post.attributes()["TEXCOORD_1"] = post.file.accessor(uv, "VEC2", true);
  post.primitive()["material"] = 0;
  post.file.json["images"].push_back({{"uri", "missing.png"}});
  post.file.json["textures"].push_back({{"source", 0}});
  const ordered_json transform{
      {"offset", {0.25, 0.5}}, {"scale", {2, 3}}, {"rotation", std::acos(-1.0) / 2}, {"texCoord", 1}};
  post.file.json["materials"].push_back(
      {{"pbrMetallicRoughness",
        {{"baseColorTexture", {{"index", 0}, {"extensions", {{"KHR_texture_transform", transform}}}}}}}});
  const auto character = import(post, false);
  expectPost(*character);
  EXPECT_LE(glm::distance(character->mesh.wedges[0].uv, glm::vec2(0.25f, 0.5f - 2.0f)), 1e-6f);
  EXPECT_EQ(character->materials[0].baseColorTexture, -1);
  EXPECT_TRUE(mentions(*character, "missing.png")) << "a missing texture does not stop the import";
}

TEST_F(GltfTrap, MaterialsHaveFallbacks) {
  Post post = makePost();
  ordered_json glossy{{"diffuseFactor", {0.1, 0.2, 0.3, 1.0}}, {"glossinessFactor", 0.25}};
  post.file.json["materials"] = {{{"name", "skin"}, {"extensions", {{"KHR_materials_pbrSpecularGlossiness", glossy}}}},
                                 {{"alphaMode", "MASK"}, {"alphaCutoff", 0.3}, {"doubleSided", true}}};
  const auto character = import(post, false);
  ASSERT_EQ(character->materials.size(), 3u) << "two of the file and the default of the primitive";
  EXPECT_EQ(character->materials[0].baseColor, glm::vec4(0.1f, 0.2f, 0.3f, 1.0f));
  EXPECT_NEAR(character->materials[0].roughness, 0.75f, 1e-6f);
  EXPECT_EQ(character->materials[0].metallic, 0.0f);
  EXPECT_EQ(character->materials[1].alphaMode, AlphaMode::kMask);
  EXPECT_TRUE(character->materials[1].doubleSided);
  EXPECT_EQ(character->mesh.triangles[0].material, 2);
}

}  // namespace
}  // namespace sinew
