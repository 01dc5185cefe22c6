// core/rig/clique_lists.cpp: counts the cliques of each slot, then names the only one.
#include "core/rig/clique_lists.h"

#include <algorithm>

#include "core/geometry/at.h"

namespace sinew {

void findOwners(const CliqueLists& cliques, std::vector<int>& owners) {
  owners.assign(cliques.slotCount(), 0);  // At first how many cliques have each slot.
  for (const int slot : cliques.slots()) ++at(owners, slot);
  const int all = static_cast<int>(cliques.size());
  if (std::ranges::any_of(owners, [&](int count) { return count > 1 && count < all; })) return owners.clear();
  std::ranges::replace(owners, all, kInEveryClique);
  for (int k = 0; k < all; ++k) {
    for (const int slot : cliques[toIndex(k)]) {
      if (at(owners, slot) != kInEveryClique) at(owners, slot) = k;
    }
  }
}

}  // namespace sinew
