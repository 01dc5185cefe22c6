// core/files/gltf/mesh.h: mesh primitives -> one triangle soup in the bind pose.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <tiny_gltf.h>

#include "core/files/gltf/accessor.h"
#include "core/files/gltf/material.h"
#include "core/files/gltf/skin.h"
#include "core/geometry/weld.h"
#include "sinew/character/character.h"

namespace sinew::gltf {

// Triangles of lists, strips and fans.

/// @param mode  TINYGLTF_MODE_TRIANGLES, _TRIANGLE_STRIP or _TRIANGLE_FAN
[[nodiscard]] inline std::size_t triangleCount(int mode, std::size_t corners) {
  if (mode == TINYGLTF_MODE_TRIANGLES) return corners / 3;
  return corners < 3 ? 0 : corners - 2;
}

/// Corner numbers of a triangle; every second one of a strip is flipped so that all have the same winding.
[[nodiscard]] inline std::array<std::uint32_t, 3> triangleCorners(int mode, std::size_t triangle) {
  const auto t = static_cast<std::uint32_t>(triangle);
  if (mode == TINYGLTF_MODE_TRIANGLES) return {3 * t, 3 * t + 1, 3 * t + 2};
  if (mode == TINYGLTF_MODE_TRIANGLE_FAN) return {t + 1, t + 2, 0};
  return {t, t + 1 + t % 2, t + 2 - t % 2};
}

/// Triangles and vertices of a soup from one primitive of a node's mesh.
struct SoupPart {
  int node = 0;
  int mesh = 0;
  int primitive = 0;
  std::size_t firstTriangle = 0;
  std::size_t endTriangle = 0;
  std::size_t firstVertex = 0;
  std::size_t endVertex = 0;
};

struct SoupOrigin {
  std::vector<SoupPart> parts;            ///< In the soup's order; only those with triangles.
  std::vector<std::uint32_t> fileVertex;  ///< [N] number of each vertex in its primitive.
};

/// A mesh of the file with one of its materials: an element of TriangleSoup::parts.
struct MeshMaterial {
  int mesh = 0;
  int material = 0;

  friend bool operator==(const MeshMaterial&, const MeshMaterial&) = default;
};

/// Unique names of a soup's parts: of the mesh, or of the material if the mesh has several.
[[nodiscard]] std::vector<MeshPart> partsOf(const File& file, std::span<const MeshMaterial> parts,
                                            std::span<const Material> materials);
/// Renumbers the parts of the welded mesh in order, and removes the others.
void keepUsedParts(ControlMesh& mesh, std::vector<MeshMaterial>& parts);

/// All triangles of the scene's meshes, node by node in file order, without unused vertices. Primitives without a
/// material get a new one at the end of `materials`. Refuses more than kMaxControlTriangles, indices and joints out of
/// range, and positions and weights that are not finite; notes points and lines. @param origin, parts  filled if not
/// null
[[nodiscard]] TriangleSoup readTriangles(const File& file, const NodeTree& tree, const BoundSkeleton& bound,
                                         Materials& materials, Accessors& accessors, Notes& notes,
                                         SoupOrigin* origin = nullptr, std::vector<MeshMaterial>* parts = nullptr);

/// H of docs/design.md: the y extent, or the largest extent if flat.
[[nodiscard]] float heightOf(const std::vector<glm::vec3>& positions);
[[nodiscard]] float weldTolerance(const TriangleSoup& soup);  ///< Tolerance for welding a soup (core/geometry/weld.h).

}  // namespace sinew::gltf
