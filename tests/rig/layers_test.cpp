// tests/rig/layers_test.cpp: guessed and selected layers of parts, and the resulting pieces of the mesh.
#include "core/rig/mesh_layers.h"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "sinew/files/gltf_import.h"
#include "tests/support/characters/dressed_humanoid.h"
#include "tests/support/characters/real_characters.h"

namespace sinew {
namespace {

constexpr SkinLayer kSkin = SkinLayer::kSkin;
constexpr SkinLayer kCloth = SkinLayer::kCloth;
constexpr SkinLayer kRigid = SkinLayer::kRigid;

SkinLayer layerOf(const Character& character, const std::vector<SkinLayer>& layers, const std::string& part) {
  const auto found = std::ranges::find(character.parts, part, &MeshPart::name);
  EXPECT_NE(found, character.parts.end()) << part;
  return layers[static_cast<std::size_t>(found - character.parts.begin())];
}

TEST(LayerGuess, RecognizesADressedBody) {
  const auto dressed = test::dressedHumanoid();
  const std::vector<SkinLayer> guessed = guessLayers(*dressed);
  ASSERT_EQ(guessed.size(), 5u);
  EXPECT_EQ(layerOf(*dressed, guessed, "humanoid"), kSkin);
  EXPECT_EQ(layerOf(*dressed, guessed, "Shirt"), kCloth);
  EXPECT_EQ(layerOf(*dressed, guessed, "Trousers"), kCloth);
  EXPECT_EQ(layerOf(*dressed, guessed, "Hair"), kCloth);
  EXPECT_EQ(layerOf(*dressed, guessed, "Eyes"), kRigid);
}

TEST(LayerGuess, UsesPositionsIfNamesAreMeaningless) {
  Character dressed = *test::dressedHumanoid();
  const std::vector<SkinLayer> named = guessLayers(dressed);
  for (std::size_t i = 0; i < dressed.parts.size(); ++i) dressed.parts[i].name = "Cube." + std::to_string(i);
  for (Material& material : dressed.materials) material.name = "Material";
  EXPECT_EQ(guessLayers(dressed), named);
}

TEST(LayerGuess, ConnectedPartsAreSkinWhateverTheirName) {
  Character character = *importGltf(std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "humanoid.glb").value();
  character.parts = {{"Body", 0}, {"Eye shoe hair shirt", 0}};
  for (std::size_t t = 0; t < character.mesh.triangles.size(); ++t) {
    const int v = character.mesh.triangles[t].vertices[0];
    if (at(character.mesh.positions, v).y < 0.2f * character.height) character.mesh.triangles[t].part = 1;
  }
  EXPECT_EQ(guessLayers(character), (std::vector<SkinLayer>{kSkin, kSkin}));
}

TEST(LayerGuess, SinglePartIsSkin) {
  for (const char* file : {"humanoid.glb", "horse.glb", "demo.glb", "tangle.glb", "wrapped.glb"}) {
    const auto character = importGltf(std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / file).value();
    EXPECT_EQ(character->parts.size(), 1u) << file;
    EXPECT_EQ(guessLayers(*character), std::vector<SkinLayer>{kSkin}) << file;
  }
}

TEST(LayerGuess, BodiesSplitByMaterialStaySkin) {
  for (const char* file : {"robot.glb", "RobotExpressive.glb", "Bull.glb", "Husky.glb", "Trex.glb"}) {
    const auto character = test::realCharacter(file);
    if (!character) GTEST_SKIP() << "left out: real characters are not at hand";
    const std::vector<SkinLayer> guessed = guessLayers(*character);
    EXPECT_EQ(std::ranges::count(guessed, kSkin), static_cast<int>(guessed.size())) << file;
  }
}

TEST(Layers, RigOverridesTheGuessAndKeepsUnknownParts) {
  const auto dressed = test::dressedHumanoid();
  const std::vector<SkinLayer> guessed = guessLayers(*dressed);
  Rig rig;
  EXPECT_EQ(layersOf(rig, *dressed, guessed), guessed);
  rig = setLayer(rig, "Shirt", kRigid).value();
  rig = setLayer(rig, "Cape", kCloth).value();
  EXPECT_EQ(layerOf(*dressed, layersOf(rig, *dressed, guessed), "Shirt"), kRigid);
  EXPECT_EQ(missingParts(rig, *dressed), std::vector<std::string>{"Cape"});
  rig = setLayer(rig, "Shirt", std::nullopt).value();
  EXPECT_EQ(layersOf(rig, *dressed, guessed), guessed);
  ASSERT_EQ(rig.layers.size(), 1u) << "a part that this character lacks is kept";
  EXPECT_FALSE(setLayer(rig, "", kSkin).ok());
  EXPECT_TRUE(withoutLayers(rig).layers.empty());
  rig.layers.push_back({"Cape", kSkin});
  EXPECT_FALSE(validateLayers(rig).ok()) << "twice";
}

TEST(Layers, NamesRoundTrip) {
  for (const SkinLayer layer : {kSkin, kCloth, kRigid}) EXPECT_EQ(skinLayerNamed(nameOf(layer)), layer);
  EXPECT_FALSE(skinLayerNamed("Cloth").has_value());
}

TEST(MeshLayers, SharedCarriersAreSkinThenCloth) {
  Character character = *importGltf(std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "humanoid.glb").value();
  character.parts = {{"a", 0}, {"b", 0}, {"c", 0}};
  for (std::size_t t = 0; t < character.mesh.triangles.size(); ++t) {
    character.mesh.triangles[t].part = static_cast<int>(t % 3);
  }
  const std::array layers{kRigid, kCloth, kSkin};
  const MeshLayers found = meshLayers(character, layers);
  const ControlMesh& mesh = character.mesh;
  std::vector<SkinLayer> expected(found.carriers.size(), kRigid);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const SkinLayer own = layers[t % 3];
    EXPECT_EQ(found.carriers[mesh.positions.size() + mesh.edges.size() + t], own);
    expected[mesh.positions.size() + mesh.edges.size() + t] = own;
    for (const int v : mesh.triangles[t].vertices) at(expected, v) = std::min(at(expected, v), own);
    for (const int e : mesh.triangles[t].edges) {
      auto& edge = expected[mesh.positions.size() + toIndex(e)];
      edge = std::min(edge, own);
    }
  }
  EXPECT_EQ(found.carriers, expected);
}

TEST(MeshLayers, ClothIsBoundToTheNearestSkinOfItsOwnBones) {
  const auto dressed = test::dressedHumanoid();
  const MeshLayers found = meshLayers(*dressed, guessLayers(*dressed));
  ASSERT_TRUE(found.hasCloth());
  const ControlMesh& mesh = dressed->mesh;
  int bound = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    EXPECT_EQ(found.skinUnder[v] >= 0, found.carriers[v] == kCloth) << "all clothes lie near the skin";
    if (found.skinUnder[v] < 0) continue;
    ++bound;
    const auto& triangle = at(mesh.triangles, found.skinUnder[v]);
    EXPECT_EQ(triangle.part, 0);
    float nearest = 1e9f;
    for (const int corner : triangle.vertices) {
      nearest = std::min(nearest, glm::distance(mesh.positions[v], at(mesh.positions, corner)));
    }
    EXPECT_LT(nearest, 0.1f * dressed->height);
  }
  EXPECT_GT(bound, 300);
}

}  // namespace
}  // namespace sinew
