// core/files/gltf/glb.h: the container of a .glb file.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace sinew::gltf {

using Bytes = std::span<const std::uint8_t>;

struct Container {
  std::string_view json;
  std::optional<Bytes> binary;  ///< What buffer 0 holds where it has no uri.
};

/// The parts of a .glb, or a .gltf as nothing but JSON (told apart by content). Refuses at the byte.
[[nodiscard]] Container openContainer(Bytes file);

}  // namespace sinew::gltf
