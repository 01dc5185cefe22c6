// tests/fuzz/seeds.cpp: the post of the tests in all its forms, rigs and sets of muscles.

#include "tests/fuzz/seeds.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "sinew/files/rig_json.h"
#include "tests/support/characters/compressed_post.h"
#include "tests/support/characters/gltf_builder.h"
#include "tests/support/characters/material_post.h"
#include "tests/support/characters/morphing_post.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/characters/vrm_post.h"
#include "tests/support/rigs/random_animation.h"
#include "tests/support/rigs/random_documents.h"

namespace sinew::fuzz {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string readAll(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string dracoFile(test::DracoMethod method) {
  test::Post post = test::makePost();
  useDraco(post, dracoPost(post, method));
  return post.file.glb();
}

std::string avatar(const ordered_json& extensions) {
  test::Post post = test::makeMorphingPost(3, 1);
  post.file.json["extensions"] = extensions;
  return post.file.glb();
}

/// All maps, two images in the binary chunk, one of them also as WebP; colors; the second coordinates.
std::string paintedFile() {
  ordered_json material = test::wholeMaterial();
  material["pbrMetallicRoughness"]["baseColorTexture"] = test::mapAt(3, {{"scale", {2, 2}}, {"texCoord", 0}});
  material["alphaMode"] = "MASK";
  material["doubleSided"] = true;
  test::Post post = test::materialPost(material, 3);
  const std::string png = test::storedPng(2, 1, std::string("\x00\xff\x00\x00\x00\x00\xff", 7));
  const std::string webp = test::losslessWebp(2, 2, std::vector<std::uint8_t>(16, 200));
  post.file.json["images"].push_back({{"bufferView", post.file.view(png)}, {"mimeType", "image/png"}});
  post.file.json["images"].push_back({{"bufferView", post.file.view(webp)}, {"mimeType", "image/webp"}});
  post.file.json["samplers"].push_back({{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}});
  ordered_json texture{{"source", 3}, {"sampler", 0}};
  texture["extensions"]["EXT_texture_webp"]["source"] = 4;
  post.file.json["textures"].push_back(texture);
  post.file.json["materials"].push_back({{"extensions", {{"KHR_materials_unlit", ordered_json::object()}}}});
  post.attributes()["COLOR_0"] = post.file.accessor(std::vector<std::uint8_t>(48, 128), "VEC4", true);
  post.attributes()["TEXCOORD_1"] = post.file.accessor(std::vector<float>(24, 0.5f), "VEC2");
  return post.file.glb();
}

/// Cubic, stepped and linear keys of all three numbers of a node, whose transform is a matrix elsewhere.
std::string movedFile() {
  test::Post post = test::makePost();
  const int times = post.file.accessor(std::vector<float>{0.0f, 0.5f, 1.0f}, "SCALAR");
  ordered_json clip{{"name", "all"}};
  const auto add = [&](const char* path, const char* interpolation, const std::vector<float>& values,
                       const char* type) {
    clip["samplers"].push_back(
        {{"input", times}, {"output", post.file.accessor(values, type)}, {"interpolation", interpolation}});
    clip["channels"].push_back({{"sampler", clip["samplers"].size() - 1}, {"target", {{"node", 2}, {"path", path}}}});
  };
  add("translation", "STEP", {0, 1, 0, 0, 1.1f, 0, 0, 1, 0}, "VEC3");
  add("scale", "LINEAR", {1, 1, 1, 1, 1.2f, 1, 1, 1, 1}, "VEC3");
  std::vector<float> turns;
  for (int key = 0; key < 3; ++key) turns.insert(turns.end(), {0, 0, 0, 0, 0.38f, 0, 0, 0.92f, 0, 0, 0, 0});
  add("rotation", "CUBICSPLINE", turns, "VEC4");
  post.file.json["animations"].push_back(clip);
  post.file.json["nodes"].push_back({{"name", "above"},
                                     {"matrix", {1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0.5, 0, 0, 1}},
                                     {"children", ordered_json::array({0, 1})}});
  post.file.json["scenes"][0]["nodes"] = ordered_json::array({post.file.json["nodes"].size() - 1});
  return post.file.glb();
}

std::vector<Seed> characters() {
  const test::Post post = test::makePost();
  return {{"post.glb", post.file.glb()},
          {"post.gltf", post.file.gltf()},
          {"painted.glb", paintedFile()},
          {"moved.glb", movedFile()},
          {"avatar.glb", avatar(test::newVrm())},
          {"old_avatar.glb", avatar(test::oldVrm())},
          {"morphs.glb", test::makeMorphingPost(3, 1).file.glb()},
          {"sparse_morphs.glb", test::makeMorphingPost(2, 2, test::DeltaForm::kSparse).file.glb()},
          {"quantized_morphs.glb", test::makeMorphingPost(2, 3, test::DeltaForm::kShorts).file.glb()},
          {"draco.glb", dracoFile(test::DracoMethod::kEdgebreaker)},
          {"draco_sequential.glb", dracoFile(test::DracoMethod::kSequential)},
          {"meshopt.glb", test::meshoptPost().file.glb()},
          {"meshopt_indices.glb", test::meshoptPost(true).file.glb()}};
}

std::vector<Seed> filesOf(const fs::path& folder, std::string_view ending) {
  std::vector<Seed> all;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(ending)) all.push_back({name, readAll(entry.path())});
  }
  std::ranges::sort(all, {}, &Seed::name);
  return all;
}

/// The bundled ones, one that is keyed and driven in every way, one that holds all that a file may.
std::vector<Seed> rigs() {
  std::vector<Seed> all = filesOf(fs::path(SINEW_SOURCE_DIR) / "assets", ".rig.json");
  all.push_back({"animated.rig.json", rigToJson(test::animatedLimbRig(*test::makeLimb(), 3))});
  all.push_back({"any.rig.json", rigToJson(test::randomDocument(5))});
  return all;
}

}  // namespace

std::vector<Seed> seedsOf(std::string_view target) {
  if (target == "rig") return rigs();
  if (target == "set") return filesOf(fs::path(SINEW_SOURCE_DIR) / "assets" / "presets", ".json");
  return characters();
}

}  // namespace sinew::fuzz
