// core/files/gltf/skin.h: skins and mesh nodes -> bones, bind pose, bindings (docs/design.md).
#pragma once

#include <optional>
#include <vector>

#include "core/files/gltf/accessor.h"
#include "core/files/gltf/node_tree.h"
#include "sinew/character/skeleton.h"

namespace sinew::gltf {

struct MeshBinding {
  glm::dmat4 meshToBind{1.0};  ///< POSITION -> world in the bind pose.
  int skin = -1;               ///< -1 for a rigid mesh.
  int rigid = 0;               ///< The binding of a rigid mesh.
};

struct BoundSkeleton {
  Skeleton skeleton;                               ///< Finished.
  std::vector<int> skeletonNode;                   ///< [file nodes] index into Skeleton::nodes, or -1.
  std::vector<std::optional<MeshBinding>> meshes;  ///< [file nodes] of meshes in the scene.
  std::vector<std::vector<int>> jointBindings;     ///< [skins][JOINTS_n value] index into Skeleton::bindings.
};

enum class BonesFrom {
  kMeshes,  ///< Those that move a mesh.
  kNodes,   ///< Every node of a scene without skinned meshes; else as kMeshes.
};

/// Bones are the joints of skins in use, and mesh nodes that are neither skinned nor below a joint; an unskinned mesh
/// below a joint follows it. Refuses more than kMaxJoints, bad joint indices, and too few or not finite inverse bind
/// matrices. Singular ones are replaced by the rest pose, with a note.
[[nodiscard]] BoundSkeleton bindSkeleton(const File& file, const NodeTree& tree, Accessors& accessors, Notes& notes,
                                         BonesFrom from = BonesFrom::kMeshes);

}  // namespace sinew::gltf
