// tests/support/characters/gltf_builder.h: small glTF files for tests, made in memory.
#pragma once

#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "sinew/geometry/geometry.h"

namespace sinew::test {

/// Collects binary data and the JSON that describes it; tests may modify the JSON.
class GltfBuilder {
 public:
  GltfBuilder();

  nlohmann::ordered_json json;

  /// Appends bytes, aligned to 4; returns the bufferView.
  int view(std::string_view bytes);
  /// Appends tightly packed components; returns the accessor.
  template <class Component>
  int accessor(const std::vector<Component>& components, const std::string& type, bool normalized = false) {
    return accessorOfBytes(rawBytes(components), componentType(Component{}), components.size(), type, normalized);
  }
  template <class Component>
  int viewOf(const std::vector<Component>& components) {
    return view(rawBytes(components));
  }

  [[nodiscard]] const std::string& binary() const { return binary_; }
  [[nodiscard]] std::string glb() const;   ///< Buffer 0 in the binary chunk.
  [[nodiscard]] std::string gltf() const;  ///< Buffer 0 as a data: uri.
  [[nodiscard]] std::string gltfWithBufferAt(const std::string& uri) const;

 private:
  template <class Component>
  static std::string rawBytes(const std::vector<Component>& components) {
    std::string bytes(components.size() * sizeof(Component), '\0');
    if (!components.empty()) std::memcpy(bytes.data(), components.data(), bytes.size());
    return bytes;
  }
  static int componentType(std::int8_t) { return 5120; }
  static int componentType(std::uint8_t) { return 5121; }
  static int componentType(std::int16_t) { return 5122; }
  static int componentType(std::uint16_t) { return 5123; }
  static int componentType(std::uint32_t) { return 5125; }
  static int componentType(float) { return 5126; }
  int accessorOfBytes(const std::string& bytes, int componentType, std::size_t components, const std::string& type,
                      bool normalized);

  std::string binary_;
};

[[nodiscard]] std::string base64(std::string_view bytes);

/// A square post, 1 x 2 x 1, closed, bent by two joints; what the traps are cut into.
///   nodes: 0 mesh (skin 0), 1 root joint "hip" at the origin, 2 its child "knee" at (0,1,0)
///   mesh 0: 12 vertices in three rings at y = 0, 1, 2, 20 triangles; material none
///   clip 0 "bend": knee turns about x to 90 degrees in 1 s, linear
struct Post {
  GltfBuilder file;
  std::vector<float> positions;        // [12 * 3]
  std::vector<std::uint16_t> indices;  // [60]
  std::vector<std::uint8_t> joints;    // [12 * 4]
  std::vector<float> weights;          // [12 * 4]

  [[nodiscard]] nlohmann::ordered_json& primitive() { return file.json["meshes"][0]["primitives"][0]; }
  [[nodiscard]] nlohmann::ordered_json& attributes() { return primitive()["attributes"]; }
};
[[nodiscard]] Post makePost();

}  // namespace sinew::test
