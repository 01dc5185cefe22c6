// core/bodies/transfer_clips.h: transfers clips of another file to a character.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/character/body_slots.h"
#include "sinew/character/character.h"
#include "sinew/character/skeleton.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Matches bones one to one, by the first of: same name; same path; same name without its prefix ("mixamorig:",
/// "Armature|", "Bip01 "); same letters and digits without the beginning that nearly all names share; same body part. A
/// name counts only where it is unique on both sides. docs/characters.md.
/// @param from  has the clips  @param to  plays them  @return [bones of to] bone of from, or -1
[[nodiscard]] std::vector<int> matchBones(const Skeleton& from, const BodySlots& fromSlots, const Skeleton& to,
                                          const BodySlots& toSlots);

/// Same paths and bind poses, as in two files of one character.
/// @param size  of the character, to which differences of place are compared
[[nodiscard]] bool haveSameBones(const Skeleton& a, const Skeleton& b, float size);

struct TransferredClips {
  std::vector<AnimationClip> clips;      ///< With `addedFrom`; names unique, also among the character's clips.
  std::vector<std::string> notes;        ///< One sentence for each thing that did not match.
  std::vector<std::string> unmatched{};  ///< Bones that a clip moves and no bone of the character follows.
  std::vector<std::string> unmoved{};    ///< Body parts of the character that no bone of the clips moves.
};

/// Channels are copied where the nodes that a clip moves, and all above them, rest alike in both files. Otherwise
/// rotations are transferred relative to the bind pose, in the world, with both bodies in a common stance
/// (retargeter.h); of the translations only that of the hips, scaled by their height above the feet. Morph weights go
/// by name. Clips that move nothing are left out with a note. docs/characters.md.
/// @param from  of importClips(); its mesh may be empty
/// @param corrections  of the character's rig  @param file  as the rig names it
[[nodiscard]] TransferredClips transferClips(const Character& from, const Character& to,
                                             std::span<const SlotCorrection> corrections, const std::string& file);

}  // namespace sinew
