// tests/files/gltf_hidden_test.cpp: alpha that hides a whole character is reported and ignored; alpha that hides a part
// is kept.

#include "core/files/gltf/node_tree.h"

#include <gtest/gtest.h>

#include "sinew/files/gltf_import.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/temporary_folder.h"

namespace sinew {
namespace {

/// Alpha of one material from all three sources.
struct Alpha {
  AlphaMode mode = AlphaMode::kOpaque;
  float factor = 1.0f;
  int texture = 255;  ///< Largest alpha of a texture's pixels; 255: no texture.
  float vertices = 1.0f;
  float cutoff = 0.5f;
};

constexpr AlphaMode kOpaque = AlphaMode::kOpaque, kMask = AlphaMode::kMask, kBlend = AlphaMode::kBlend;

Texture textureWith(int alpha) {
  Texture texture;
  texture.width = texture.height = 2;
  texture.rgba.assign(16, 0);
  texture.rgba[11] = static_cast<std::uint8_t>(alpha);  // The third pixel's; the others have 0.
  return texture;
}

/// The cube, its triangles divided evenly between these materials.
Character cubeOf(const std::vector<Alpha>& alphas) {
  Character cube = *test::makeCube();
  cube.materials.assign(alphas.size(), Material{});
  for (std::size_t m = 0; m < alphas.size(); ++m) {
    Material& material = cube.materials[m];
    material.name = "part " + std::to_string(m);
    material.alphaMode = alphas[m].mode;
    material.alphaCutoff = alphas[m].cutoff;
    material.baseColor.a = alphas[m].factor;
    if (alphas[m].texture == 255) continue;
    material.baseColorTexture = static_cast<int>(cube.textures.size());
    cube.textures.push_back(textureWith(alphas[m].texture));
  }
  const std::vector<Wedge> wedges = cube.mesh.wedges;
  cube.mesh.wedges.clear();
  for (std::size_t t = 0; t < cube.mesh.triangles.size(); ++t) {
    ControlTriangle& triangle = cube.mesh.triangles[t];
    const std::size_t m = t % alphas.size();
    triangle.material = static_cast<int>(m);
    for (int& corner : triangle.wedges) {
      Wedge wedge = wedges[static_cast<std::size_t>(corner)];
      wedge.color.a = corner % 2 == 0 ? 0.0f : alphas[m].vertices;  // The largest one counts.
      corner = static_cast<int>(cube.mesh.wedges.size());
      cube.mesh.wedges.push_back(wedge);
    }
  }
  return cube;
}

struct Case {
  const char* name;
  std::vector<Alpha> parts;
  std::vector<std::string> notes;  ///< None: nothing is changed.
};

void PrintTo(const Case& each, std::ostream* out) { *out << each.name; }

class HiddenCharacter : public testing::TestWithParam<Case> {};

TEST_P(HiddenCharacter, IsShownOpaqueOnlyIfNothingIsVisible) {
  Character cube = cubeOf(GetParam().parts);
  gltf::Notes notes;
  gltf::showHiddenCharacter(cube, notes);
  EXPECT_EQ(notes.lines(), GetParam().notes);
  for (std::size_t m = 0; m < cube.materials.size(); ++m) {
    EXPECT_EQ(cube.materials[m].shownOpaque, !GetParam().notes.empty()) << m;
    EXPECT_EQ(cube.materials[m].alphaMode, GetParam().parts[m].mode) << "the author's material stays";
    EXPECT_EQ(cube.materials[m].baseColor.a, GetParam().parts[m].factor);
  }
}

std::string note(int part, const std::string& alpha) {
  return "material \"part " + std::to_string(part) + "\": its alpha of " + alpha +
         " would hide the whole character; shown opaque";
}

const Case kCases[] = {
    {"opaque", {{kOpaque}}, {}},
    {"opaque with alpha 0 in every source", {{kOpaque, 0.0f, 0, 0.0f}}, {}},
    {"blend at full alpha", {{kBlend}}, {}},
    {"blend, factor 0", {{kBlend, 0.0f}}, {note(0, "0")}},
    {"blend, factor that no picture shows", {{kBlend, 0.0019f}}, {note(0, "at most 0.0019")}},
    {"blend, factor that a picture shows", {{kBlend, 0.002f}}, {}},
    {"blend, texture 0", {{kBlend, 1.0f, 0}}, {note(0, "0")}},
    {"blend, texture 1 in one pixel", {{kBlend, 1.0f, 1}}, {}},
    {"blend, vertices 0", {{kBlend, 1.0f, 255, 0.0f}}, {note(0, "0")}},
    {"blend, vertices seen at some corners", {{kBlend, 1.0f, 255, 0.5f}}, {}},
    {"blend, the product is too little", {{kBlend, 0.1f, 25, 0.1f}}, {note(0, "at most 0.00098")}},
    {"blend: the cutoff counts for nothing", {{kBlend, 0.1f, 255, 1.0f, 1.0f}}, {}},
    {"mask at its cutoff", {{kMask, 0.5f}}, {}},
    {"mask below its cutoff", {{kMask, 0.49f}}, {note(0, "at most 0.49 (cutoff 0.5)")}},
    {"mask, factor 0", {{kMask, 0.0f}}, {note(0, "0 (cutoff 0.5)")}},
    {"mask, cutoff 0 lets all be seen", {{kMask, 0.0f, 255, 1.0f, 0.0f}}, {}},
    {"mask, texture below", {{kMask, 1.0f, 51}}, {note(0, "at most 0.2 (cutoff 0.5)")}},
    {"mask, texture above", {{kMask, 1.0f, 128}}, {}},
    {"mask, vertices below", {{kMask, 1.0f, 255, 0.25f}}, {note(0, "at most 0.25 (cutoff 0.5)")}},
    {"mask, the product is below", {{kMask, 0.8f, 204, 0.75f}}, {note(0, "at most 0.48 (cutoff 0.5)")}},
    {"a hidden part of an opaque body", {{kOpaque}, {kBlend, 0.0f}}, {}},
    {"a hidden part of a glassy body", {{kBlend, 0.1f}, {kMask, 0.0f}}, {}},
    {"all parts hidden, each in its way",
     {{kBlend, 0.0f}, {kMask, 0.2f}, {kBlend, 1.0f, 0}},
     {note(0, "0"), note(1, "at most 0.2 (cutoff 0.5)"), note(2, "0")}},
};

INSTANTIATE_TEST_SUITE_P(All, HiddenCharacter, testing::ValuesIn(kCases));

TEST(HiddenImport, UnusedMaterialsAreUnchanged) {
  Character cube = cubeOf({{kBlend, 0.0f}});
  cube.materials.push_back({.name = "unused"});
  cube.materials.push_back({.name = "unused too", .baseColor = glm::vec4(0.0f), .alphaMode = kBlend});
  gltf::Notes notes;
  gltf::showHiddenCharacter(cube, notes);
  EXPECT_EQ(notes.lines(), std::vector{note(0, "0")});
  EXPECT_TRUE(cube.materials[0].shownOpaque);
  EXPECT_FALSE(cube.materials[1].shownOpaque || cube.materials[2].shownOpaque);
}

TEST(HiddenImport, IsDetectedByTheImport) {
  test::Post post = test::makePost();
  post.file.json["materials"].push_back(
      {{"name", "skin"}, {"alphaMode", "BLEND"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0}}}}});
  post.primitive()["material"] = 0;
  const test::TemporaryFolder folder;
  const auto imported = importGltf(folder.write("post.glb", post.file.glb()));
  ASSERT_TRUE(imported.ok()) << imported.error().text();
  EXPECT_TRUE(imported.value()->materials[0].shownOpaque);
  EXPECT_EQ(imported.value()->ignored,
            std::vector<std::string>{"material \"skin\": its alpha of 0 would hide the whole character; shown opaque"});
}

}  // namespace
}  // namespace sinew
