// core/bodies/match_bones.h: which bone of another file's skeleton is which of the character's.
#pragma once

#include <vector>

#include "core/character/body_slots.h"
#include "sinew/character/skeleton.h"

namespace sinew {

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

}  // namespace sinew
