// tests/files/gltf_material_test.cpp: material maps of glTF, read and written.

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sinew/character/pose.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/surface_export.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/material_post.h"
#include "tests/support/temporary_folder.h"

namespace sinew {
namespace {

using nlohmann::ordered_json;

using test::kOnePixel;
using test::mapAt;
using test::wholeMaterial;

Result<std::shared_ptr<const Character>> importMaterial(const ordered_json& material, int images,
                                                        const std::string& image = kOnePixel) {
  const test::TemporaryFolder folder;
  return importGltf(folder.write("post.glb", test::materialPost(material, images, image).file.glb()));
}

void expectWhole(const Character& character) {
  ASSERT_EQ(character.textures.size(), 3u) << "each image once";
  EXPECT_EQ(character.textures[0].rgba, (std::vector<std::uint8_t>{10, 128, 255, 255}));
  const Material& material = character.materials.at(0);
  EXPECT_EQ(material.metallic, 1.0f);
  EXPECT_EQ(material.roughness, 0.5f);
  EXPECT_EQ(material.occlusionMap, material.metallicRoughnessMap);
  EXPECT_GE(material.metallicRoughnessMap.texture, 0);
  EXPECT_GE(material.normalMap.texture, 0);
  EXPECT_NE(material.normalMap.texture, material.metallicRoughnessMap.texture);
  EXPECT_EQ(material.normalMap.place, TextureMap{}.place);
  EXPECT_EQ(material.normalScale, -0.5f);
  EXPECT_EQ(material.occlusionStrength, 0.25f);
  EXPECT_EQ(material.emissive, glm::vec3(3.0f, 1.5f, 0.0f));
  // Rotated counter-clockwise, scaled, then translated (KHR_texture_transform).
  const float c = std::cos(0.5f), s = std::sin(0.5f);
  const std::array<glm::vec3, 2> place{{{2 * c, 4 * s, 0.5f}, {-2 * s, 4 * c, 0.25f}}};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(material.emissiveMap.place[0][i], place[0][i], 1e-5f);
    EXPECT_NEAR(material.emissiveMap.place[1][i], place[1][i], 1e-5f);
  }
}

TEST(GltfMaterial, AllMapsAreImported) {
  const auto character = importMaterial(wholeMaterial(), 3);
  ASSERT_TRUE(character.ok()) << character.error().text();
  expectWhole(*character.value());
  EXPECT_TRUE(character.value()->ignored.empty());
}

TEST(GltfMaterial, MapsSurviveAGlbExport) {
  const auto character = importMaterial(wholeMaterial(), 3);
  ASSERT_TRUE(character.ok());
  Smoother smoother(character.value());
  Rig rig;
  rig.smoothing.depth = 1;
  ASSERT_TRUE(smoother.prepare(rig).ok());
  Surface surface;
  smoother.smooth(bindPose(character.value()->skeleton), surface);
  const test::TemporaryFolder folder;
  const auto file = folder.path() / "surface.glb";
  ASSERT_TRUE(exportSurface(surface, *character.value(), file).ok());
  const auto again = importGltf(file);
  ASSERT_TRUE(again.ok()) << again.error().text();
  expectWhole(*again.value());
}

/// If the base color has its own transform, the surface's uv include it; other maps are transformed relative to that.
TEST(GltfMaterial, MapTransformsAreRelativeToTheBaseColor) {
  const ordered_json base{{"scale", {2, 2}}, {"offset", {1, 0}}};
  ordered_json material{{"pbrMetallicRoughness", {{"baseColorTexture", mapAt(0, base)}}},
                        {"normalTexture", mapAt(1, {{"scale", {6, 2}}})},
                        {"occlusionTexture", mapAt(1, base)}};
  const auto character = importMaterial(material, 2);
  ASSERT_TRUE(character.ok());
  const Material& read = character.value()->materials.at(0);
  EXPECT_EQ(read.occlusionMap.place, TextureMap{}.place);
  EXPECT_EQ(read.normalMap.place[0], glm::vec3(3.0f, 0.0f, -3.0f));
  EXPECT_EQ(read.normalMap.place[1], glm::vec3(0.0f, 1.0f, 0.0f));
}

TEST(GltfMaterial, MapsWithOtherCoordinatesAreReportedAndSkipped) {
  for (const ordered_json& other : {ordered_json{{"index", 1}, {"texCoord", 1}}, mapAt(1)}) {
    const ordered_json collapsed{{"scale", {0, 1}}};
    const bool second = other.contains("texCoord");
    ordered_json material{
        {"pbrMetallicRoughness",
         {{"baseColorTexture", second ? mapAt(0) : mapAt(0, collapsed)}, {"metallicRoughnessTexture", other}}},
        {"emissiveFactor", {1, 1, 1}},
        {"emissiveTexture", other}};
    const auto character = importMaterial(material, 2);
    ASSERT_TRUE(character.ok());
    const Material& read = character.value()->materials.at(0);
    EXPECT_EQ(read.metallicRoughnessMap.texture, -1);
    EXPECT_EQ(read.metallic, 0.0f) << "the factor alone would be chrome";
    EXPECT_EQ(read.emissive, glm::vec3(0.0f)) << "the factor alone would be a lamp";
    ASSERT_EQ(character.value()->ignored.size(), 1u);
    EXPECT_NE(character.value()->ignored[0].find("other texture coordinates"), std::string::npos);
  }
}

TEST(GltfMaterial, FirstMapSetsTheCoordinatesWithoutABaseColor) {
  const ordered_json moved{{"offset", {0.5, 0.5}}};
  const auto character = importMaterial({{"normalTexture", mapAt(0, moved)}}, 1);
  ASSERT_TRUE(character.ok());
  EXPECT_EQ(character.value()->materials.at(0).normalMap.place, TextureMap{}.place);
  EXPECT_EQ(character.value()->mesh.wedges.at(0).uv, glm::vec2(0.75f, 1.25f));
}

TEST(GltfMaterial, UnlitMaterialsHaveNoMaps) {
  ordered_json material = wholeMaterial();
  material["extensions"]["KHR_materials_unlit"] = ordered_json::object();
  const auto character = importMaterial(material, 3);
  ASSERT_TRUE(character.ok());
  EXPECT_TRUE(character.value()->materials.at(0).unlit);
  EXPECT_TRUE(character.value()->textures.empty());
}

TEST(GltfMaterial, BrokenMapsAreSkippedAndInvalidOnesRefused) {
  const auto character = importMaterial(wholeMaterial(), 3, "missing.png");
  ASSERT_TRUE(character.ok());
  const Material& read = character.value()->materials.at(0);
  EXPECT_EQ(read.normalMap.texture, -1);
  EXPECT_EQ(read.metallic, 0.0f);
  EXPECT_EQ(read.emissive, glm::vec3(0.0f));
  EXPECT_FALSE(character.value()->ignored.empty());
  for (const char* map : {"normalTexture", "occlusionTexture", "emissiveTexture"}) {
    for (const ordered_json& wrong : {ordered_json{{"index", 7}}, ordered_json{{"index", -1}}, ordered_json::object(),
                                      ordered_json("text"), ordered_json{{"index", 0}, {"texCoord", "x"}}}) {
      const auto refused = importMaterial({{map, wrong}}, 1);
      ASSERT_FALSE(refused.ok()) << map << wrong;
      EXPECT_NE(refused.error().place.find(map), std::string::npos) << refused.error().text();
    }
  }
}

/// Base colors of all materials first, whatever the order in the file: the limit drops the least visible maps.
TEST(GltfMaterial, BaseColorsAreReadFirst) {
  test::Post post = test::makePost();
  for (int i = 0; i < 2; ++i) {
    post.file.json["images"].push_back({{"uri", kOnePixel}, {"name", i == 0 ? "relief" : "color"}});
    post.file.json["textures"].push_back({{"source", i}});
  }
  post.file.json["materials"].push_back({{"normalTexture", mapAt(0)}});
  post.file.json["materials"].push_back({{"pbrMetallicRoughness", {{"baseColorTexture", mapAt(1)}}}});
  post.primitive()["material"] = 0;
  const test::TemporaryFolder folder;
  const auto character = importGltf(folder.write("post.glb", post.file.glb()));
  ASSERT_TRUE(character.ok());
  ASSERT_EQ(character.value()->textures.size(), 2u);
  EXPECT_EQ(character.value()->textures[0].name, "color");
}

}  // namespace
}  // namespace sinew
