// core/surface/detail_moments.h: the poses in which adaptive refinement looks at a surface.
#pragma once

#include <memory>
#include <vector>

#include "core/rig/posed_rig.h"
#include "sinew/character/character.h"
#include "sinew/character/pose.h"

namespace sinew {

/// Moments of a character's clips and of its range of motion, some evenly spaced ones of each. Once a character: a clip
/// that was made in memory does not count.
[[nodiscard]] std::vector<Pose> detailMoments(const Character& character);

/// The bind pose, relaxed and flexed, and those of the moments that differ most from it and from each other in how
/// joints under muscles are bent, lines stretched and muscles' numbers driven: farthest-point sampling, at most
/// kMostDetailPoses in all. A function of character and rig.
inline constexpr int kMostDetailPoses = 8;
[[nodiscard]] std::vector<Pose> detailPoses(const Character& character, const Rig& rig, const RigPoser& poser,
                                            const std::vector<Pose>& moments);

}  // namespace sinew
