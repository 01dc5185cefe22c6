// core/skeleton/node_locals.h: how nodes stand to their parents, at rest and in a clip.
#pragma once

#include <vector>

#include "sinew/skeleton/animation_clip.h"
#include "sinew/skeleton/skeleton.h"

namespace sinew {

/// [nodes] when nothing is animated.
[[nodiscard]] std::vector<LocalTransform> restLocals(const Skeleton& skeleton);

/// [nodes] at a time of a file's clip, seconds; nodes without a channel rest.
[[nodiscard]] std::vector<LocalTransform> sampleLocals(const Skeleton& skeleton, const AnimationClip& clip, float time);

}  // namespace sinew
