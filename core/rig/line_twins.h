// core/rig/line_twins.h: muscle lines on the other side of the mirror plane.
#pragma once

#include <string>

#include "core/rig/mirror.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// On the other side. Error: see twinBone.
[[nodiscard]] Result<LineAnchor> mirroredAnchor(const MirrorPlan& plan, const LineAnchor& anchor);
/// Anchors mirrored, settings as they are, name by the other side's bone or by the side it says, `mirror` empty. Error:
/// see twinBone.
[[nodiscard]] Result<MuscleLine> mirroredLine(const MirrorPlan& plan, const MuscleLine& line);

/// Every anchor lies on a center bone and within `tolerance` (fraction of H) of the plane: the line is its own image.
[[nodiscard]] bool liesInPlane(const MirrorPlan& plan, const MuscleLine& line, float tolerance);

/// A rig, and what an image of a primitive of it names as its line.
struct TwinLine {
  Rig rig;
  std::string name;  ///< Empty for a primitive without a line.
};

/// The line on the other side: the linked twin, made and linked if there is none; the line itself if it lies in the
/// plane. Where the name says no side, both get theirs. Error: see mirroredLine.
[[nodiscard]] Result<TwinLine> withTwinLine(Rig rig, std::string line, const MirrorPlan& plan);

/// The twin of a primitive rides the twin line of its line (withTwinLine). The rig as it is: it has no twin, rides no
/// line, or its line has no image.
[[nodiscard]] Rig withTwinOnLine(Rig rig, int primitive, const MirrorPlan& plan);

/// The name of the line that an image of a primitive rides, of those that are there: the twin, or the line itself if it
/// has none.
[[nodiscard]] std::string twinLineName(const Rig& rig, const std::string& line);

/// Lines of a pair follow each other as primitives do (twins.h, keepTwins): anchors and settings of the one that was
/// edited go to the other.
void keepLineTwins(const Rig& atStart, const Rig& shown, Rig& edited, const MirrorPlan& plan);

}  // namespace sinew
