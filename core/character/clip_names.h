// core/character/clip_names.h: the clip to show first, and the error for a clip that a character does not have.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sinew/character/animation_clip.h"

namespace sinew {

/// Index of the clip to show when a character is opened: a walk, else an idle, else a run, else the first that is
/// neither a death nor an attack, else the first. Reads English words in names of any style: "Armature|Walk_Cycle",
/// "walking", "Fox_Run_01". Prefers names with fewer other words ("Walk" to "Walk_Left"), then the order in the file.
/// Clips of no length count only if all are. -1: no clips.
[[nodiscard]] int firstClip(std::span<const AnimationClip> clips);

inline constexpr const char* kNoClips = "the character has no clips";

/// kNoClips, or the clips and the one probably meant. @param made  names of others available, as the range of motion
[[nodiscard]] std::string noSuchClip(const std::string& name, const std::vector<AnimationClip>& clips,
                                     const std::vector<std::string>& made = {});

}  // namespace sinew
