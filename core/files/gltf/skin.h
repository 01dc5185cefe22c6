// core/files/gltf/skin.h: skins and mesh nodes -> bones, bind pose, bindings (docs/design.md).
#pragma once

#include <optional>
#include <vector>

#include "core/files/gltf/accessor.h"
#include "core/files/gltf/node_tree.h"
#include "sinew/character/skeleton.h"

namespace sinew::gltf {

/// What a node's mesh is bound by.
struct MeshBinding {
  glm::dmat4 meshToBind{1.0};  ///< POSITION -> world in the bind pose.
  int skin = -1;               ///< Whose joints JOINTS_n names; -1 for a rigid mesh.
  int rigid = 0;               ///< The one binding that a rigid mesh's vertices follow.
};

struct BoundSkeleton {
  Skeleton skeleton;                               ///< Finished.
  std::vector<int> skeletonNode;                   ///< [file nodes] index into Skeleton::nodes, or -1.
  std::vector<std::optional<MeshBinding>> meshes;  ///< [file nodes] set where a mesh of the scene can be shown.
  std::vector<std::vector<int>> jointBindings;     ///< [skins][JOINTS_n value] index into Skeleton::bindings.
};

/// What becomes a bone.
enum class BonesFrom {
  kMeshes,  ///< What moves a mesh.
  kNodes,   ///< Every node of the scene, where no mesh of it has a skin; else as kMeshes.
};

/// Joints of the skins in use are bones, and every mesh node that is neither skinned nor below a joint is one of its
/// own; an unskinned mesh below a joint rides it. Refuses more than kMaxJoints, bad joint indices, too few or not
/// finite inverse bind matrices. Singular ones fall back to the rest pose, with a note.
[[nodiscard]] BoundSkeleton bindSkeleton(const File& file, const NodeTree& tree, Accessors& accessors, Notes& notes,
                                         BonesFrom from = BonesFrom::kMeshes);

}  // namespace sinew::gltf
