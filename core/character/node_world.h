// core/character/node_world.h: from how nodes stand to their parents to where the bones are.
#pragma once

#include <span>
#include <vector>

#include "sinew/character/skeleton.h"

namespace sinew {

/// In double: a meter-sized bone may hang under a node scaled by 0.01.
/// @param nodes        [nodes] against the parent before, in the world after
/// @param boneInWorld  [bones] its memory is reused
void followParents(const Skeleton& skeleton, std::span<glm::dmat4> nodes, std::vector<glm::mat4>& boneInWorld);

}  // namespace sinew
