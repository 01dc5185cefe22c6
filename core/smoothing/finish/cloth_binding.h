// core/smoothing/finish/cloth_binding.h: which skin is under refined vertices of cloth, and which cloth over skin.
// Made once per refinement. docs/layers.md.
#pragma once

#include <span>
#include <vector>

#include "core/rig/mesh_layers.h"
#include "core/smoothing/finish/skin_walls.h"
#include "core/smoothing/finish/vertex_rings.h"
#include "sinew/smoothing/refinement.h"

namespace sinew {

/// A place on a refined mesh.
struct SurfacePlace {
  int triangle = -1;       ///< Refined.
  glm::vec3 shares{0.0f};  ///< Barycentric.
};

/// Finds nearest places on the refined triangles of one layer by going from one triangle to the next.
class SurfaceWalk {
 public:
  /// All must outlive the walk. @param layers [T] of the control triangles.  @param positions [V']
  SurfaceWalk(const Refinement& refinement, const VertexRings& rings, std::span<const SkinLayer> layers, SkinLayer on,
              std::span<const glm::vec3> positions)
      : refinement_(refinement), rings_(rings), layers_(layers), on_(on), positions_(positions) {}

  /// The nearest place that can be reached from a triangle by steps that each come nearer.
  [[nodiscard]] SurfacePlace nearest(const glm::vec3& p, int start) const;

 private:
  [[nodiscard]] bool isOn(int triangle) const;

  const Refinement& refinement_;
  const VertexRings& rings_;
  std::span<const SkinLayer> layers_;
  SkinLayer on_;
  std::span<const glm::vec3> positions_;
};

struct BoundVertex {
  int vertex = 0;      ///< Refined.
  int start = 0;       ///< Refined triangle of the other layer, nearest in the bind pose: where walks begin.
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
