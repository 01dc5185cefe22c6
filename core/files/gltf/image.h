// core/files/gltf/image.h: PNG, JPEG and WebP -> RGBA.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/files/gltf/glb.h"
#include "sinew/geometry/result.h"

namespace sinew::gltf {

struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
  std::string mimeType;
};

inline constexpr int kMaxImageSide = 8192;  ///< Pixels.

/// Decodes an image; the dimensions and what it would unpack to are checked before. Error: reason only.
/// @param maxPixels what is left of the budget for all images of the file.
[[nodiscard]] Result<Image> decodeImage(Bytes encoded, std::size_t maxPixels);

}  // namespace sinew::gltf
