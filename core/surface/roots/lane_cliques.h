// core/surface/roots/lane_cliques.h: the cliques that 16 rays see, and those of them that soft grooves are between.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/rig/clique_lists.h"

namespace sinew {

/// The slots that add up in clique k: slots[begin[k] .. begin[k+1]). Empty: all slots add up.
struct LaneCliques {
  std::span<const int> begin{};
  std::span<const int> slots{};
  std::span<const int> owners{};  ///< See findOwners().
  std::size_t slotCount = 0;
  bool soft = false;  ///< Some muscle has a soft groove.
  // What PresentCliques adds:
  std::span<const float> grooves{};  ///< kappa of each slot's muscles,
  bool mixed = false;                ///< unless those of a slot have several: then y_j is a sum of its own.
  bool disjoint = false;             ///< No slot is in two cliques; those that all have are apart, in
  std::span<const int> common{};

  [[nodiscard]] bool empty() const { return slotCount == 0; }
  [[nodiscard]] std::size_t count() const { return begin.empty() ? 0 : begin.size() - 1; }
  [[nodiscard]] std::span<const int> slotsOf(std::size_t clique) const {
    return slots.subspan(static_cast<std::size_t>(begin[clique]),
                         static_cast<std::size_t>(begin[clique + 1] - begin[clique]));
  }
};

/// One of several parts of the field.
struct LaneLevel {
  float weight = 1.0f;
  LaneCliques cliques;
};

/// The parts of the field at a place; all have the same slots.
struct LaneLevels {
  LaneCliques first;
  std::span<const LaneLevel> several{};  ///< All of them, if there are several.
};

/// For soft grooves, the cliques of those slots alone that some term is in: few of all. Numbers these slots anew; of
/// disjoint cliques each gets one slot, unless there are several levels. A ray's shares are the same whatever slots its
/// neighbors add. Keeps its memory.
class PresentCliques {
 public:
  /// For up to that many levels of cliques with that many slots, which hold so many in all.
  void makeRoom(std::size_t levels, std::size_t slots, std::size_t held);

  /// @param all  must outlive the use.
  void start(const LaneLevels& all);
  void add(int slot, float groove);  ///< Of a term, also of one in every sum.
  [[nodiscard]] LaneLevels finish();
  /// Number of a slot that was added.
  [[nodiscard]] int numberOf(int slot) const {
    const int merged = mergedOf(slot);
    return together_ || merged == kInEveryClique ? kInEveryClique : numbers_[static_cast<std::size_t>(merged)];
  }

 private:
  static constexpr int kAbsent = -1;

  /// Memory for the cliques of a level.
  struct Cut {
    std::vector<int> begin;
    std::vector<int> slots;
    std::vector<int> common;
  };

  [[nodiscard]] bool isMerged() const { return all_->several.empty() && !all_->first.owners.empty(); }
  [[nodiscard]] int mergedOf(int slot) const {
    return slot == kInEveryClique || !isMerged() ? slot : all_->first.owners[static_cast<std::size_t>(slot)];
  }
  [[nodiscard]] LaneCliques cutTo(const LaneCliques& whole, Cut& cut) const;
  void cutMerged(Cut& cut) const;
  void cutSlots(const LaneCliques& whole, Cut& cut) const;

  const LaneLevels* all_ = nullptr;
  std::vector<int> numbers_;    ///< Of each slot, or kAbsent.
  std::vector<int> present_;    ///< Slots that have been added.
  std::vector<float> grooves_;  ///< Like present_.
  std::vector<float> sorted_;
  std::vector<Cut> cuts_;
  std::vector<LaneLevel> levels_;
  bool inAll_ = false;     ///< Some term is in every sum.
  bool mixed_ = false;     ///< LaneCliques::mixed
  bool together_ = false;  ///< All terms add up.
};

}  // namespace sinew
