// core/rig/clip_keys.h: keys of whole clips, of all numbers and channels of a rig.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "sinew/rig/rig.h"

namespace sinew {

/// Key tracks that a rig has in the clip of that name.
[[nodiscard]] std::size_t countKeyTracks(const Rig& rig, const std::string& clip);

/// The rig whose keys follow clips that are called otherwise from now on. A track that had one of the new names for a
/// clip that is not there gives way.
/// @param names  from old to new; no two become the same
[[nodiscard]] Rig withClipsRenamed(Rig rig, const std::map<std::string, std::string>& names);

}  // namespace sinew
