// core/character/clip_names.h: what is said of a clip that a character does not have.
#pragma once

#include <string>
#include <vector>

#include "sinew/character/animation_clip.h"

namespace sinew {

inline constexpr const char* kNoClips = "the character has no clips";

/// kNoClips, or the clips that there are and the one that was probably meant.
/// @param made  names of further clips that may be asked for, such as the range of motion
[[nodiscard]] std::string noSuchClip(const std::string& name, const std::vector<AnimationClip>& clips,
                                     const std::vector<std::string>& made = {});

}  // namespace sinew
