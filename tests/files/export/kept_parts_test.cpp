// tests/files/export/kept_parts_test.cpp: content kept when exporting files with several meshes.
#include <cmath>
#include <limits>
#include <map>

#include <nlohmann/json.hpp>

#include "core/files/disk/atomic_file.h"
#include "tests/files/export/export_scenes.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/characters/gltf_oracle.h"
#include "tests/support/temporary_folder.h"

namespace sinew::test {
namespace {

using nlohmann::ordered_json;

class KeptParts : public ::testing::Test {
 protected:
  /// Writes the modified post, opens it, exports it without muscles.
  SkinnedExportReport exported(const SkinnedExportSettings& settings, int depth = 1, const char* name = "out.glb") {
    EXPECT_TRUE(writeFileAtomically(source_, post_.file.glb()).ok());
    const auto character = importGltf(source_);
    EXPECT_TRUE(character.ok()) << character.error().text();
    Rig rig;
    rig.smoothing.depth = depth;
    rig.smoothing.patch = PatchKind::kFlat;
    const auto report =
        exportSkinned(source_, character.value(), *character.value(), rig, settings, folder_.path() / name);
    EXPECT_TRUE(report.ok()) << report.error().text();
    return report.ok() ? report.value() : SkinnedExportReport{};
  }

  [[nodiscard]] ordered_json json(const char* name = "out.glb") const {
    const std::string file = readWholeFile(folder_.path() / name, 1 << 26).value();
    const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(file[i])); };
    const std::size_t size = byte(12) + (byte(13) << 8U) + (byte(14) << 16U);
    return ordered_json::parse(file.substr(20, size));
  }

  /// Without muscles and at depth 1 the exported file moves like its source.
  void expectPlaysAsTheSource(const char* name = "out.glb") const {
    const GltfOracle before(source_);
    const GltfOracle after(folder_.path() / name);
    ASSERT_EQ(after.clips(), before.clips());
    for (const double time : {0.0, 0.3, 0.7, 1.0}) {
      const auto old = before.triangles(0, time);
      const auto now = after.triangles(0, time);
      ASSERT_EQ(now.size(), old.size());
      for (std::size_t t = 0; t < old.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(glm::distance(now[t][i], old[t][i]), 1e-5);
      }
    }
  }

  TemporaryFolder folder_;
  std::filesystem::path source_ = folder_.path() / "post.glb";
  Post post_ = makePost();
};

const SkinnedExportSettings kOriginal{.mesh = ExportMesh::kOriginal};

/// Adds a board without a skin: below the knee, and a second one elsewhere, mirrored.
void addBoards(Post& post) {
  ordered_json board;
  board["attributes"]["POSITION"] =
      post.file.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0.5f}, "VEC3");
  board["indices"] = post.file.accessor(std::vector<std::uint16_t>{0, 1, 2, 0, 2, 3}, "SCALAR");
  post.file.json["meshes"].push_back({{"name", "board"}, {"primitives", ordered_json::array({board})}});
  post.file.json["nodes"].push_back({{"name", "on knee"}, {"mesh", 1}, {"translation", {0, 0.5, 2}}});
  post.file.json["nodes"].push_back({{"name", "alone"}, {"mesh", 1}, {"scale", {-1, 2, 1}}});
  post.file.json["nodes"][2]["children"] = {3};
  post.file.json["scenes"][0]["nodes"] = {0, 1, 4};
}

TEST_F(KeptParts, MeshesWithoutASkinGetOneAndMoveTheSame) {
  addBoards(post_);
  for (const ExportMesh mesh : {ExportMesh::kRefined, ExportMesh::kOriginal}) {
    exported({.mesh = mesh});
    const ordered_json after = json();
    for (const std::size_t node : {0u, 3u, 4u}) EXPECT_TRUE(after["nodes"][node].contains("skin")) << node;
    EXPECT_EQ(after["nodes"][0]["skin"], 0);
    EXPECT_NE(after["nodes"][3]["mesh"], after["nodes"][4]["mesh"]) << "one mesh with two different skins";
    EXPECT_EQ(after["meshes"][after["nodes"][4]["mesh"].get<std::size_t>()]["name"], "board");
    expectPlaysAsTheSource();
  }
}

TEST_F(KeptParts, AttributesAreInterpolatedLinearly) {
  std::vector<float> uv;
  std::vector<float> color;
  std::vector<float> tangent;
  const auto uvOf = [](const float* p) { return std::array{0.3f * p[0] + p[2], 0.1f - 0.4f * p[1]}; };
  for (std::size_t v = 0; v < post_.positions.size(); v += 3) {
    const float* p = &post_.positions[v];
    uv.insert(uv.end(), {uvOf(p)[0], uvOf(p)[1]});
    color.insert(color.end(), {0.25f + 0.2f * p[1], 0.5f, 0.5f + 0.1f * p[0]});
    tangent.insert(tangent.end(), {0.0f, 1.0f, 0.0f, -1.0f});
  }
  post_.attributes()["TEXCOORD_0"] = post_.file.accessor(std::vector<float>(uv.size(), 0.5f), "VEC2");
  post_.attributes()["TEXCOORD_1"] = post_.file.accessor(uv, "VEC2");
  post_.attributes()["COLOR_0"] = post_.file.accessor(color, "VEC3");
  post_.attributes()["TANGENT"] = post_.file.accessor(tangent, "VEC4");
  post_.attributes()["_OWN"] = post_.file.accessor(uv, "VEC2");
  const SkinnedExportReport report = exported({}, 3);
  ASSERT_EQ(report.left.size(), 1U);
  EXPECT_NE(report.left[0].find("_OWN"), std::string::npos);
  EXPECT_EQ(report.triangles, 9 * 20);
  const tinygltf::Model model = rawModel(folder_.path() / "out.glb");
  const auto& attributes = model.meshes[0].primitives[0].attributes;
  EXPECT_FALSE(attributes.contains("_OWN"));
  const auto positions = rawNumbers<float>(model, attributes.at("POSITION"));
  const auto normals = rawNumbers<float>(model, attributes.at("NORMAL"));
  const auto uvs = rawNumbers<float>(model, attributes.at("TEXCOORD_1"));
  const auto colors = rawNumbers<float>(model, attributes.at("COLOR_0"));
  const auto tangents = rawNumbers<float>(model, attributes.at("TANGENT"));
  const std::size_t count = positions.size() / 3;
  EXPECT_GT(count, 12U);
  ASSERT_EQ(colors.size(), 3 * count);
  for (std::size_t v = 0; v < count; ++v) {
    const float* p = &positions[3 * v];
    EXPECT_NEAR(uvs[2 * v], uvOf(p)[0], 1e-5f);
    EXPECT_NEAR(uvs[2 * v + 1], uvOf(p)[1], 1e-5f);
    EXPECT_NEAR(colors[3 * v], 0.25f + 0.2f * p[1], 1e-5f);
    EXPECT_NEAR(colors[3 * v + 2], 0.5f + 0.1f * p[0], 1e-5f);
    const float* t = &tangents[4 * v];
    EXPECT_NEAR(t[0] * normals[3 * v] + t[1] * normals[3 * v + 1] + t[2] * normals[3 * v + 2], 0.0f, 1e-5f);
    EXPECT_NEAR(t[0] * t[0] + t[1] * t[1] + t[2] * t[2], 1.0f, 1e-5f);
    EXPECT_EQ(t[3], -1.0f);
  }
}

TEST_F(KeptParts, MorphTargetsAreKeptWithBothMeshes) {
  const int target = post_.file.accessor(std::vector<float>(post_.positions.size(), 0.25f), "VEC3");
  post_.file.json["accessors"][static_cast<std::size_t>(target)]["min"] = {0.25, 0.25, 0.25};
  post_.file.json["accessors"][static_cast<std::size_t>(target)]["max"] = {0.25, 0.25, 0.25};
  post_.primitive()["targets"] = ordered_json::array({ordered_json{{"POSITION", target}}});
  post_.file.json["meshes"][0]["weights"] = {0.5};
  ordered_json& clip = post_.file.json["animations"][0];
  clip["samplers"].push_back(
      {{"input", clip["samplers"][0]["input"]}, {"output", post_.file.accessor(std::vector<float>{0, 1}, "SCALAR")}});
  clip["channels"].push_back({{"sampler", 1}, {"target", {{"node", 0}, {"path", "weights"}}}});
  const SkinnedExportReport refined = exported({});
  EXPECT_TRUE(refined.left.empty());
  ordered_json after = json();
  EXPECT_EQ(after["meshes"][0]["primitives"][0]["targets"].size(), 1U);
  EXPECT_EQ(after["meshes"][0]["weights"], ordered_json({0.5}));
  EXPECT_EQ(after["animations"][0]["channels"].size(), 2U);
  expectPlaysAsTheSource();
  EXPECT_TRUE(exported(kOriginal).left.empty());
  after = json();
  EXPECT_EQ(after["meshes"][0]["weights"], ordered_json({0.5}));
  EXPECT_EQ(after["animations"][0]["channels"].size(), 2U);
  const tinygltf::Model before = rawModel(source_);
  const tinygltf::Model model = rawModel(folder_.path() / "out.glb");
  EXPECT_EQ(rawBytes(model, model.meshes[0].primitives[0].targets.at(0).at("POSITION")), rawBytes(before, target));
}

TEST_F(KeptParts, NonFiniteValuesAreReplacedInTheOriginalMesh) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  const std::size_t count = post_.positions.size() / 3;
  std::vector<float> normals;
  for (std::size_t v = 0; v < count; ++v) normals.insert(normals.end(), {0.0f, 0.0f, 1.0f});
  normals[3] = kNan;
  std::vector<float> uv(2 * count, 0.5f);
  uv[2] = kInfinite;
  std::vector<float> colors(3 * count, 0.25f);
  colors[4] = kNan;
  std::vector<float> tangents;
  for (std::size_t v = 0; v < count; ++v) tangents.insert(tangents.end(), {0.0f, 1.0f, 0.0f, -1.0f});
  tangents[7] = kNan;
  std::vector<float> deltas(3 * count, 0.125f);
  deltas[5] = -kInfinite;
  post_.attributes()["NORMAL"] = post_.file.accessor(normals, "VEC3");
  post_.attributes()["TEXCOORD_0"] = post_.file.accessor(uv, "VEC2");
  post_.attributes()["COLOR_0"] = post_.file.accessor(colors, "VEC3");
  post_.attributes()["TANGENT"] = post_.file.accessor(tangents, "VEC4");
  const int sound = post_.file.accessor(std::vector<float>(2 * count, 0.75f), "VEC2");
  post_.attributes()["TEXCOORD_1"] = sound;
  const int target = post_.file.accessor(deltas, "VEC3");
  post_.primitive()["targets"] = ordered_json::array({ordered_json{{"POSITION", target}}});
  const SkinnedExportReport report = exported(kOriginal);
  const tinygltf::Model model = rawModel(folder_.path() / "out.glb");
  const tinygltf::Primitive& primitive = model.meshes[0].primitives[0];
  const auto numbers = [&](const std::map<std::string, int>& attributes, const char* name) {
    const std::vector<float> values = rawNumbers<float>(model, attributes.at(name));
    EXPECT_TRUE(std::ranges::all_of(values, [](float value) { return std::isfinite(value); })) << name;
    return values;
  };
  const auto moved = numbers(primitive.attributes, "NORMAL");
  EXPECT_NEAR(std::hypot(moved[3], moved[4], moved[5]), 1.0f, 1e-5f) << "as the surface has it";
  EXPECT_EQ(std::vector(moved.begin() + 6, moved.end()), std::vector(normals.begin() + 6, normals.end()));
  const auto uvs = numbers(primitive.attributes, "TEXCOORD_0");
  EXPECT_EQ(std::vector(uvs.begin(), uvs.begin() + 5), (std::vector{0.5f, 0.5f, 0.0f, 0.0f, 0.5f}));
  EXPECT_EQ(numbers(primitive.attributes, "COLOR_0")[4], 1.0f);
  const auto upright = numbers(primitive.attributes, "TANGENT");
  EXPECT_EQ(std::vector(upright.begin() + 4, upright.begin() + 8), (std::vector{1.0f, 0.0f, 0.0f, 1.0f}));
  EXPECT_EQ(numbers(primitive.targets.at(0), "POSITION")[5], 0.0f);
  EXPECT_EQ(rawBytes(model, primitive.attributes.at("TEXCOORD_1")), rawBytes(rawModel(source_), sound));
  ASSERT_EQ(report.left.size(), 5U);
  EXPECT_NE(report.left[0].find("COLOR_0: values that are not finite"), std::string::npos) << report.left[0];
}

TEST_F(KeptParts, ExtrasCamerasAndExtensionsAreKept) {
  ordered_json& file = post_.file.json;
  file["nodes"][1]["extras"] = {{"health", 12.5}, {"tags", {"a", "b"}}};
  file["meshes"][0]["extras"] = {{"lod", 0}};
  file["meshes"][0]["primitives"][0]["extras"] = {{"part", "body"}};
  file["animations"][0]["extras"] = "bends";
  file["asset"]["copyright"] = "someone";
  file["cameras"] = ordered_json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}}});
  file["nodes"].push_back({{"name", "eye"}, {"camera", 0}});
  file["scenes"][0]["nodes"] = {0, 1, 3};
  file["materials"] = ordered_json::array(
      {{{"name", "skin"}, {"extensions", {{"KHR_materials_sheen", {{"sheenRoughnessFactor", 0.25}}}}}}});
  post_.primitive()["material"] = 0;
  file["extensionsUsed"] = {"KHR_materials_sheen"};
  for (const ExportMesh mesh : {ExportMesh::kRefined, ExportMesh::kOriginal}) {
    exported({.mesh = mesh}, 2);
    const ordered_json after = json();
    EXPECT_EQ(after["nodes"], file["nodes"]);
    EXPECT_EQ(after["scenes"], file["scenes"]);
    EXPECT_EQ(after["cameras"], file["cameras"]);
    EXPECT_EQ(after["materials"], file["materials"]);
    EXPECT_EQ(after["extensionsUsed"], file["extensionsUsed"]);
    EXPECT_EQ(after["meshes"][0]["extras"], file["meshes"][0]["extras"]);
    EXPECT_EQ(after["meshes"][0]["primitives"][0]["extras"], file["meshes"][0]["primitives"][0]["extras"]);
    EXPECT_EQ(after["meshes"][0]["primitives"][0]["material"], 0);
    EXPECT_EQ(after["animations"][0]["extras"], "bends");
    EXPECT_EQ(after["asset"]["copyright"], "someone");
    EXPECT_EQ(after["skins"][0]["joints"], file["skins"][0]["joints"]);
  }
}

TEST_F(KeptParts, DataUsableByUnknownExtensionsKeepsItsIndex) {
  post_.file.json["extensionsUsed"] = {"ACME_cloth"};
  const int pins = post_.file.accessor(std::vector<float>{1, 2, 3}, "SCALAR");
  post_.file.json["meshes"][0]["extensions"]["ACME_cloth"] = {{"pins", pins}};
  exported({}, 2);
  const tinygltf::Model before = rawModel(source_);
  const tinygltf::Model after = rawModel(folder_.path() / "out.glb");
  EXPECT_EQ(json()["meshes"][0]["extensions"]["ACME_cloth"]["pins"], pins);
  for (int accessor = 0; accessor < static_cast<int>(before.accessors.size()); ++accessor) {
    EXPECT_EQ(rawBytes(after, accessor), rawBytes(before, accessor));
  }
}

TEST_F(KeptParts, ExternalImagesAreEmbeddedByteForByte) {
  const std::string image = std::string("\x89PNG\r\n\x1a\n", 8) + "not a whole image, but carried all the same";
  ASSERT_TRUE(writeFileAtomically(folder_.path() / "coat.png", image).ok());
  post_.file.json["images"] = ordered_json::array({{{"uri", "coat.png"}, {"name", "coat"}}});
  for (const char* name : {"out.glb", "out.gltf"}) {
    exported({}, 1, name);
    const tinygltf::Model model = rawModel(folder_.path() / name);
    ASSERT_EQ(model.images.size(), 1U);
    EXPECT_EQ(model.images[0].name, "coat");
    EXPECT_EQ(model.images[0].mimeType, "image/png");
    const auto& view = model.bufferViews.at(static_cast<std::size_t>(model.images[0].bufferView));
    const auto& data = model.buffers.at(0).data;
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(data.data()) + view.byteOffset, view.byteLength), image);
  }
}

TEST_F(KeptParts, LongClipsAreRefusedUnlessExcluded) {
  ordered_json& clips = post_.file.json["animations"];
  ordered_json longer = clips[0];
  longer["name"] = "sleep";
  longer["samplers"][0]["input"] = post_.file.accessor(std::vector<float>{0.0f, 7200.0f}, "SCALAR");
  clips.push_back(longer);
  ASSERT_TRUE(writeFileAtomically(source_, post_.file.glb()).ok());
  const auto character = importGltf(source_);
  ASSERT_TRUE(character.ok()) << character.error().text();
  const auto out = folder_.path() / "out.glb";
  const auto report = exportSkinned(source_, character.value(), *character.value(), Rig{}, {}, out);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().file, source_.string());
  EXPECT_EQ(report.error().reason, "last 7201 seconds together; expected at most 3600: choose fewer of them");
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_TRUE(exportSkinned(source_, character.value(), *character.value(), Rig{}, {.clips = {"bend"}}, out).ok());
}

TEST_F(KeptParts, MissingNormalsAreRefused) {
  for (const int accessor : {-1, 99}) {
    post_.attributes()["NORMAL"] = accessor;
    ASSERT_TRUE(writeFileAtomically(source_, post_.file.glb()).ok());
    const auto character = importGltf(source_);
    if (!character) continue;  // The import may refuse it first.
    const auto report =
        exportSkinned(source_, character.value(), *character.value(), Rig{}, kOriginal, folder_.path() / "out.glb");
    ASSERT_FALSE(report.ok());
    EXPECT_NE(report.error().place.find("NORMAL"), std::string::npos) << report.error().text();
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out.glb"));
  }
}

}  // namespace
}  // namespace sinew::test
