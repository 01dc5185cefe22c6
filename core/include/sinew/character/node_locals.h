// core/include/sinew/character/node_locals.h: how nodes stand to their parents, at rest, in a clip, and changed by
// hand.
#pragma once

#include <span>
#include <vector>

#include "sinew/character/animation_clip.h"
#include "sinew/character/pose.h"
#include "sinew/character/skeleton.h"

namespace sinew {

/// [nodes] when nothing is animated.
[[nodiscard]] std::vector<LocalTransform> restLocals(const Skeleton& skeleton);

/// [nodes] at a time of a file's clip, seconds; nodes without a channel rest.
[[nodiscard]] std::vector<LocalTransform> sampleLocals(const Skeleton& skeleton, const AnimationClip& clip, float time);

/// Where all bones are if the nodes stand so: whoever turns one node moves all that hangs on it. A bone's node is
/// Bone::node.
/// @param locals [nodes] parents before children, as Skeleton::nodes (asserted)
[[nodiscard]] Pose poseFromLocals(const Skeleton& skeleton, std::span<const LocalTransform> locals);

}  // namespace sinew
