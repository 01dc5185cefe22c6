// core/files/export/helper_nodes.h: the added joints as nodes of the file, and their keys in its clips.
#pragma once

#include <span>
#include <vector>

#include "core/files/export/gltf_rewrite.h"
#include "core/files/export/source.h"
#include "core/files/fit/helper_joint.h"

namespace sinew::exporting {

/// A node for each joint, under that of its bone, with a name that no other node has. Returns their numbers.
[[nodiscard]] std::vector<int> addHelperNodes(const Source& source, std::span<const HelperJoint> joints,
                                              GltfRewrite& rewrite);

/// Channels for the joints in the file's clips, linear between keys; none where a joint stays as it rests.
/// @param nodes  [joints]  @param clips  in the order of the file's, which may have more
void addHelperKeys(std::span<const HelperJoint> joints, std::span<const int> nodes, std::span<const HelperClip> clips,
                   GltfRewrite& rewrite);

}  // namespace sinew::exporting
