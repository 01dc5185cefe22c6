// tests/support/characters/material_post.cpp: images written byte by byte, and a material that uses them all.

#include "tests/support/characters/material_post.h"

#include <algorithm>

#include <webp/encode.h>

namespace sinew::test {
namespace {

using nlohmann::ordered_json;

std::string bigEndian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

std::string chunk(const std::string& type, const std::string& data) {
  return bigEndian(static_cast<std::uint32_t>(data.size())) + type + data + bigEndian(0);
}

/// zlib stream of stored (not compressed) blocks.
std::string stored(const std::string& data) {
  std::string stream("\x78\x01", 2);
  for (std::size_t at = 0; at < data.size(); at += 65535) {
    const std::size_t length = std::min<std::size_t>(65535, data.size() - at);
    stream += static_cast<char>(at + length == data.size() ? 1 : 0);
    for (const std::size_t part : {length, ~length}) {
      stream += static_cast<char>(part & 0xff);
      stream += static_cast<char>(part >> 8 & 0xff);
    }
    stream += data.substr(at, length);
  }
  return stream + bigEndian(0);
}

}  // namespace

const std::string kOnePixel =
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR4nGPgavj/HwAEqgKJTas7mgAAAABJRU5ErkJggg==";

std::string storedPng(std::uint32_t width, std::uint32_t height, const std::string& pixels) {
  const std::string header = bigEndian(width) + bigEndian(height) + std::string("\x08\x02\x00\x00\x00", 5);
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", stored(pixels)) + chunk("IEND", "");
}

std::string losslessWebp(int width, int height, const std::vector<std::uint8_t>& rgba) {
  std::uint8_t* encoded = nullptr;
  const std::size_t size = WebPEncodeLosslessRGBA(rgba.data(), width, height, 4 * width, &encoded);
  std::string image(reinterpret_cast<const char*>(encoded), size);
  WebPFree(encoded);
  return image;
}

ordered_json mapAt(int texture, const ordered_json& transform) {
  ordered_json map{{"index", texture}};
  if (!transform.is_null()) map["extensions"]["KHR_texture_transform"] = transform;
  return map;
}

ordered_json wholeMaterial() {
  return {{"name", "all"},
          {"pbrMetallicRoughness", {{"metallicRoughnessTexture", mapAt(0)}, {"roughnessFactor", 0.5}}},
          {"normalTexture", {{"index", 1}, {"scale", -0.5}}},
          {"occlusionTexture", {{"index", 0}, {"strength", 0.25}}},
          {"emissiveTexture", mapAt(2, {{"scale", {2, 4}}, {"offset", {0.5, 0.25}}, {"rotation", 0.5}})},
          {"emissiveFactor", {1.0, 0.5, 0.0}},
          {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 3.0}}}}}};
}

Post materialPost(const ordered_json& material, int images, const std::string& image) {
  Post post = makePost();
  for (int i = 0; i < images; ++i) {
    post.file.json["images"].push_back({{"uri", image}});
    post.file.json["textures"].push_back({{"source", i}});
  }
  post.file.json["materials"].push_back(material);
  post.primitive()["material"] = 0;
  const int position = post.attributes()["POSITION"];
  const std::size_t corners = post.file.json["accessors"][static_cast<std::size_t>(position)]["count"];
  std::vector<float> uv;
  for (std::size_t i = 0; i < corners; ++i) uv.insert(uv.end(), {0.25f, 0.75f});
  post.attributes()["TEXCOORD_0"] = post.file.accessor(uv, "VEC2", true);
  return post;
}

}  // namespace sinew::test
