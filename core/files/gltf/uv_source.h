// core/files/gltf/uv_source.h: which texture coordinates a map is read with (KHR_texture_transform).
#pragma once

#include <array>
#include <optional>

#include <tiny_gltf.h>

#include "sinew/character/material.h"

namespace sinew::gltf {

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

}  // namespace sinew::gltf
