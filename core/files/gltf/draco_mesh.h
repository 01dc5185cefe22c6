// core/files/gltf/draco_mesh.h: triangles and attributes out of Draco's bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sinew/geometry/result.h"

namespace sinew::gltf {

/// An attribute of a compressed mesh, as the accessor it is for declares it.
struct DracoAttribute {
  std::uint64_t id = 0;   ///< Its number in the compressed bytes.
  int components = 1;     ///< 1 to 16.
  int componentType = 0;  ///< TINYGLTF_COMPONENT_TYPE_*, one that glTF knows.
};

/// What the file says of the mesh. Whatever the bytes say beyond it is refused before memory is taken for it.
struct DracoRequest {
  std::size_t vertices = 0;       ///< Exactly so many.
  std::size_t mostTriangles = 0;  ///< At most so many.
  std::size_t mostBytes = 0;      ///< All attributes in the bytes together, decoded.
  std::vector<DracoAttribute> attributes;
};

struct DracoMesh {
  std::vector<std::uint32_t> indices;                 ///< [triangles * 3], each below DracoRequest::vertices
  std::vector<std::vector<std::uint8_t>> attributes;  ///< [attributes] tightly packed values of all vertices
  std::vector<float> steps;                           ///< [attributes] that values were rounded to; 0: not rounded
};

/// Triangle meshes of Draco's version 2.2, the one that glTF allows. Error: reason only.
[[nodiscard]] Result<DracoMesh> decodeDraco(std::span<const std::uint8_t> bytes, const DracoRequest& request);

}  // namespace sinew::gltf
