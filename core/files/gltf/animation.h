// core/files/gltf/animation.h: morph targets and animations.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/files/gltf/accessor.h"
#include "core/files/gltf/glb.h"
#include "core/files/gltf/mesh.h"
#include "core/files/gltf/node_tree.h"
#include "sinew/character/animation_clip.h"
#include "sinew/character/skeleton.h"
#include "sinew/geometry/morph_target.h"

namespace sinew::gltf {

// Morph targets of meshes -> deltas of the welded mesh.

inline constexpr std::size_t kMaxMorphTargets = 1024;  ///< Of all nodes.

/// Targets of all nodes, node by node in the order of the mesh, without deltas of 0. A target covers all primitives of
/// its mesh that have one of its number. Refuses more than kMaxMorphTargets and accessors that do not match; deltas
/// that are not finite or too large are noted and become 0.
/// @param origin  of the soup  @param standsFor  [V] a soup vertex of each welded one
[[nodiscard]] std::vector<MorphTarget> readMorphs(const File& file, const NodeTree& tree, const BoundSkeleton& bound,
                                                  const SoupOrigin& origin, std::span<const int> standsFor,
                                                  Accessors& accessors, Notes& notes);

/// The range of one node's targets.
struct NodeTargets {
  int first = 0;
  int count = 0;
};
/// [file nodes]
[[nodiscard]] std::vector<NodeTargets> targetsOfNodes(std::size_t nodes, std::span<const MorphTarget> targets);

/// Nodes and morph targets that clips can move.
struct ClipTargets {
  const Skeleton& skeleton;
  std::span<const int> skeletonNode;        ///< [file nodes] index into skeleton.nodes, or -1.
  std::span<const NodeTargets> morphsOf{};  ///< [file nodes]; empty: no weights.
};

/// Reads channels of nodes of the skeleton and of weights of morph targets; notes others. Sorts key times; the last of
/// equal ones counts (both noted). Refuses times and values that are not finite, and accessors that do not match.
[[nodiscard]] std::vector<AnimationClip> readClips(const File& file, const ClipTargets& targets, Accessors& accessors,
                                                   Notes& notes);

}  // namespace sinew::gltf
