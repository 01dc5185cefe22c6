// core/bodies/learned_lengths.h: what muscle lines do over all clips, learned for many at once.
#pragma once

#include <cstddef>

#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Lines from `first` on learn their full contraction (withLearned). Twins learn alike: from whichever side gets
/// shorter. One that never shortens keeps what it has.
/// @param character  with the range of motion as a clip
[[nodiscard]] Rig withLearnedLengths(Rig rig, std::size_t first, const Character& character);

}  // namespace sinew
