// core/rig/morphs.h: what a rig adds to the weights of a character's morph targets. Pure functions, as in rig_edit.h.
#pragma once

#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

enum class KeepIdle { kNo, kYes };

/// The names of a character's expressions and morph targets, each once, in the order of the file.
[[nodiscard]] std::vector<std::string> morphNames(const Character& character);

/// An entry for every name of the character, in its order; then those that it does not know. Entries that do nothing
/// are not written to files.
/// @param idle  whether unknown ones that do nothing stay: while a document is edited no entry may vanish
[[nodiscard]] Rig withMorphsOf(Rig rig, const Character& character, KeepIdle idle = KeepIdle::kNo);
/// Whether it adds nothing and is not animated.
[[nodiscard]] bool isIdle(const MorphWeight& morph);

/// @param weight  kLeastMorphWeight..kMostMorphWeight, else refused; makes the entry where there is none.
[[nodiscard]] Result<Rig> setMorphWeight(Rig rig, const std::string& name, float weight);
/// All weights 0; keys and drivers stay.
[[nodiscard]] Rig withoutMorphWeights(Rig rig);

/// Names, each once; weights in range; sound keys and drivers.
[[nodiscard]] Result<void> validateMorphs(const Rig& rig);

}  // namespace sinew
