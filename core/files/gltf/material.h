// core/files/gltf/material.h: materials and the textures they use.
#pragma once

#include <vector>

#include "core/files/gltf/file.h"
#include "core/files/gltf/notes.h"
#include "core/files/gltf/uv_source.h"
#include "sinew/character/character.h"

namespace sinew::gltf {

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
