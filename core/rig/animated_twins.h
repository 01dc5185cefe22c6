// core/rig/animated_twins.h: keys and drivers on the other side of the mirror plane. docs/muscles.md.
#pragma once

#include <vector>

#include "core/rig/mirror.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// The same motion seen in the mirror: bones by their counterparts, a twist the other way round. Lines and channels are
/// named as they are. nullopt: a bone has no counterpart.
[[nodiscard]] std::optional<Driver> mirroredDriver(const MirrorPlan& plan, const Driver& driver);

/// What drives a primitive's image: numbers along an axis go to the axis that it has become, with its sign and offset.
/// What has no exact counterpart there (an axis that is not along one of the other bone's) is left out, as are drivers
/// by bones without counterpart.
[[nodiscard]] std::vector<AnimatedNumber> mirroredAnimation(const MirrorPlan& plan, const Primitive& primitive);
/// The same of a line's numbers, which are the same on both sides.
[[nodiscard]] std::vector<AnimatedNumber> mirroredAnimation(const MirrorPlan& plan, const MuscleLine& line);

/// Lengths are read off the twins of lines that have one.
void readTwinLines(const Rig& rig, std::vector<AnimatedNumber>& animated);

}  // namespace sinew
