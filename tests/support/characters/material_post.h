// tests/support/characters/material_post.h: the post with materials, maps and images.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/characters/gltf_builder.h"

namespace sinew::test {

/// A PNG of one pixel, 10 128 255, as a data: uri.
extern const std::string kOnePixel;

/// RGB, 8 bits; `pixels` with a filter byte before each row. Not compressed, checksums 0: decoders do not look at them.
[[nodiscard]] std::string storedPng(std::uint32_t width, std::uint32_t height, const std::string& pixels);

/// Without loss.
[[nodiscard]] std::string losslessWebp(int width, int height, const std::vector<std::uint8_t>& rgba);

/// A map of texture coordinates 0. @param transform  KHR_texture_transform, if any
[[nodiscard]] nlohmann::ordered_json mapAt(int texture, const nlohmann::ordered_json& transform = {});

/// All maps that Sinew reads except the base color, with textures 0 to 2.
[[nodiscard]] nlohmann::ordered_json wholeMaterial();

/// A post with this material; all of its corners lie at (0.25, 0.75). @param images  textures, each with its own copy
/// of `image`
[[nodiscard]] Post materialPost(const nlohmann::ordered_json& material, int images,
                                const std::string& image = kOnePixel);

}  // namespace sinew::test
