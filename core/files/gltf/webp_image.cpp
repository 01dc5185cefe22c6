// core/files/gltf/webp_image.cpp: libwebp's simple decoder, into memory of the size that its header tells.

#include "core/files/gltf/webp_image.h"

#include <webp/decode.h>

#include "core/geometry/at.h"

namespace sinew::gltf {

std::optional<std::pair<int, int>> webpSize(std::span<const std::uint8_t> bytes) {
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK || features.has_animation != 0) {
    return std::nullopt;
  }
  return std::pair(features.width, features.height);
}

std::vector<std::uint8_t> webpPixels(std::span<const std::uint8_t> bytes) {
  const auto size = webpSize(bytes);
  if (!size) return {};
  std::vector<std::uint8_t> rgba(4 * toIndex(size->first) * toIndex(size->second));
  const bool whole =
      WebPDecodeRGBAInto(bytes.data(), bytes.size(), rgba.data(), rgba.size(), 4 * size->first) != nullptr;
  return whole ? rgba : std::vector<std::uint8_t>();
}

}  // namespace sinew::gltf
