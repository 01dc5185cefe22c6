// core/rig/clique_lists.h: which groups add up at a place, and what cliques have in common.
#pragma once

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

namespace sinew {

/// Groups that add up: one ascending list for each clique, all in one piece of memory, which clear() keeps.
class CliqueLists {
 public:
  class Iterator {
   public:
    Iterator(const CliqueLists& lists, std::size_t clique) : lists_(&lists), clique_(clique) {}
    std::span<const int> operator*() const { return (*lists_)[clique_]; }
    Iterator& operator++() {
      ++clique_;
      return *this;
    }
    bool operator==(const Iterator& other) const { return clique_ == other.clique_; }

   private:
    const CliqueLists* lists_;
    std::size_t clique_;
  };

  CliqueLists() = default;
  CliqueLists(std::initializer_list<std::initializer_list<int>> cliques) {
    for (const std::initializer_list<int>& clique : cliques) add({clique.begin(), clique.size()});
  }

  [[nodiscard]] std::size_t size() const { return begins_.empty() ? 0 : begins_.size() - 1; }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] std::span<const int> operator[](std::size_t clique) const {
    const auto first = static_cast<std::size_t>(begins_[clique]);
    return std::span(slots_).subspan(first, static_cast<std::size_t>(begins_[clique + 1]) - first);
  }
  [[nodiscard]] Iterator begin() const { return {*this, 0}; }
  [[nodiscard]] Iterator end() const { return {*this, size()}; }

  /// Clique k is slots()[begins()[k] .. begins()[k + 1]). Without cliques both are empty.
  [[nodiscard]] std::span<const int> begins() const { return begins_; }
  [[nodiscard]] std::span<const int> slots() const { return slots_; }
  [[nodiscard]] std::size_t slotCount() const { return slotCount_; }  ///< One more than the largest slot.

  void clear() {
    begins_.clear();
    slots_.clear();
    slotCount_ = 0;
  }
  void add(std::span<const int> clique) {
    if (begins_.empty()) begins_.push_back(0);
    slots_.insert(slots_.end(), clique.begin(), clique.end());
    begins_.push_back(static_cast<int>(slots_.size()));
    if (!clique.empty()) slotCount_ = std::max(slotCount_, static_cast<std::size_t>(clique.back()) + 1);
  }
  void reserve(std::size_t cliques, std::size_t slots) {
    begins_.reserve(cliques + 1);
    slots_.reserve(slots);
  }

  friend bool operator==(const CliqueLists&, const CliqueLists&) = default;

 private:
  std::vector<int> begins_;
  std::vector<int> slots_;
  std::size_t slotCount_ = 0;
};

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
