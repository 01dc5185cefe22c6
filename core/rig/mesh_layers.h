// core/rig/mesh_layers.h: layers of the control mesh: skin, cloth over it, or rigid. docs/characters.md.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

[[nodiscard]] const char* nameOf(SkinLayer layer);  ///< Names in files, menus and on the command line.
[[nodiscard]] std::optional<SkinLayer> skinLayerNamed(const std::string& name);

[[nodiscard]] int findLayer(const Rig& rig, const std::string& part);  ///< Index into Rig::layers, or -1.

/// The layers chosen in the rig, else those guessed ([parts]). Parts that the character lacks are ignored.
[[nodiscard]] std::vector<SkinLayer> layersOf(const Rig& rig, const Character& character,
                                              std::span<const SkinLayer> guessed);

// Edits, as in rig_edit.h.

/// @param layer  nullopt: removes the choice
[[nodiscard]] Result<Rig> setLayer(Rig rig, const std::string& part, std::optional<SkinLayer> layer);
[[nodiscard]] Rig withoutLayers(Rig rig);  ///< Removes all choices.

[[nodiscard]] Result<void> validateLayers(const Rig& rig);  ///< Unique names.

/// Parts that the rig names and the character lacks.
[[nodiscard]] std::vector<std::string> missingParts(const Rig& rig, const Character& character);

/// [parts] Guessed from the bind pose, names and materials; skin if there is only one part, and if in doubt.
/// - Skin: sewn to other parts along most of its border, whatever its name; and the body, the part with the largest
/// area
///   times bones that does not lie over others.
/// - Cloth: over another part along its normals, for half of its area, or for a quarter if named as a garment; and
/// hair,
///   beards and brows near the skin.
/// - Rigid: small and inside the others, or named as an eye, a tooth, a tongue.
[[nodiscard]] std::vector<SkinLayer> guessLayers(const Character& character);

/// Shared control vertices and edges belong to the skin if any of their parts does, else to cloth. So skin at a hem is
/// as without the garment, and the garment sewn to it begins at its height.
struct MeshLayers {
  std::vector<SkinLayer> parts;     ///< [parts]
  std::vector<SkinLayer> carriers;  ///< [V+E+T] control vertices, edges, triangles.
  std::vector<int> skinUnder;       ///< [V] for cloth: nearest control triangle of skin in the bind pose, or -1.
  std::vector<int> clothOver;       ///< [V] for skin: the same of cloth.

  [[nodiscard]] bool hasCloth() const { return !skinUnder.empty(); }
};

inline constexpr float kClothReach = 0.1f;  ///< Largest distance between skin and the cloth over it, fraction of H.

/// Where bones differ, distances grow by up to half of kClothReach: a sleeve belongs to its arm. @param layers [parts]
[[nodiscard]] MeshLayers meshLayers(const Character& character, std::span<const SkinLayer> layers);

/// The triangles of skin, only with positions and corners.
struct SkinMesh {
  ControlMesh mesh;
  std::vector<int> vertices;  ///< [V] vertex in the whole mesh.
};
[[nodiscard]] SkinMesh skinOf(const ControlMesh& mesh, const MeshLayers& layers);

}  // namespace sinew
