// core/rig/group_blend.cpp: levels disjoint cliques; lets pairs of others exchange shares, from the one with the
// largest sum on.
#include "core/rig/group_blend.h"

#include <algorithm>

#include "core/geometry/at.h"
#include "core/geometry/formulas.h"

namespace sinew {
namespace in_double {
namespace {

/// Disjoint cliques whose own groups have a sum.
struct ScalarLeveling {
  std::vector<BlendedClique>& cliques;
  const std::vector<int>& indices;

  BlendedClique& operator[](int index) const { return at(cliques, at(indices, index)); }
};

struct ScalarBlending {
  const CliqueLists& cliques;
  std::vector<BlendedGroup>& groups;
  std::vector<BlendedClique>& ofClique;

  OwnSlots ownSlots(int first, int second) const { return {at(cliques, first), at(cliques, second)}; }
};

#define formula inline
using Leveling = const ScalarLeveling&;
int levelCount(Leveling cliques) { return static_cast<int>(cliques.indices.size()); }
Real sumOf(Leveling cliques, int clique) { return cliques[clique].sum; }
Real softnessOf(Leveling cliques, int clique) { return cliques[clique].softness; }
Level levelOf(Leveling cliques, int clique) { return cliques[clique].level; }
void setLevel(Leveling cliques, int clique, Level level) { cliques[clique].level = level; }
void giveShare(Leveling cliques, int clique, Real share) { cliques[clique].share = share; }

using Blending = const ScalarBlending&;
int cliqueCount(Blending blending) { return static_cast<int>(blending.cliques.size()); }
Real shareOf(Blending blending, int clique) { return at(blending.ofClique, clique).share; }
Exchange exchangeOf(Blending blending, int first, int second) {
  Exchange out{0.0, 0.0};
  for (OwnSlots own = blending.ownSlots(first, second); own.next();) {
    const BlendedGroup& group = at(blending.groups, own.slot());
    const Real rate = softRate(group.sum, group.softness, group.share);
    out.gain += own.ofFirst() ? rate : -rate;
    out.fall += group.softness;
  }
  return out;
}
void exchange(Blending blending, int first, int second, Real given) {
  at(blending.ofClique, first).share += given;
  at(blending.ofClique, second).share -= given;
  for (OwnSlots own = blending.ownSlots(first, second); own.next();) {
    at(blending.groups, own.slot()).share += own.ofFirst() ? given : -given;
  }
}
#include "core/geometry/formulas/blend.h"
#undef formula

}  // namespace
}  // namespace in_double

std::vector<BlendedGroup>& GroupBlend::start(const CliqueLists& cliques) {
  cliques_ = &cliques;
  groups_.resize(cliques.slotCount());
  findOwners(cliques, owners_);
  return clear();
}

std::vector<BlendedGroup>& GroupBlend::clear() {
  std::ranges::fill(groups_, BlendedGroup{});
  return groups_;
}

double GroupBlend::settle() {
  ofClique_.assign(cliques_->size(), {});
  if (owners_.empty()) exchange();
  else level();
  double out = 0.0;
  for (const BlendedGroup& group : groups_) out += in_double::softPart(group.sum, group.softness, group.share);
  return out;
}

void GroupBlend::level() {
  present_.clear();
  for (std::size_t slot = 0; slot < groups_.size(); ++slot) {
    if (owners_[slot] == kInEveryClique || groups_[slot].sum == 0.0) continue;
    BlendedClique& clique = at(ofClique_, owners_[slot]);
    if (clique.sum == 0.0) present_.push_back(owners_[slot]);
    clique.sum += groups_[slot].sum;
    clique.softness += groups_[slot].softness;
  }
  in_double::levelShares({ofClique_, present_}, 1e-12, 1e-13);
  for (std::size_t slot = 0; slot < groups_.size(); ++slot) {
    groups_[slot].share = owners_[slot] == kInEveryClique ? 1.0 : at(ofClique_, owners_[slot]).share;
  }
}

void GroupBlend::exchange() {
  constexpr double kSettled = 1e-11;  // Times the largest sum.
  const CliqueLists& cliques = *cliques_;
  std::size_t highest = 0;
  double largest = 0.0;
  double surely = 0.0;
  for (std::size_t k = 0; k < cliques.size(); ++k) {
    BlendedClique& clique = ofClique_[k];
    for (const int slot : cliques[k]) {
      clique.sum += at(groups_, slot).sum;
      clique.softness += at(groups_, slot).softness;
    }
    if (clique.sum > largest) highest = k;
    largest = std::max(largest, clique.sum);
    surely = std::max(surely, clique.sum - 0.5 * clique.softness);
  }
  if (largest <= 0.0) return;
  // Taking from a clique b for k gains at most S_k + Y_k / 2 - S_b + Y_b / 2, with sums S and softness Y.
  int others = -1;
  for (BlendedClique& clique : ofClique_) {
    const bool mayShare = clique.sum > 0.0 && clique.sum + 0.5 * clique.softness >= surely;
    clique.share = mayShare ? 0.0 : -1.0;
    others += mayShare ? 1 : 0;
  }
  ofClique_[highest].share = 1.0;
  for (const int slot : cliques[highest]) at(groups_, slot).share = 1.0;
  if (others > 0) in_double::settleShares({cliques, groups_, ofClique_}, kSettled * largest, true);
}

}  // namespace sinew
