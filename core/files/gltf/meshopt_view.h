// core/files/gltf/meshopt_view.h: bytes of a buffer view out of meshoptimizer's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sinew/geometry/result.h"

namespace sinew::gltf {

enum class MeshoptMode { kAttributes, kTriangles, kIndices };
enum class MeshoptFilter { kNone, kOctahedral, kQuaternion, kExponential };

/// What EXT_meshopt_compression says of a view.
struct MeshoptView {
  std::uint64_t count = 0;   ///< Elements.
  std::uint64_t stride = 0;  ///< Bytes of an element.
  MeshoptMode mode = MeshoptMode::kAttributes;
  MeshoptFilter filter = MeshoptFilter::kNone;
};

/// count * stride bytes, which the caller has found to be no more than it wants. Strides and modes that the extension
/// does not allow are refused, and bytes too few for the count, before memory is taken. Error: reason only.
[[nodiscard]] Result<std::vector<std::uint8_t>> decodeMeshopt(std::span<const std::uint8_t> bytes,
                                                              const MeshoptView& view);

}  // namespace sinew::gltf
