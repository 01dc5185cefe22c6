// core/files/gltf/material.h: images, textures and materials.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tiny_gltf.h>

#include "core/files/gltf/file.h"
#include "core/files/gltf/glb.h"
#include "sinew/character/character.h"
#include "sinew/character/material.h"
#include "sinew/geometry/result.h"

namespace sinew {

[[nodiscard]] inline bool startsWith(std::span<const std::uint8_t> bytes, std::string_view magic) {
  return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin(),
                                                    [](char a, auto b) { return static_cast<std::uint8_t>(a) == b; });
}

[[nodiscard]] inline bool isWebp(std::span<const std::uint8_t> bytes) {
  return bytes.size() > 8 && startsWith(bytes, "RIFF") && startsWith(bytes.subspan(8), "WEBP");
}

/// ".png" or ".jpg"; "" for others.
[[nodiscard]] inline std::string_view imageEnding(std::span<const std::uint8_t> bytes) {
  return startsWith(bytes, "\x89PNG") ? ".png" : startsWith(bytes, "\xff\xd8\xff") ? ".jpg" : "";
}

}  // namespace sinew

namespace sinew::gltf {

// Images.

struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
  std::string mimeType;
};

inline constexpr int kMaxImageSide = 8192;  ///< Pixels.

/// Checks dimensions and unpacked size, then decodes. Error: reason only. @param maxPixels  left for the file's images
[[nodiscard]] Result<Image> decodeImage(Bytes encoded, std::size_t maxPixels);

// Materials.

/// A set of texture coordinates and its KHR_texture_transform.
struct UvSource {
  int set = 0;                                                    ///< TEXCOORD_n
  std::array<double, 6> transform{1.0, 0.0, 0.0, 0.0, 1.0, 0.0};  ///< Two rows for u, v, 1.

  [[nodiscard]] glm::vec2 apply(double u, double v) const;
};

struct Materials {
  std::vector<Material> materials;  ///< As numbered in the file.
  std::vector<UvSource> uvSources;  ///< [materials] of the base color, else of the first map.
  std::vector<Texture> textures;    ///< In use.
};

enum class Images { kRead, kLeftOut };

/// Notes unreadable textures; refuses uris outside the folder. @param images  kLeftOut: for callers that need only uvs
[[nodiscard]] Materials readMaterials(File& file, Notes& notes, Images images = Images::kRead);

}  // namespace sinew::gltf
