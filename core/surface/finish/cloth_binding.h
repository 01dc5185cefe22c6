// core/surface/finish/cloth_binding.h: which skin is under refined vertices of cloth, and which cloth over skin.
// Made once per refinement. docs/characters.md.
#pragma once

#include <span>
#include <vector>

#include "core/rig/mesh_layers.h"
#include "core/surface/finish/skin_walls.h"
#include "core/surface/finish/vertex_rings.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// A place on a refined mesh.
struct SurfacePlace {
  int triangle = -1;       ///< Refined.
  glm::vec3 shares{0.0f};  ///< Barycentric.
};

struct BoundVertex {
  int vertex = 0;      ///< Refined.
  SurfacePlace place;  ///< Of the other layer, nearest in the bind pose. It stays the same in all poses: the nearest of
                       ///< a pose leaps from one wall of a fold to the other.
  float share = 1.0f;  ///< Of cloth: how much of the skin's height it takes; less where it hangs far off the skin.
};

inline constexpr std::size_t kClothGroup = 16;

struct ClothBinding {
  std::vector<BoundVertex> cloth;      ///< Those with skin near them. Ascending.
  std::vector<BoundVertex> under;      ///< Vertices of skin with cloth over them. Ascending.
  std::vector<int> slot;               ///< [V'] index into `cloth`, or -1.
  WallTree walls;                      ///< Skin that cloth is near.
  std::vector<WallsUnder> wallsUnder;  ///< [cloth]
  std::vector<int> inSpace;            ///< Indices into `cloth`: kClothGroup after kClothGroup lie close together.
};

/// @param positions, normals [V'] of the patch in the bind pose.  @param height  H
[[nodiscard]] ClothBinding bindCloth(const ControlMesh& mesh, const Refinement& refinement, const VertexRings& rings,
                                     const MeshLayers& layers, std::span<const glm::vec3> positions,
                                     std::span<const glm::vec3> normals, float height);

/// The layers of the control triangles alone.
[[nodiscard]] inline std::span<const SkinLayer> triangleLayers(const Refinement& refinement, const MeshLayers& layers) {
  return std::span(layers.carriers)
      .subspan(static_cast<std::size_t>(refinement.controlVertices) +
               static_cast<std::size_t>(refinement.controlEdges));
}

}  // namespace sinew
