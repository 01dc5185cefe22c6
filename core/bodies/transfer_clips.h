// core/bodies/transfer_clips.h: clips of another file, as a character plays them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew {

struct TransferredClips {
  std::vector<AnimationClip> clips;  ///< `addedFrom` is set; no two are called the same, nor as one of the character's.
  std::vector<std::string> notes;    ///< What did not match, one line each, in plain words.
  std::vector<std::string> unmatched{};  ///< Bones that a clip moves and nothing of the character follows.
  std::vector<std::string> unmoved{};  ///< Bones of the character, parts of its body, that no bone of the clips moves.
};

/// Where the nodes that a clip moves, and all above them, stand in both files alike, its channels are the same. Else
/// rotations are transferred against the bind pose, in the world, with both bodies brought to one stance
/// (common_stance.h), and of all translations that of the hips, scaled by their height above the feet. Weights of morph
/// targets go by name. Clips that move nothing here are left out, which is a note. docs/characters.md.
/// @param from  of importClips(); its mesh may be empty
/// @param corrections  of the character's rig: which bone is which part
/// @param file  as the rig names it
[[nodiscard]] TransferredClips transferClips(const Character& from, const Character& to,
                                             std::span<const SlotCorrection> corrections, const std::string& file);

}  // namespace sinew
