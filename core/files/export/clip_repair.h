// core/files/export/clip_repair.h: clips as they were read and measured, where the file's are not as glTF wants them.
#pragma once

#include <set>
#include <string>

#include "core/files/export/gltf_rewrite.h"
#include "core/files/export/source.h"

namespace sinew::exporting {

/// Key times that fall or repeat are sorted, those before 0 end at 0, as they play. Rotations get length 1. Channels
/// that do not play are left out: a second one for the same property, of a node that a matrix places, with keys that
/// cannot be read.
/// @param left  takes what has changed, and why
void repairClips(Source& source, GltfRewrite& rewrite, std::set<std::string>& left);

}  // namespace sinew::exporting
