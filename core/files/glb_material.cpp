// core/files/glb_material.cpp: materials, their maps and the extensions that these need.

#include "core/files/glb_material.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/files/json/json.h"

namespace sinew {
namespace {

tinygltf::Value pairValue(const glm::dvec2& pair) {
  return tinygltf::Value(tinygltf::Value::Array{tinygltf::Value(pair.x), tinygltf::Value(pair.y)});
}

/// Fills one of tinygltf's three kinds of texture info. @return whether the map is written
template <class Info>
bool putMap(const TextureMap& map, const std::map<int, int>& textureNumber, std::set<std::string>& extensions,
            Info& info) {
  const auto transform = map.texture >= 0 ? transformOf(map) : std::nullopt;
  if (!transform) return false;
  info.index = textureNumber.at(map.texture);
  if (map.place == TextureMap{}.place) return true;
  tinygltf::Value::Object written;
  written["offset"] = pairValue(transform->offset);
  written["rotation"] = tinygltf::Value(transform->rotation);
  written["scale"] = pairValue(transform->scale);
  info.extensions["KHR_texture_transform"] = tinygltf::Value(std::move(written));
  extensions.insert("KHR_texture_transform");
  return true;
}

void putEmissive(const Material& from, bool withMap, std::set<std::string>& extensions, tinygltf::Material& to) {
  glm::vec3 color = withMap || from.emissiveMap.texture < 0 ? glm::max(from.emissive, 0.0f) : glm::vec3(0.0f);
  const float strength = std::max({color.r, color.g, color.b, 1.0f});
  color /= strength;
  to.emissiveFactor = {static_cast<double>(color.r), static_cast<double>(color.g), static_cast<double>(color.b)};
  if (!(strength > 1.0f)) return;
  tinygltf::Value::Object written;
  written["emissiveStrength"] = tinygltf::Value(static_cast<double>(strength));
  to.extensions["KHR_materials_emissive_strength"] = tinygltf::Value(std::move(written));
  extensions.insert("KHR_materials_emissive_strength");
}

}  // namespace

std::optional<MapTransform> transformOf(const TextureMap& map) {
  constexpr double kSlant = 1e-5;  // of the lengths: places are floats
  const glm::dvec2 u(map.place[0].x, map.place[1].x), v(map.place[0].y, map.place[1].y);
  if (!(std::abs(glm::dot(u, v)) <= kSlant * glm::length(u) * glm::length(v))) return std::nullopt;
  MapTransform result;
  result.offset = {map.place[0].z, map.place[1].z};
  const bool along = glm::dot(u, u) > 0.0;
  result.rotation = along ? std::atan2(-u.y, u.x) : std::atan2(v.x, v.y);
  result.scale.x = glm::length(u);
  result.scale.y = std::sin(result.rotation) * v.x + std::cos(result.rotation) * v.y;
  return result;
}

tinygltf::Material gltfMaterial(const Material& from, const std::map<int, int>& textureNumber,
                                std::set<std::string>& extensions) {
  tinygltf::Material material;
  tinygltf::PbrMetallicRoughness& shading = material.pbrMetallicRoughness;
  material.name = validUtf8(from.name);
  const glm::dvec4 color = glm::clamp(from.baseColor, 0.0f, 1.0f);
  shading.baseColorFactor = {color.r, color.g, color.b, color.a};
  if (from.baseColorTexture >= 0) shading.baseColorTexture.index = textureNumber.at(from.baseColorTexture);
  const bool mapped = putMap(from.metallicRoughnessMap, textureNumber, extensions, shading.metallicRoughnessTexture) ||
                      from.metallicRoughnessMap.texture < 0;
  shading.metallicFactor = mapped ? static_cast<double>(std::clamp(from.metallic, 0.0f, 1.0f)) : 0.0;
  shading.roughnessFactor = static_cast<double>(std::clamp(from.roughness, 0.0f, 1.0f));
  putEmissive(from, putMap(from.emissiveMap, textureNumber, extensions, material.emissiveTexture), extensions,
              material);
  if (putMap(from.normalMap, textureNumber, extensions, material.normalTexture)) {
    material.normalTexture.scale = static_cast<double>(from.normalScale);
  }
  if (putMap(from.occlusionMap, textureNumber, extensions, material.occlusionTexture)) {
    material.occlusionTexture.strength = static_cast<double>(from.occlusionStrength);
  }
  if (from.alphaMode == AlphaMode::kBlend) material.alphaMode = "BLEND";
  if (from.alphaMode == AlphaMode::kMask) {
    material.alphaMode = "MASK";
    material.alphaCutoff = static_cast<double>(std::max(from.alphaCutoff, 0.0f));
  }
  material.doubleSided = from.doubleSided;
  if (from.unlit) {
    material.extensions["KHR_materials_unlit"] = tinygltf::Value(tinygltf::Value::Object{});
    extensions.insert("KHR_materials_unlit");
  }
  return material;
}

}  // namespace sinew
