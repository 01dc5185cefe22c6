// core/include/sinew/character/node_locals.h: local transforms of nodes at rest and in a clip, and poses from them.
#pragma once

#include <span>
#include <vector>

#include "sinew/character/animation_clip.h"
#include "sinew/character/pose.h"
#include "sinew/character/skeleton.h"

namespace sinew {

[[nodiscard]] std::vector<LocalTransform> restLocals(const Skeleton& skeleton);  ///< [nodes] without animation.

/// [nodes] at a time in seconds of a file's clip; nodes without a channel are at rest.
[[nodiscard]] std::vector<LocalTransform> sampleLocals(const Skeleton& skeleton, const AnimationClip& clip, float time);

/// The pose of all bones for node transforms (Bone::node). @param locals [nodes] as Skeleton::nodes (asserted)
[[nodiscard]] Pose poseFromLocals(const Skeleton& skeleton, std::span<const LocalTransform> locals);

}  // namespace sinew
