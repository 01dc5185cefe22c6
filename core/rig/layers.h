// core/rig/layers.h: what the parts of a mesh are to the muscles: guessed, or chosen in the rig. docs/characters.md.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

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

}  // namespace sinew
