// core/bodies/transfer_clips.h: clips of another file, as a character plays them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/character/body_slots.h"
#include "sinew/character/character.h"
#include "sinew/character/skeleton.h"
#include "sinew/rig/rig.h"

namespace sinew {

// Which bone of another file's skeleton is which of the character's.

/// One to one. What comes first counts: the same name; the same path; the same name without its prefix ("mixamorig:",
/// "Armature|", "Bip01 "); the same letters and digits without what nearly all names share in front; the same part of
/// the body. A name counts where it is one bone's alone on both sides. docs/characters.md.
/// @param from  whose clips are played  @param to  who plays them
/// @return [bones of to] bone of from, or -1
[[nodiscard]] std::vector<int> matchBones(const Skeleton& from, const BodySlots& fromSlots, const Skeleton& to,
                                          const BodySlots& toSlots);

/// The same bones, as two files of one character have: the same paths, bound alike.
/// @param size  of the character: what places are compared by
[[nodiscard]] bool haveSameBones(const Skeleton& a, const Skeleton& b, float size);

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
