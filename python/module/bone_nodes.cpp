// python/module/bone_nodes.cpp: the first stages of the import again, as far as they tell where bones come from.
#include "python/module/bone_nodes.h"

#include <algorithm>

#include "core/files/export/source.h"
#include "core/files/gltf/accessor.h"
#include "core/files/gltf/file.h"
#include "core/files/gltf/skin.h"
#include "core/geometry/at.h"

namespace sinew::python {

Result<std::vector<int>> nodesOfBones(const std::filesystem::path& file, const Skeleton& skeleton) {
  return exporting::catchErrors(file, file, [&]() -> Result<std::vector<int>> {
    const gltf::File contents(file);
    gltf::Notes notes;  // The import has told them.
    gltf::Accessors accessors(contents);
    const gltf::NodeTree tree = gltf::readNodes(contents, notes);
    const gltf::BoundSkeleton bound = gltf::bindSkeleton(contents, tree, accessors, notes);
    if (!std::ranges::equal(bound.skeleton.bones, skeleton.bones, {}, &Bone::path, &Bone::path)) {
      return Error{file.string(), {}, "has changed since it was opened: its joints are others; open it again"};
    }
    std::vector<int> fileNode(bound.skeleton.nodes.size(), -1);
    for (std::size_t node = 0; node < bound.skeletonNode.size(); ++node) {
      if (bound.skeletonNode[node] >= 0) at(fileNode, bound.skeletonNode[node]) = static_cast<int>(node);
    }
    std::vector<int> nodes;
    for (const Bone& bone : bound.skeleton.bones) nodes.push_back(at(fileNode, bone.node));
    return nodes;
  });
}

}  // namespace sinew::python
