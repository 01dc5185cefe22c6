// core/io/gltf/animation.h: animations -> clips.
#pragma once

#include <span>
#include <vector>

#include "core/io/gltf/accessor.h"
#include "core/io/gltf/notes.h"
#include "sinew/skeleton/animation_clip.h"
#include "sinew/skeleton/skeleton.h"

namespace sinew::gltf {

/// Channels that move a node of the skeleton; others are noted. Key times that are out of order are sorted, of equal
/// ones the last counts (both noted). Refuses times and values that are not finite, and accessors that do not fit each
/// other.
/// @param skeletonNode [file nodes] index into skeleton.nodes, or -1.
[[nodiscard]] std::vector<AnimationClip> readClips(const File& file, const Skeleton& skeleton,
                                                   std::span<const int> skeletonNode, Accessors& accessors,
                                                   Notes& notes);

}  // namespace sinew::gltf
