// core/rig/clique_lists.h: which groups add up at a place, and what cliques have in common.
#pragma once

#include <span>
#include <vector>

namespace sinew {

/// Groups that add up: one ascending list for each clique.
using CliqueLists = std::vector<std::vector<int>>;

/// In place of a slot, or of its clique: part of every clique's sum.
inline constexpr int kInEveryClique = -1;

/// For cliques that have only slots in common that all have: of each slot its only clique, or kInEveryClique. Empty if
/// a slot is in several cliques, but not in all.
void findOwners(const CliqueLists& cliques, std::vector<int>& owners);

/// Goes through the slots that only one of two cliques has.
class OwnSlots {
 public:
  OwnSlots(std::span<const int> first, std::span<const int> second) : first_(first), second_(second) {}

  /// False: there is no further one.
  bool next() {
    while (!first_.empty() && !second_.empty() && first_.front() == second_.front()) {
      first_ = first_.subspan(1);
      second_ = second_.subspan(1);
    }
    if (first_.empty() && second_.empty()) return false;
    ofFirst_ = second_.empty() || (!first_.empty() && first_.front() < second_.front());
    std::span<const int>& from = ofFirst_ ? first_ : second_;
    slot_ = from.front();
    from = from.subspan(1);
    return true;
  }
  [[nodiscard]] int slot() const { return slot_; }
  [[nodiscard]] bool ofFirst() const { return ofFirst_; }

 private:
  std::span<const int> first_;
  std::span<const int> second_;
  int slot_ = 0;
  bool ofFirst_ = true;
};

}  // namespace sinew
