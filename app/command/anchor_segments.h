// app/command/anchor_segments.h: the segments that `replace` searches, as lines to draw (paper Fig. 5).
#pragma once

#include <span>
#include <vector>

#include "app/viewport/render/scene.h"

namespace sinew::app {

/// From each control vertex that the muscles hold (a corner of an implicit triangle, by `surface.classes`) to its
/// anchor, both in the pose; kFound where the smoothed surface lies off the control vertex, else kLost. World space.
[[nodiscard]] std::vector<SceneSegment> anchorSegments(const Character& character, const Pose& pose,
                                                       std::span<const float> morphWeights, const Surface& surface);

}  // namespace sinew::app
