// tests/files/gltf_parts_test.cpp: pieces of the mesh have names, and each triangle belongs to one.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "core/geometry/at.h"
#include "sinew/files/gltf_import.h"
#include "tests/support/characters/characters.h"
#include "tests/support/characters/dressed_humanoid.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/temporary_folder.h"

namespace sinew {
namespace {

std::shared_ptr<const Character> importOf(const test::Post& post) {
  const test::TemporaryFolder folder;
  const auto imported = importGltf(folder.write("post.glb", post.file.glb()));
  EXPECT_TRUE(imported.ok()) << imported.error().text();
  return imported.value();
}

std::vector<std::string> namesOf(const Character& character) {
  std::vector<std::string> names;
  for (const MeshPart& part : character.parts) names.push_back(part.name);
  return names;
}

using Names = std::vector<std::string>;

TEST(GltfParts, PartsAreMeshesOrTheirMaterials) {
  test::Post post = test::makePost();
  EXPECT_EQ(namesOf(*importOf(post)), Names{"default"}) << "the mesh has no name";
  post.file.json["meshes"][0]["name"] = "Post";
  EXPECT_EQ(namesOf(*importOf(post)), Names{"Post"});
  // The upper half has another material.
  post.file.json["materials"] = {{{"name", "Wood"}}, {{"name", "Wood"}}, {{"name", ""}}};
  const std::vector<std::uint16_t> lower(post.indices.begin(), post.indices.begin() + 30);
  const std::vector<std::uint16_t> upper(post.indices.begin() + 30, post.indices.end());
  auto second = post.primitive();
  post.primitive()["indices"] = post.file.accessor(lower, "SCALAR");
  post.primitive()["material"] = 0;
  second["indices"] = post.file.accessor(upper, "SCALAR");
  second["material"] = 1;
  post.file.json["meshes"][0]["primitives"].push_back(second);
  const auto two = importOf(post);
  EXPECT_EQ(namesOf(*two), (Names{"Wood", "Wood 2"})) << "each name once";
  for (std::size_t t = 0; t < two->mesh.triangles.size(); ++t) {
    EXPECT_EQ(two->mesh.triangles[t].part, t < 10 ? 0 : 1);
    EXPECT_EQ(at(two->parts, two->mesh.triangles[t].part).material, two->mesh.triangles[t].material);
  }
  post.file.json["meshes"][0]["primitives"][1]["material"] = 2;
  EXPECT_EQ(namesOf(*importOf(post)), (Names{"Wood", "material 2"})) << "a material without a name gets one";
}

TEST(GltfParts, MeshUsedTwiceIsOnePartAndACollapsedMeshIsNone) {
  test::Post post = test::makePost();
  post.file.json["meshes"][0]["name"] = "Post";
  auto& nodes = post.file.json["nodes"];
  nodes.push_back({{"mesh", 0}, {"translation", {5.0, 0.0, 0.0}}});
  post.file.json["meshes"].push_back(post.file.json["meshes"][0]);
  post.file.json["meshes"][1]["name"] = "Nothing";
  const std::vector<std::uint16_t> flat{0, 0, 1, 2, 2, 2};
  post.file.json["meshes"][1]["primitives"][0]["indices"] = post.file.accessor(flat, "SCALAR");
  nodes.push_back({{"mesh", 1}});
  for (int i = 3; i < 5; ++i) post.file.json["scenes"][0]["nodes"].push_back(i);
  const auto character = importOf(post);
  EXPECT_EQ(character->mesh.triangles.size(), 40u);
  EXPECT_EQ(namesOf(*character), Names{"Post"});
}

TEST(GltfParts, DressedBodyHasNamedClothes) {
  const auto dressed = test::dressedHumanoid();
  EXPECT_EQ(namesOf(*dressed), (Names{"humanoid", "Shirt", "Trousers", "Eyes", "Hair"}));
  std::set<int> used;
  for (const ControlTriangle& triangle : dressed->mesh.triangles) used.insert(triangle.part);
  EXPECT_EQ(used.size(), dressed->parts.size());
}

TEST(GltfParts, RealCharactersHaveUniquePartNames) {
  for (const char* file : {"man.glb", "woman.glb", "fighter.glb", "RobotExpressive.glb", "Bull.glb", "Fox.glb"}) {
    const auto path = test::characterFile(file);
    if (!path) SINEW_SKIP_WITHOUT_CHARACTERS();
    const auto character = importGltf(*path).value();
    Names names = namesOf(*character);
    std::ranges::sort(names);
    EXPECT_EQ(std::ranges::adjacent_find(names), names.end()) << file;
    std::vector<int> counts(names.size(), 0);
    for (const ControlTriangle& triangle : character->mesh.triangles) {
      ++at(counts, triangle.part);
      EXPECT_EQ(at(character->parts, triangle.part).material, triangle.material);
    }
    EXPECT_EQ(std::ranges::count(counts, 0), 0) << file;
  }
}

}  // namespace
}  // namespace sinew
