// core/io/gltf/material.h: materials and the base-color textures they use.
#pragma once

#include <array>
#include <vector>

#include "core/io/gltf/file.h"
#include "core/io/gltf/notes.h"
#include "sinew/character/character.h"

namespace sinew::gltf {

/// Where a material takes its base-color uv from.
struct UvSource {
  int set = 0;                                                    ///< TEXCOORD_n
  std::array<double, 6> transform{1.0, 0.0, 0.0, 0.0, 1.0, 0.0};  ///< KHR_texture_transform: two rows of u, v, 1.

  [[nodiscard]] glm::vec2 apply(double u, double v) const;
};

struct Materials {
  std::vector<Material> materials;  ///< As numbered in the file.
  std::vector<UvSource> uvSources;  ///< [materials]
  std::vector<Texture> textures;    ///< Those the materials use.
};

/// A texture that cannot be read is noted and left out; a uri outside the folder is refused.
[[nodiscard]] Materials readMaterials(File& file, Notes& notes);

}  // namespace sinew::gltf
