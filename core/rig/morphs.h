// core/rig/morphs.h: weights that a rig adds to a character's morph targets. Pure functions, as in rig_edit.h.
#pragma once

#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

enum class KeepIdle { kNo, kYes };

/// Names of a character's expressions and morph targets, each once, in the order of the file.
[[nodiscard]] std::vector<std::string> morphNames(const Character& character);

/// Makes an entry for every name of the character, in its order, followed by the rig's other entries. Idle entries are
/// not written to files.
/// @param idle  kYes: keeps other entries that are idle, since no entry may vanish while a document is edited
[[nodiscard]] Rig withMorphsOf(Rig rig, const Character& character, KeepIdle idle = KeepIdle::kNo);
/// Weight 0 and not animated.
[[nodiscard]] bool isIdle(const MorphWeight& morph);

/// Adds the entry if there is none. Error: not in kLeastMorphWeight..kMostMorphWeight.
[[nodiscard]] Result<Rig> setMorphWeight(Rig rig, const std::string& name, float weight);
/// Sets all weights to 0; keys and drivers stay.
[[nodiscard]] Rig withoutMorphWeights(Rig rig);

/// Unique names; weights in range; valid keys and drivers.
[[nodiscard]] Result<void> validateMorphs(const Rig& rig);

}  // namespace sinew
