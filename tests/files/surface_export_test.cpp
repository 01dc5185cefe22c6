// tests/files/surface_export_test.cpp: contents of .obj, .ply and .glb exports, read back independently.

#include "sinew/files/surface_export.h"

#include <bit>
#include <charconv>
#include <cstring>
#include <sstream>

#include <gtest/gtest.h>

#include "core/files/disk/atomic_file.h"
#include "core/files/json/json.h"
#include "sinew/files/gltf_import.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/mesh_checks.h"
#include "tests/support/temporary_folder.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

/// The tube with a seam, in two materials with awkward names, one of them with an embedded texture.
std::shared_ptr<const Character> twoMaterialTube() {
  Character character = *test::makeTube();
  character.name = "tube # 1";
  Texture texture;
  texture.name = "checks";
  texture.width = 2;
  texture.height = 2;
  texture.rgba = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 8, 7, 255};
  texture.wrapU = TextureWrap::kClampToEdge;
  texture.wrapV = TextureWrap::kMirroredRepeat;
  character.textures = {Texture{}, texture};  // The first one is unused.
  character.materials.assign(3, Material{});
  character.materials[0].name = character.materials[2].name = "skin tone";
  character.materials[0].baseColorTexture = 1;
  character.materials[2].baseColor = {0.5f, 0.25f, 1.0f, 0.5f};
  character.materials[2].alphaMode = AlphaMode::kBlend;
  for (std::size_t t = 0; t < character.mesh.triangles.size(); ++t)
    character.mesh.triangles[t].material = t % 3 == 0 ? 2 : 0;
  return std::make_shared<const Character>(std::move(character));
}

class SurfaceExport : public ::testing::Test {
 protected:
  void SetUp() override {
    character_ = twoMaterialTube();
    Smoother smoother(character_);
    Rig rig = test::randomRig(*character_, {}, 4);
    rig.smoothing.depth = 3;
    ASSERT_TRUE(smoother.prepare(rig).ok());
    smoother.smooth(bindPose(character_->skeleton), surface_);
  }

  std::string exported(const std::string& name) {
    const auto written = exportSurface(surface_, *character_, folder_ / name);
    EXPECT_TRUE(written.ok()) << written.error().text();
    return written ? readWholeFile(folder_ / name, 1 << 26).value() : std::string();
  }

  const test::TemporaryFolder own_;
  const fs::path folder_ = own_.path();
  std::shared_ptr<const Character> character_;
  Surface surface_;
};

/// A minimal reader of .obj written from its specification.
struct Obj {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> uvs;
  std::vector<std::array<int, 3>> faces;  // Indices of positions, from 0.
  std::vector<std::array<int, 3>> uvFaces;
  std::vector<std::array<int, 3>> normalFaces;
  std::vector<std::string> materialOfFace;
  std::string library;
};

Obj readObj(const std::string& text) {
  Obj obj;
  std::string material;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v" || word == "vn") {
      glm::vec3 p;
      words >> p.x >> p.y >> p.z;
      (word == "v" ? obj.positions : obj.normals).push_back(p);
    } else if (word == "vt") {
      glm::vec2 uv;
      words >> uv.x >> uv.y;
      obj.uvs.push_back(uv);
    } else if (word == "usemtl") {
      words >> material;
    } else if (word == "mtllib") {
      words >> obj.library;
    } else if (word == "f") {
      std::array<std::array<int, 3>, 3> face{};
      for (std::size_t corner = 0; corner < 3; ++corner) {
        char slash = 0;
        words >> face[0][corner] >> slash >> face[1][corner] >> slash >> face[2][corner];
      }
      for (auto& part : face) {
        for (int& index : part) --index;
      }
      obj.faces.push_back(face[0]);
      obj.uvFaces.push_back(face[1]);
      obj.normalFaces.push_back(face[2]);
      obj.materialOfFace.push_back(material);
    }
  }
  return obj;
}

TEST_F(SurfaceExport, ObjIsClosedAndBitEqual) {
  const Obj obj = readObj(exported("tube.obj"));
  EXPECT_TRUE(test::sameBytes(obj.positions, surface_.positions));
  EXPECT_TRUE(test::sameBytes(obj.normals, surface_.normals));
  EXPECT_EQ(obj.faces, surface_.refinement->triangles);
  EXPECT_EQ(obj.normalFaces, obj.faces);
  EXPECT_TRUE(test::isClosed(obj.faces));
}

TEST_F(SurfaceExport, ObjKeepsSeamsInItsTextureCoordinates) {
  const Obj obj = readObj(exported("tube.obj"));
  const Refinement& refinement = *surface_.refinement;
  ASSERT_EQ(obj.uvs.size(), refinement.drawUv.size());
  EXPECT_GT(obj.uvs.size(), obj.positions.size()) << "the tube has a seam";
  for (std::size_t t = 0; t < obj.faces.size(); ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto drawn = static_cast<std::size_t>(obj.uvFaces[t][corner]);
      ASSERT_EQ(refinement.drawVertex[drawn], obj.faces[t][corner]);
      // Its v points upwards, glTF's downwards.
      ASSERT_EQ(obj.uvs[drawn], glm::vec2(refinement.drawUv[drawn].x, 1.0f - refinement.drawUv[drawn].y));
    }
  }
}

TEST_F(SurfaceExport, ObjNamesMaterialsAndWritesTheirTextures) {
  const Obj obj = readObj(exported("my tube.obj"));
  ASSERT_EQ(obj.library, "my_tube.mtl");
  for (std::size_t t = 0; t < obj.faces.size(); ++t) {
    ASSERT_EQ(obj.materialOfFace[t], (t / 9) % 3 == 0 ? "skin_tone_2" : "skin_tone") << t;
  }
  const std::string mtl = readWholeFile(folder_ / obj.library, 1 << 20).value();
  EXPECT_NE(mtl.find("newmtl skin_tone\n"), std::string::npos) << mtl;
  EXPECT_NE(mtl.find("map_Kd my_tube_0.png\n"), std::string::npos) << mtl;
  EXPECT_NE(mtl.find("newmtl skin_tone_2\nKd 0.5 0.25 1\n"), std::string::npos) << mtl;
  EXPECT_NE(mtl.find("d 0.5\n"), std::string::npos) << mtl;
  EXPECT_TRUE(readWholeFile(folder_ / "my_tube_0.png", 1 << 20)->starts_with("\x89PNG"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 3);
}

template <class Value>
Value readAt(const std::string& bytes, std::size_t at) {
  Value value{};
  EXPECT_LE(at + sizeof(Value), bytes.size());
  if (at + sizeof(Value) <= bytes.size()) std::memcpy(&value, bytes.data() + at, sizeof(Value));
  return value;
}

TEST_F(SurfaceExport, PlyContainsEveryDrawnVertexAndTriangle) {
  const std::string bytes = exported("tube.PLY");
  const Refinement& refinement = *surface_.refinement;
  const std::string end = "end_header\n";
  const std::size_t header = bytes.find(end) + end.size();
  const std::string text = bytes.substr(0, header);
  EXPECT_TRUE(text.starts_with("ply\nformat binary_little_endian 1.0\n"));
  EXPECT_NE(text.find("element vertex " + std::to_string(refinement.drawVertex.size()) + '\n'), std::string::npos);
  EXPECT_NE(text.find("element face " + std::to_string(refinement.drawTriangles.size()) + '\n'), std::string::npos);
  const std::size_t faces = header + refinement.drawVertex.size() * 32;
  ASSERT_EQ(bytes.size(), faces + refinement.drawTriangles.size() * 13);
  for (std::size_t d = 0; d < refinement.drawVertex.size(); ++d) {
    const auto row = readAt<std::array<float, 8>>(bytes, header + d * 32);
    const auto vertex = static_cast<std::size_t>(refinement.drawVertex[d]);
    ASSERT_EQ(glm::vec3(row[0], row[1], row[2]), surface_.positions[vertex]);
    ASSERT_EQ(glm::vec3(row[3], row[4], row[5]), surface_.normals[vertex]);
    ASSERT_EQ(glm::vec2(row[6], row[7]), glm::vec2(refinement.drawUv[d].x, 1.0f - refinement.drawUv[d].y));
  }
  for (std::size_t t = 0; t < refinement.drawTriangles.size(); ++t) {
    ASSERT_EQ(bytes[faces + t * 13], '\3');
    ASSERT_EQ((readAt<std::array<std::uint32_t, 3>>(bytes, faces + t * 13 + 1)), refinement.drawTriangles[t]);
  }
}

TEST_F(SurfaceExport, GlbLayoutMatchesItsHeader) {
  const std::string bytes = exported("tube.glb");
  ASSERT_EQ(readAt<std::uint32_t>(bytes, 0), 0x46546C67u);
  EXPECT_EQ(readAt<std::uint32_t>(bytes, 4), 2u);
  EXPECT_EQ(readAt<std::uint32_t>(bytes, 8), bytes.size());
  const auto jsonLength = readAt<std::uint32_t>(bytes, 12);
  EXPECT_EQ(jsonLength % 4, 0u);
  const auto json = Json::parse(bytes.substr(20, jsonLength));
  ASSERT_TRUE(json.ok()) << json.error().text();
  const auto binaryLength = readAt<std::uint32_t>(bytes, 20 + jsonLength);
  EXPECT_EQ(28 + jsonLength + binaryLength, bytes.size());
  ASSERT_EQ(json->at("meshes").items().at(0).at("primitives").items().size(), 2u);
  EXPECT_EQ(json->at("images").items().size(), 1u);

  const Json position = json->at("accessors").items().at(0);
  const Bounds bounds = boundsOf(surface_.positions);
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    EXPECT_EQ(position.at("min").items().at(axis).number(1e9), static_cast<double>(bounds.low[i]));
    EXPECT_EQ(position.at("max").items().at(axis).number(1e9), static_cast<double>(bounds.high[i]));
  }
}

TEST_F(SurfaceExport, GlbCanBeImported) {
  exported("tube.glb");
  const auto imported = importGltf(folder_ / "tube.glb");
  ASSERT_TRUE(imported.ok()) << imported.error().text();
  const Character& back = *imported.value();
  EXPECT_EQ(back.mesh.triangles.size(), surface_.refinement->triangles.size());
  EXPECT_TRUE(test::isClosed(test::trianglesOf(back.mesh)));
  const Bounds was = boundsOf(surface_.positions);
  const Bounds is = boundsOf(back.mesh.positions);
  EXPECT_EQ(is.low, was.low);
  EXPECT_EQ(is.high, was.high);
  ASSERT_EQ(back.materials.size(), 2u);
  EXPECT_EQ(back.materials[1].baseColor, glm::vec4(0.5f, 0.25f, 1.0f, 0.5f));
  EXPECT_EQ(back.materials[1].alphaMode, AlphaMode::kBlend);
  ASSERT_EQ(back.textures.size(), 1u);
  EXPECT_EQ(back.textures[0].rgba, character_->textures[1].rgba);
  EXPECT_EQ(back.textures[0].wrapU, TextureWrap::kClampToEdge);
  EXPECT_EQ(back.textures[0].wrapV, TextureWrap::kMirroredRepeat);
  EXPECT_TRUE(back.ignored.empty()) << back.ignored.front();
}

TEST_F(SurfaceExport, InvalidUtf8NamesAreRepaired) {
  Character named = *character_;
  named.name = "tube\xff";
  for (Material& material : named.materials) material.name = "skin\xfe";
  for (Texture& texture : named.textures) texture.name = "\xff";
  ASSERT_TRUE(exportSurface(surface_, named, folder_ / "tube.glb").ok());
  const auto imported = importGltf(folder_ / "tube.glb");
  ASSERT_TRUE(imported.ok()) << imported.error().text();
  EXPECT_EQ(imported.value()->materials[0].name, "skin\xEF\xBF\xBD");
}

/// The same tube, flat shaded: every format has the split normals, and the .obj stays closed.
class CreasedExport : public SurfaceExport {
 protected:
  void SetUp() override {
    SurfaceExport::SetUp();
    Smoother smoother(character_);
    Rig rig = test::randomRig(*character_, {}, 4);
    rig.smoothing.creaseAngle = 20.0f;
    ASSERT_TRUE(smoother.prepare(rig).ok());
    smooth_ = surface_;
    smoother.smooth(bindPose(character_->skeleton), surface_);
    ASSERT_EQ(surface_.shadingNormals.size(), surface_.refinement->drawVertex.size());
  }
  Surface smooth_;
};

TEST_F(CreasedExport, ObjStaysClosedAndHasNormalsPerWedge) {
  const Obj obj = readObj(exported("tube.obj"));
  EXPECT_TRUE(test::sameBytes(obj.positions, smooth_.positions));
  EXPECT_EQ(obj.faces, smooth_.refinement->triangles);
  EXPECT_TRUE(test::isClosed(obj.faces));
  EXPECT_TRUE(test::sameBytes(obj.normals, surface_.shadingNormals));
  EXPECT_GT(obj.normals.size(), smooth_.refinement->drawVertex.size());
  for (std::size_t t = 0; t < obj.faces.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      ASSERT_EQ(obj.normalFaces[t][i], static_cast<int>(surface_.refinement->drawTriangles[t][i]));
    }
  }
}

TEST_F(CreasedExport, PlyAndGlbHaveTheSameNormals) {
  const std::vector<int>& drawn = surface_.refinement->drawVertex;
  const std::string ply = exported("tube.ply");
  const std::size_t rows = ply.find("end_header\n") + 11;
  for (std::size_t d = 0; d < drawn.size(); ++d) {
    const auto row = readAt<std::array<float, 8>>(ply, rows + d * 32);
    ASSERT_EQ(glm::vec3(row[0], row[1], row[2]), smooth_.positions[static_cast<std::size_t>(drawn[d])]);
    ASSERT_EQ(glm::vec3(row[3], row[4], row[5]), surface_.shadingNormals[d]);
  }
  const std::string glb = exported("tube.glb");
  const auto jsonLength = readAt<std::uint32_t>(glb, 12);
  const auto json = Json::parse(glb.substr(20, jsonLength));
  ASSERT_TRUE(json.ok()) << json.error().text();
  const Json attributes = json->at("meshes").items().at(0).at("primitives").items().at(0).at("attributes");
  const auto index = static_cast<std::size_t>(attributes.at("NORMAL").number(-1));
  const Json accessor = json->at("accessors").items().at(index);
  ASSERT_EQ(accessor.at("count").number(0), static_cast<double>(drawn.size()));
  const auto view = static_cast<std::size_t>(accessor.at("bufferView").number(-1));
  const auto offset = static_cast<std::size_t>(json->at("bufferViews").items().at(view).at("byteOffset").number(-1));
  for (std::size_t d = 0; d < drawn.size(); ++d) {
    ASSERT_EQ(readAt<glm::vec3>(glb, 28 + jsonLength + offset + d * 12), surface_.shadingNormals[d]);
  }
}

TEST_F(SurfaceExport, OtherExtensionsAndUnwritablePathsAreErrors) {
  for (const char* name : {"tube.stl", "tube", "tube.obj.bak", ".obj"}) {
    EXPECT_FALSE(isExportName(name)) << name;
    EXPECT_FALSE(exportSurface(surface_, *character_, folder_ / name).ok()) << name;
  }
  for (const char* name : {"absent/tube.obj", "absent/tube.ply", "absent/tube.glb"}) {
    EXPECT_FALSE(exportSurface(surface_, *character_, folder_ / name).ok()) << name;
  }
  EXPECT_FALSE(exportSurface(Surface{}, *character_, folder_ / "empty.obj").ok());
  EXPECT_TRUE(fs::is_empty(folder_));
}

}  // namespace
}  // namespace sinew
