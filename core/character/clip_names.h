// core/character/clip_names.h: what is said of a clip that a character does not have.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sinew/character/animation_clip.h"

namespace sinew {

// Which clip shows a character when it is opened.

/// Index of a walk, else an idle, else a run, else the first that is neither a death nor an attack, else the first.
/// By English words in names of any style: "Armature|Walk_Cycle", "walking", "Fox_Run_01". Among several the one with
/// the fewest other words ("Walk" before "Walk_Left"), then the first in the file. Clips of no length count only where
/// all are such. -1 without clips.
[[nodiscard]] int firstClip(std::span<const AnimationClip> clips);

inline constexpr const char* kNoClips = "the character has no clips";

/// kNoClips, or the clips that there are and the one that was probably meant.
/// @param made  names of further clips that may be asked for, such as the range of motion
[[nodiscard]] std::string noSuchClip(const std::string& name, const std::vector<AnimationClip>& clips,
                                     const std::vector<std::string>& made = {});

}  // namespace sinew
