// core/files/gltf/unpack.h: compressed views and meshes -> plain ones, once, when a file is opened.
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

// Bytes of a buffer view out of meshoptimizer's.

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

inline constexpr std::string_view kMeshopt = "EXT_meshopt_compression";
inline constexpr std::string_view kDraco = "KHR_draco_mesh_compression";

/// What stands in place of compressed parts. All that reads the file afterwards sees views and accessors alone.
struct Unpacked {
  std::map<std::size_t, std::vector<std::uint8_t>> views;  ///< Bytes of bufferViews; those beyond the file's are new.
  std::map<std::size_t, float> accessors;                  ///< Those that have new views, and to what steps their
                                                           ///< values were rounded; 0: they were not.
  std::set<std::size_t> spent;                             ///< bufferViews that hold compressed meshes.
};

/// Whether a buffer is there for programs that cannot decompress: it is not read.
[[nodiscard]] bool isFallback(const Json& buffer);

/// Bytes of a range of a buffer; refuses, at the place, what is not there.
using BufferRange =
    std::function<Bytes(std::size_t buffer, std::uint64_t offset, std::uint64_t size, const std::string& place)>;

/// Decodes all views that EXT_meshopt_compression has, then all meshes that KHR_draco_mesh_compression has. Sizes are
/// compared with what the file declares, and with limits, before memory is taken.
/// @param root   the file's JSON  @param model  gets new views, and accessors and primitives that use them
[[nodiscard]] Unpacked unpack(const Json& root, const Guarded& guarded, const BufferRange& bytes,
                              tinygltf::Model& model);

}  // namespace sinew::gltf
