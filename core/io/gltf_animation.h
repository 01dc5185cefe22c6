#pragma once  // core/io/gltf_animation.h: animations -> clips.

#include <span>
#include <vector>

#include "core/io/gltf_accessor.h"
#include "core/io/gltf_notes.h"
#include "core/skeleton/animation_clip.h"
#include "core/skeleton/skeleton.h"

namespace sinew::gltf {

/// Channels that move a node of the skeleton; others are noted. Key times that are out of order are sorted, of equal
/// ones the last counts (both noted). Refuses times and values that are not finite, and accessors that do not fit each
/// other.
/// @param skeletonNode [file nodes] index into skeleton.nodes, or -1.
[[nodiscard]] std::vector<AnimationClip> readClips(const Field& root, const Skeleton& skeleton,
                                                   std::span<const int> skeletonNode, Accessors& accessors,
                                                   Notes& notes);

}  // namespace sinew::gltf
