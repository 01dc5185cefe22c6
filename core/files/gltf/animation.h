// core/files/gltf/animation.h: animations -> clips.
#pragma once

#include <span>
#include <vector>

#include "core/files/gltf/accessor.h"
#include "core/files/gltf/morph.h"
#include "core/files/gltf/refusal.h"
#include "sinew/character/animation_clip.h"
#include "sinew/character/skeleton.h"

namespace sinew::gltf {

/// What clips may move.
struct ClipTargets {
  const Skeleton& skeleton;
  std::span<const int> skeletonNode;        ///< [file nodes] index into skeleton.nodes, or -1.
  std::span<const NodeTargets> morphsOf{};  ///< [file nodes]; empty: no weights.
};

/// Channels that move a node of the skeleton or the weights of morph targets; others are noted. Key times that are out
/// of order are sorted, of equal ones the last counts (both noted). Refuses times and values that are not finite, and
/// accessors that do not fit each other.
[[nodiscard]] std::vector<AnimationClip> readClips(const File& file, const ClipTargets& targets, Accessors& accessors,
                                                   Notes& notes);

}  // namespace sinew::gltf
