// tests/support/characters/gltf_builder.cpp: small glTF files for tests.

#include "tests/support/characters/gltf_builder.h"

#include <unistd.h>

#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

namespace sinew::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string littleEndian(std::size_t value) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

std::size_t componentsOf(const std::string& type) {
  if (type == "SCALAR") return 1;
  if (type == "MAT4") return 16;
  return static_cast<std::size_t>(type.back() - '0');
}

void addPostMesh(Post& post) {
  for (int ring = 0; ring < 3; ++ring) {
    for (int corner = 0; corner < 4; ++corner) {
      const float x = corner == 0 || corner == 3 ? -0.5f : 0.5f;
      const float z = corner < 2 ? 0.5f : -0.5f;
      for (const float c : {x, static_cast<float>(ring), z}) post.positions.push_back(c);
      for (const int joint : {0, 1, 0, 0}) post.joints.push_back(static_cast<std::uint8_t>(joint));
      const float knee = 0.5f * static_cast<float>(ring);
      for (const float weight : {1.0f - knee, knee, 0.0f, 0.0f}) post.weights.push_back(weight);
    }
  }
  const auto quad = [&](int a, int b, int c, int d) {
    for (const int i : {a, b, c, a, c, d}) post.indices.push_back(static_cast<std::uint16_t>(i));
  };
  for (int ring = 0; ring < 2; ++ring) {
    for (int corner = 0; corner < 4; ++corner) {
      const int next = (corner + 1) % 4;
      quad(4 * ring + corner, 4 * ring + next, 4 * ring + 4 + next, 4 * ring + 4 + corner);
    }
  }
  quad(3, 2, 1, 0);
  quad(8, 9, 10, 11);
}

}  // namespace

GltfBuilder::GltfBuilder() {
  json["asset"]["version"] = "2.0";
  json["buffers"] = ordered_json::array({{{"byteLength", 0}}});
}

int GltfBuilder::view(std::string_view bytes) {
  while (binary_.size() % 4 != 0) binary_ += '\0';
  json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}});
  binary_ += bytes;
  json["buffers"][0]["byteLength"] = binary_.size();
  return static_cast<int>(json["bufferViews"].size()) - 1;
}

int GltfBuilder::accessorOfBytes(const std::string& bytes, int componentType, std::size_t components,
                                 const std::string& type, bool normalized) {
  ordered_json accessor{{"bufferView", view(bytes)},
                        {"componentType", componentType},
                        {"count", components / componentsOf(type)},
                        {"type", type}};
  if (normalized) accessor["normalized"] = true;
  json["accessors"].push_back(accessor);
  return static_cast<int>(json["accessors"].size()) - 1;
}

std::string GltfBuilder::glb() const {
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string data = binary_;
  data.resize((data.size() + 3) / 4 * 4, '\0');
  std::string file = "glTF" + littleEndian(2) + littleEndian(12 + 8 + text.size() + 8 + data.size());
  file += littleEndian(text.size()) + "JSON" + text;
  return file + littleEndian(data.size()) + std::string("BIN\0", 4) + data;
}

std::string GltfBuilder::gltfWithBufferAt(const std::string& uri) const {
  ordered_json document = json;
  document["buffers"][0]["uri"] = uri;
  return document.dump();
}

std::string GltfBuilder::gltf() const {
  return gltfWithBufferAt("data:application/octet-stream;base64," + base64(binary_));
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 |
              (i + k < bytes.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i + k])) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? kAlphabet[group >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

Post makePost() {
  Post post;
  addPostMesh(post);
  GltfBuilder& file = post.file;
  std::vector<float> inverseBinds(32, 0.0f);
  for (const std::size_t i : {0u, 5u, 10u, 15u, 16u, 21u, 26u, 31u}) inverseBinds[i] = 1.0f;
  inverseBinds[16 + 13] = -1.0f;  // the knee stands at y = 1
  const float half = std::sqrt(0.5f);

  ordered_json primitive;
  primitive["attributes"]["POSITION"] = file.accessor(post.positions, "VEC3");
  primitive["attributes"]["JOINTS_0"] = file.accessor(post.joints, "VEC4");
  primitive["attributes"]["WEIGHTS_0"] = file.accessor(post.weights, "VEC4");
  primitive["indices"] = file.accessor(post.indices, "SCALAR");
  file.json["meshes"].push_back({{"primitives", ordered_json::array({primitive})}});
  file.json["skins"].push_back({{"joints", {1, 2}}, {"inverseBindMatrices", file.accessor(inverseBinds, "MAT4")}});
  file.json["nodes"].push_back({{"name", "post"}, {"mesh", 0}, {"skin", 0}});
  file.json["nodes"].push_back({{"name", "hip"}, {"children", {2}}});
  file.json["nodes"].push_back({{"name", "knee"}, {"translation", {0, 1, 0}}});
  file.json["scenes"].push_back({{"nodes", {0, 1}}});
  file.json["scene"] = 0;

  ordered_json clip{{"name", "bend"}};
  clip["samplers"].push_back({{"input", file.accessor(std::vector<float>{0.0f, 1.0f}, "SCALAR")},
                              {"output", file.accessor(std::vector<float>{0, 0, 0, 1, half, 0, 0, half}, "VEC4")}});
  clip["channels"].push_back({{"sampler", 0}, {"target", {{"node", 2}, {"path", "rotation"}}}});
  file.json["animations"].push_back(clip);
  return post;
}

}  // namespace sinew::test
