// core/character/first_clip.h: which clip shows a character when it is opened.
#pragma once

#include <span>

#include "sinew/character/animation_clip.h"

namespace sinew {

/// Index of a walk, else an idle, else a run, else the first that is neither a death nor an attack, else the first.
/// By English words in names of any style: "Armature|Walk_Cycle", "walking", "Fox_Run_01". Among several the one with
/// the fewest other words ("Walk" before "Walk_Left"), then the first in the file. Clips of no length count only where
/// all are such. -1 without clips.
[[nodiscard]] int firstClip(std::span<const AnimationClip> clips);

}  // namespace sinew
