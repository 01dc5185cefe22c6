// core/surface/roots/lane_cliques.cpp: collects slots, numbers them in their order and cuts cliques to them.
#include "core/surface/roots/lane_cliques.h"

#include <algorithm>

#include "core/geometry/at.h"

namespace sinew {

void PresentCliques::makeRoom(std::size_t levels, std::size_t slots, std::size_t held) {
  if (numbers_.size() < slots) numbers_.resize(slots, kAbsent);
  present_.reserve(slots);
  grooves_.reserve(slots);
  sorted_.reserve(slots);
  levels_.reserve(levels);
  if (cuts_.size() < levels) cuts_.resize(levels);
  for (Cut& cut : cuts_) {
    cut.begin.reserve(held + 1);
    cut.slots.reserve(held);
    cut.common.reserve(slots);
  }
}

void PresentCliques::start(const LaneLevels& all) {
  for (const int slot : present_) at(numbers_, slot) = kAbsent;
  present_.clear();
  grooves_.clear();
  all_ = &all;
  inAll_ = mixed_ = together_ = false;
}

void PresentCliques::add(int slot, float groove) {
  // Doubling is exact: twice the sum has the bits of the sum of the doubles.
  constexpr float kTwice = 2.0f;
  const int merged = mergedOf(slot);
  if (merged == kInEveryClique) {
    inAll_ = true;
    return;
  }
  int& number = at(numbers_, merged);
  if (number == kAbsent) {
    number = static_cast<int>(present_.size());
    present_.push_back(merged);
    grooves_.push_back(groove);
  } else {
    mixed_ = mixed_ || groove != kTwice || at(grooves_, number) != kTwice;
  }
}

LaneLevels PresentCliques::finish() {
  LaneLevels out;
  out.first.soft = true;
  // The bits must be those that rays with more slots have: x in one register, and x beside sums of 0; of several levels
  // the mean of x.
  together_ = present_.empty() || (present_.size() == 1 && !inAll_ && all_->several.empty());
  if (together_) return out;
  std::ranges::sort(present_);
  sorted_.clear();
  for (const int slot : present_) {
    sorted_.push_back(at(grooves_, at(numbers_, slot)));
    at(numbers_, slot) = static_cast<int>(sorted_.size()) - 1;
  }
  if (all_->several.empty()) {
    out.first = cutTo(all_->first, cuts_.front());
    return out;
  }
  levels_.clear();
  for (const LaneLevel& level : all_->several) {
    levels_.push_back({level.weight, cutTo(level.cliques, cuts_[levels_.size()])});
  }
  out.first = levels_.front().cliques;
  out.several = levels_;
  return out;
}

LaneCliques PresentCliques::cutTo(const LaneCliques& whole, Cut& cut) const {
  cut.begin.assign(1, 0);
  cut.slots.clear();
  cut.common.clear();
  if (isMerged()) cutMerged(cut);
  else cutSlots(whole, cut);
  LaneCliques out;
  out.begin = cut.begin;
  out.slots = cut.slots;
  out.slotCount = present_.size();
  out.soft = true;
  out.grooves = sorted_;
  out.mixed = mixed_;
  out.disjoint = !whole.owners.empty();
  out.common = cut.common;
  return out;
}

/// Each clique is a slot.
void PresentCliques::cutMerged(Cut& cut) const {
  for (int i = 0; i < static_cast<int>(present_.size()); ++i) {
    cut.slots.push_back(i);
    cut.begin.push_back(i + 1);
  }
}

void PresentCliques::cutSlots(const LaneCliques& whole, Cut& cut) const {
  const auto isCommon = [&](int slot) { return !whole.owners.empty() && at(whole.owners, slot) == kInEveryClique; };
  for (std::size_t k = 0; k < whole.count(); ++k) {
    for (const int slot : whole.slotsOf(k)) {
      const int number = at(numbers_, slot);
      if (number != kAbsent && !isCommon(slot)) cut.slots.push_back(number);
    }
    const int end = static_cast<int>(cut.slots.size());
    if (cut.begin.back() < end) cut.begin.push_back(end);
  }
  for (const int slot : present_) {
    if (isCommon(slot)) cut.common.push_back(at(numbers_, slot));
  }
}

}  // namespace sinew
