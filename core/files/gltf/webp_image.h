// core/files/gltf/webp_image.h: WebP -> RGBA.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace sinew::gltf {

/// Width and height of a still image; nothing where the header is damaged or the image moves.
[[nodiscard]] std::optional<std::pair<int, int>> webpSize(std::span<const std::uint8_t> bytes);

/// Its pixels, 4 bytes each; empty where it is damaged. The size has been found to be bearable.
[[nodiscard]] std::vector<std::uint8_t> webpPixels(std::span<const std::uint8_t> bytes);

}  // namespace sinew::gltf
