// core/files/gltf/morph.h: morph targets of meshes -> deltas of the welded mesh.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/files/gltf/mesh.h"
#include "core/files/gltf/node_tree.h"
#include "sinew/geometry/morph_target.h"

namespace sinew::gltf {

inline constexpr std::size_t kMaxMorphTargets = 1024;  ///< Of all nodes together.

/// The targets of all nodes that show a mesh with any, node by node, in the order of the mesh. A target counts for all
/// parts of its mesh that have one of its number. Deltas of 0 are left out. Refuses more than kMaxMorphTargets and
/// accessors that do not fit; deltas that are not finite or too large are noted and are 0.
/// @param origin  of the soup.  @param standsFor [V] the soup vertex of each welded one (mesh/weld.h)
[[nodiscard]] std::vector<MorphTarget> readMorphs(const File& file, const NodeTree& tree, const BoundSkeleton& bound,
                                                  const SoupOrigin& origin, std::span<const int> standsFor,
                                                  Accessors& accessors, Notes& notes);

/// Where the targets of one node are among all.
struct NodeTargets {
  int first = 0;
  int count = 0;
};
/// [file nodes]
[[nodiscard]] std::vector<NodeTargets> targetsOfNodes(std::size_t nodes, std::span<const MorphTarget> targets);

}  // namespace sinew::gltf
