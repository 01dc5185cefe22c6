// core/character/node_world.cpp: parents before children.
#include "core/character/node_world.h"

#include "core/geometry/at.h"

namespace sinew {

void followParents(const Skeleton& skeleton, std::span<glm::dmat4> nodes, std::vector<glm::mat4>& boneInWorld) {
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const int parent = skeleton.nodes[n].parent;
    if (parent >= 0) nodes[n] = at(nodes, parent) * nodes[n];
  }
  boneInWorld.resize(skeleton.bones.size());
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    boneInWorld[b] = glm::mat4(at(nodes, skeleton.bones[b].node));
  }
}

}  // namespace sinew
