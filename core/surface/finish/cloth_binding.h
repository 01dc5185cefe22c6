// core/surface/finish/cloth_binding.h: binds cloth to skin under it, and skin to cloth over it. docs/characters.md.
#pragma once

#include <span>
#include <vector>

#include "core/rig/mesh_layers.h"
#include "core/surface/finish/skin_walls.h"
#include "core/surface/finish/vertex_rings.h"
#include "sinew/surface/refinement.h"

namespace sinew {

struct SurfacePlace {
  int triangle = -1;       ///< Refined.
  glm::vec3 shares{0.0f};  ///< Barycentric.
};

struct BoundVertex {
  int vertex = 0;      ///< Refined.
  SurfacePlace place;  ///< Nearest place on the other layer in the bind pose, for all poses: the nearest in a pose
                       ///< would leap between the walls of a fold.
  float share = 1.0f;  ///< For cloth: fraction of the skin's height it follows; less where it hangs far off the skin.
};

inline constexpr std::size_t kClothGroup = 16;

struct ClothBinding {
  std::vector<BoundVertex> cloth;      ///< Cloth near skin. Ascending.
  std::vector<BoundVertex> under;      ///< Skin under cloth. Ascending.
  std::vector<int> slot;               ///< [V'] index into `cloth`, or -1.
  WallTree walls;                      ///< Skin near cloth.
  std::vector<WallsUnder> wallsUnder;  ///< [cloth]
  std::vector<int> inSpace;            ///< Indices into `cloth`: each kClothGroup of them lie close together.
};

/// @param positions, normals [V'] of the patch in the bind pose.  @param height  H
[[nodiscard]] ClothBinding bindCloth(const ControlMesh& mesh, const Refinement& refinement, const VertexRings& rings,
                                     const MeshLayers& layers, std::span<const glm::vec3> positions,
                                     std::span<const glm::vec3> normals, float height);

/// [T] Layers of the control triangles.
[[nodiscard]] inline std::span<const SkinLayer> triangleLayers(const Refinement& refinement, const MeshLayers& layers) {
  return std::span(layers.carriers)
      .subspan(static_cast<std::size_t>(refinement.controlVertices) +
               static_cast<std::size_t>(refinement.controlEdges));
}

}  // namespace sinew
