// core/rig/mesh_layers.h: the layer of each piece of the control mesh, and what lies over what. docs/characters.md.
#pragma once

#include <span>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// A control vertex or edge that parts share belongs to the skin if any of them does, else to cloth: so skin that ends
/// at a hem is what it would be without the garment, and the garment, sewn to it, begins at its height.
struct MeshLayers {
  std::vector<SkinLayer> parts;     ///< [parts] what all follows from.
  std::vector<SkinLayer> carriers;  ///< [V+E+T] control vertices, edges, triangles.
  std::vector<int> skinUnder;       ///< [V] of cloth: the control triangle of skin nearest in the bind pose, or -1.
  std::vector<int> clothOver;       ///< [V] of skin: likewise of cloth.

  [[nodiscard]] bool hasCloth() const { return !skinUnder.empty(); }
};

/// How far cloth is looked for over the skin and skin under cloth, fraction of H.
inline constexpr float kClothReach = 0.1f;

/// Nearest is counted in space, and more by up to half of the reach where a vertex follows other bones: a sleeve at the
/// flank belongs to its arm. @param layers [parts]
[[nodiscard]] MeshLayers meshLayers(const Character& character, std::span<const SkinLayer> layers);

/// The mesh of the triangles of skin alone, as far as positions and corners go, and which vertex each of its vertices
/// is.
struct SkinMesh {
  ControlMesh mesh;
  std::vector<int> vertices;
};
[[nodiscard]] SkinMesh skinOf(const ControlMesh& mesh, const MeshLayers& layers);

}  // namespace sinew
