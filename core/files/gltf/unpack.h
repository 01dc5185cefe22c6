// core/files/gltf/unpack.h: decodes compressed views and meshes when a file is opened.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include <tiny_gltf.h>

#include "core/files/gltf/glb.h"
#include "core/files/gltf/guard.h"
#include "sinew/geometry/result.h"

namespace sinew::gltf {

enum class MeshoptMode { kAttributes, kTriangles, kIndices };
enum class MeshoptFilter { kNone, kOctahedral, kQuaternion, kExponential };

/// EXT_meshopt_compression of a view.
struct MeshoptView {
  std::uint64_t count = 0;   ///< Elements.
  std::uint64_t stride = 0;  ///< Bytes of an element.
  MeshoptMode mode = MeshoptMode::kAttributes;
  MeshoptFilter filter = MeshoptFilter::kNone;
};

/// Returns count * stride bytes; the caller limits them. Before allocating, checks strides and modes by the extension,
/// and that the bytes can hold the count. Error: reason only.
[[nodiscard]] Result<std::vector<std::uint8_t>> decodeMeshopt(std::span<const std::uint8_t> bytes,
                                                              const MeshoptView& view);

inline constexpr std::string_view kMeshopt = "EXT_meshopt_compression";
inline constexpr std::string_view kDraco = "KHR_draco_mesh_compression";

/// Decoded parts. Readers of the file see only plain views and accessors.
struct Unpacked {
  std::map<std::size_t, std::vector<std::uint8_t>> views;  ///< Bytes of bufferViews; new ones follow the file's.
  std::map<std::size_t, float> accessors;                  ///< Accessors with new views, and the steps of
                                                           ///< their rounding; 0: not rounded.
  std::set<std::size_t> spent;                             ///< bufferViews that hold compressed meshes.
};

/// Whether a buffer is a fallback for programs that cannot decompress: it is not read.
[[nodiscard]] bool isFallback(const Json& buffer);

/// Bytes of a range of a buffer; refuses at `place` if the buffer is too short.
using BufferRange =
    std::function<Bytes(std::size_t buffer, std::uint64_t offset, std::uint64_t size, const std::string& place)>;

/// Decodes all EXT_meshopt_compression views, then all KHR_draco_mesh_compression meshes. Compares sizes with the
/// file's declarations and with limits before allocating.
/// @param root  the file's JSON  @param model  receives new views, and accessors and primitives that use them
[[nodiscard]] Unpacked unpack(const Json& root, const Guarded& guarded, const BufferRange& bytes,
                              tinygltf::Model& model);

}  // namespace sinew::gltf
