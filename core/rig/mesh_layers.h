// core/rig/mesh_layers.h: the layer of each piece of the control mesh, and what lies over what. docs/characters.md.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

// What the parts of a mesh are to the muscles: guessed, or chosen in the rig. docs/characters.md.

/// Names as they stand in files, menus and on the command line.
[[nodiscard]] const char* nameOf(SkinLayer layer);
[[nodiscard]] std::optional<SkinLayer> skinLayerNamed(const std::string& name);

/// Index into Rig::layers, or -1.
[[nodiscard]] int findLayer(const Rig& rig, const std::string& part);

/// The parts' layers: what the rig says, else what is guessed. Parts that the character lacks have no say.
/// @param guessed [parts]
[[nodiscard]] std::vector<SkinLayer> layersOf(const Rig& rig, const Character& character,
                                              std::span<const SkinLayer> guessed);

// Edits, as in rig_edit.h.

/// @param layer  nullopt: the rig says nothing of the part, and it is guessed
[[nodiscard]] Result<Rig> setLayer(Rig rig, const std::string& part, std::optional<SkinLayer> layer);
/// All parts as they are guessed.
[[nodiscard]] Rig withoutLayers(Rig rig);

/// Names, each once.
[[nodiscard]] Result<void> validateLayers(const Rig& rig);

/// Parts that the rig names and the character lacks.
[[nodiscard]] std::vector<std::string> missingParts(const Rig& rig, const Character& character);

// What the parts of a mesh probably are: skin, cloth over it, or rigid. docs/characters.md.

/// [parts] From the bind pose, names and materials alone; all skin where there is one part, and wherever in doubt:
/// - sewn to other parts along most of its border: skin, whatever its name; so is the body, the part with the largest
///   area times bones that does not lie over others;
/// - over another part along its normals, for half of its area, or for a quarter if its name is a garment's: cloth; so
///   are hair, beards and brows near the skin;
/// - small and inside of the others, or named as an eye, a tooth, a tongue: rigid.
[[nodiscard]] std::vector<SkinLayer> guessLayers(const Character& character);

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
