// core/files/export/line_data.h: what a game needs to pose the joints of muscle lines in poses that it makes up itself.
#pragma once

#include <span>

#include "core/files/export/gltf_rewrite.h"
#include "core/files/export/source.h"
#include "core/files/fit/line_joints.h"

namespace sinew::exporting {

/// Puts the lines' data into `extras.sinew` of the first skin that has one of their joints, beside what else is there
/// (docs/export.md, "Line data"). Settings are the rig's own: keys and drivers are not in them. After the skins have
/// been written. False: there are such skins, but the extras of all of them are no objects.
/// @param nodes  [lines.joints()] and maybe more, of the file
bool addLineData(const Source& source, const LineJoints& lines, std::span<const int> nodes, GltfRewrite& rewrite);

}  // namespace sinew::exporting
