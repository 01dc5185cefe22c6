// core/rig/mirror_pairing.h: which bones belong together, by name and by place.
#pragma once

#include <array>
#include <vector>

#include "core/rig/mirror.h"

namespace sinew {

/// {left, right} bone indices, one to one, from names alone: equal but for the side marker, then also but for the
/// number at the end, then with the marker in the name of an ancestor. What is ambiguous is left out.
[[nodiscard]] std::vector<std::array<int, 2>> pairsByName(const Skeleton& skeleton);

/// Fills twinOf and pairedBy of a plan that has its plane: named pairs that lie opposite each other, roughly; then
/// center bones and pairs by place, parents first, a pair's children among themselves before strangers.
void pairAll(MirrorPlan& plan, const std::vector<std::array<int, 2>>& named);

}  // namespace sinew
