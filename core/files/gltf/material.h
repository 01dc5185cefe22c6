// core/files/gltf/material.h: materials and the textures they use.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <tiny_gltf.h>

#include "core/files/gltf/file.h"
#include "core/files/gltf/refusal.h"
#include "sinew/character/character.h"
#include "sinew/character/material.h"

namespace sinew::gltf {

// Which texture coordinates a map is read with (KHR_texture_transform).

/// A set of texture coordinates, and what is done to them.
struct UvSource {
  int set = 0;                                                    ///< TEXCOORD_n
  std::array<double, 6> transform{1.0, 0.0, 0.0, 0.0, 1.0, 0.0};  ///< KHR_texture_transform: two rows of u, v, 1.

  [[nodiscard]] glm::vec2 apply(double u, double v) const;
};

/// @param transform  the extension's object, or null
[[nodiscard]] UvSource uvSourceOf(int set, const tinygltf::Value* transform);

/// From the coordinates that `from` gives to those of `to`, as in TextureMap::place. nullopt: of another set, or `from`
/// has collapsed them.
[[nodiscard]] std::optional<std::array<glm::vec3, 2>> placeFrom(const UvSource& from, const UvSource& to);

struct Materials {
  std::vector<Material> materials;  ///< As numbered in the file.
  std::vector<UvSource> uvSources;  ///< [materials] of the base color; without one, of the first map that is there.
  std::vector<Texture> textures;    ///< Those the materials use.
};

enum class Images { kRead, kLeftOut };

/// A texture that cannot be read is noted and left out; a uri outside the folder is refused.
/// @param images  kLeftOut: the materials have no textures, for callers that want the uv sources alone.
[[nodiscard]] Materials readMaterials(File& file, Notes& notes, Images images = Images::kRead);

}  // namespace sinew::gltf
