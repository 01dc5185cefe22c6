// core/files/export/clip_repair.h: repairs clips that do not conform to glTF, as they were read and measured.
#pragma once

#include <set>
#include <string>

#include "core/files/export/gltf_rewrite.h"
#include "core/files/export/source.h"

namespace sinew::exporting {

/// Sorts key times, cuts keys before 0, normalizes rotations, all as they play. Removes channels that do not play: a
/// second one of a property, one of a node with a matrix, one with unreadable keys. @param left  receives the changes
void repairClips(Source& source, GltfRewrite& rewrite, std::set<std::string>& left);

}  // namespace sinew::exporting
