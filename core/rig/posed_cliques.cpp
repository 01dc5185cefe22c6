// core/rig/posed_cliques.cpp: goes down from the amount 1 and adds each link where its amount is reached.
#include "core/rig/posed_cliques.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/geometry/at.h"

namespace sinew {

void CliqueGrowth::reserve(std::size_t cliques, std::size_t slots) {
  for (CliqueLists* lists : {&cliques_, &next_}) lists->reserve(cliques, cliques * slots);
  // Each of the cliques with one end meets each with the other.
  const std::size_t pairs = (cliques + 1) * (cliques + 1) / 4;
  found_.reserve(pairs, pairs * slots);
  common_.reserve(slots);
  order_.reserve(cliques);
}

bool CliqueGrowth::isWithinAnother(const CliqueLists& lists, std::size_t own) const {
  for (std::size_t k = 0; k < lists.size(); ++k) {
    if (k == own || !std::ranges::includes(lists[k], lists[own])) continue;
    if (lists[k].size() > lists[own].size() || k < own) return true;  // Of equal ones the first stays.
  }
  return false;
}

/// A clique with a and b is, without either, part of one with the other end: it lies in the groups that a clique with a
/// and one with b have in common, together with a and b.
bool CliqueGrowth::link(int a, int b) {
  const auto holds = [](std::span<const int> clique, int slot) { return std::ranges::binary_search(clique, slot); };
  found_.clear();
  for (const std::span<const int> first : cliques_) {
    if (!holds(first, a)) continue;
    if (holds(first, b)) return true;  // They are linked.
    for (const std::span<const int> second : cliques_) {
      if (!holds(second, b)) continue;
      if (found_.size() == static_cast<std::size_t>(kMaxCliques)) return false;
      common_.clear();
      std::ranges::set_intersection(first, second, std::back_inserter(common_));
      for (const int end : {a, b}) common_.insert(std::ranges::lower_bound(common_, end), end);
      found_.add(common_);
    }
  }
  next_.clear();
  for (const std::span<const int> clique : cliques_) {
    const auto isPart = [&](std::span<const int> larger) { return std::ranges::includes(larger, clique); };
    const bool ends = holds(clique, a) || holds(clique, b);
    bool stays = true;
    for (std::size_t k = 0; ends && stays && k < found_.size(); ++k) stays = !isPart(found_[k]);
    if (stays) next_.add(clique);
  }
  for (std::size_t k = 0; k < found_.size(); ++k) {
    if (!isWithinAnother(found_, k)) next_.add(found_[k]);
  }
  std::swap(cliques_, next_);
  return cliques_.size() <= static_cast<std::size_t>(kMaxCliques);
}

void CliqueGrowth::sorted(CliqueLists& out) {
  order_.resize(cliques_.size());
  for (std::size_t k = 0; k < order_.size(); ++k) order_[k] = k;
  std::ranges::sort(order_, [&](std::size_t a, std::size_t b) { return comesFirst(cliques_[a], cliques_[b]); });
  out.clear();
  for (const std::size_t k : order_) out.add(cliques_[k]);
}

void CliqueSizes::cover(const CliqueSizes& other) {
  levels = std::max(levels, other.levels);
  cliques = std::max(cliques, other.cliques);
  slots = std::max(slots, other.slots);
  inCliques = std::max(inCliques, other.inCliques);
}

CliqueSizes sizesOf(CliqueLevelsView levels) {
  CliqueSizes sizes{levels.size(), 0, 0, 0};
  for (const CliqueLevel& level : levels) {
    sizes.cover({0, level.cliques.size(), level.cliques.slotCount(), level.cliques.slots().size()});
  }
  return sizes;
}

CliqueSizes sizesOf(const AnimatedCliques& place) {
  constexpr std::size_t kSeldom = 64;
  CliqueSizes sizes{place.fixed.size() + place.links.size(), 1, 0, 0};
  for (const GraphLevel& level : place.fixed) {
    sizes.cover({0, level.cliques.size(), level.cliques.slotCount(), 0});
  }
  // A link at most doubles the number of cliques; n groups have at most 3^(n/3) (Moon and Moser 1965).
  for (std::size_t i = 0; i < place.links.size() && sizes.cliques < kSeldom; ++i) sizes.cliques *= 2;
  const double most = std::min(std::pow(3.0, static_cast<double>(sizes.slots) / 3.0), 1.0 * kSeldom);
  sizes.cliques = std::min(sizes.cliques, static_cast<std::size_t>(std::ceil(most)));
  sizes.inCliques = sizes.cliques * sizes.slots;
  return sizes;
}

void PosedCliques::reserve(const CliqueSizes& sizes) {
  if (levels_.size() < sizes.levels) levels_.resize(sizes.levels);
  for (CliqueLevel& level : levels_) {
    level.cliques.reserve(sizes.cliques, sizes.inCliques);
    level.owners.reserve(sizes.slots);
  }
  highs_.reserve(sizes.levels);
  cliques_.reserve(sizes.cliques, sizes.inCliques);
}

float PosedCliques::nextBelow(float amount, const AnimatedCliques& place, std::span<const float> amounts) {
  float next = 0.0f;
  for (const GraphLevel& level : place.fixed) {
    if (level.amount < amount) next = std::max(next, level.amount);
  }
  for (const AnimatedLink& link : place.links) {
    if (at(amounts, link.link) < amount) next = std::max(next, at(amounts, link.link));
  }
  return next;
}

void PosedCliques::add(float low, float high, CliqueGrowth& growth) {
  growth.sorted(cliques_);
  if (used_ == 0 || levels_[used_ - 1].cliques != cliques_) {
    if (levels_.size() == used_) levels_.emplace_back();
    std::swap(levels_[used_].cliques, cliques_);
    ++used_;
    highs_.push_back(high);
  }
  levels_[used_ - 1].weight = static_cast<double>(highs_.back()) - static_cast<double>(low);
}

CliqueLevelsView PosedCliques::pose(const AnimatedCliques& place, std::span<const float> amounts,
                                    CliqueLevelsView drawn, CliqueGrowth& growth) {
  used_ = 0;
  highs_.clear();
  for (std::size_t i = place.fixed.size(); i-- > 0;) {
    growth.start(place.fixed[i].cliques);
    const float least = i == 0 ? 0.0f : place.fixed[i - 1].amount;
    float high = place.fixed[i].amount;
    float above = 2.0f;  // Links of amounts from `high` to here are still to be added.
    while (high > least) {
      for (const AnimatedLink& link : place.links) {
        const float amount = at(amounts, link.link);
        if (amount >= high && amount < above && !growth.link(link.a, link.b)) return drawn;
      }
      const float low = nextBelow(high, place, amounts);
      add(low, high, growth);
      above = high;
      high = low;
    }
  }
  const std::span<CliqueLevel> own = std::span(levels_).first(used_);
  std::ranges::reverse(own);
  if (allAddUp(own)) return {};
  for (CliqueLevel& level : own) findOwners(level.cliques, level.owners);
  return own;
}

}  // namespace sinew
