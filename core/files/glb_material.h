// core/files/glb_material.h: a character's material as glTF has it.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include <tiny_gltf.h>

#include "sinew/character/material.h"

namespace sinew {

/// A map's place as KHR_texture_transform says it: u, v -> turned, scaled, moved.
struct MapTransform {
  glm::dvec2 offset{0.0};
  double rotation = 0.0;  ///< Radians.
  glm::dvec2 scale{1.0};
};
/// nullopt: it slants, which the extension has no words for.
[[nodiscard]] std::optional<MapTransform> transformOf(const TextureMap& map);

/// @param textureNumber  the character's -> the file's
/// @param extensions  those it needs are added
[[nodiscard]] tinygltf::Material gltfMaterial(const Material& from, const std::map<int, int>& textureNumber,
                                              std::set<std::string>& extensions);

}  // namespace sinew
