// core/character/bones_between.h: the bones on the way from one to another.
#pragma once

#include <vector>

#include "sinew/character/skeleton.h"

namespace sinew {

/// Both bones and those between them in the tree, ascending; the two alone where they have no common ancestor.
[[nodiscard]] std::vector<int> bonesBetween(const Skeleton& skeleton, int from, int to);

}  // namespace sinew
