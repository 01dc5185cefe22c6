// core/rig/group_blend.cpp: starts from the clique with the largest sum and lets pairs exchange shares.
#include "core/rig/group_blend.h"

#include <algorithm>
#include <limits>

#include "core/geometry/at.h"
#include "core/geometry/formulas.h"

namespace sinew {
namespace in_double {
namespace {

struct ScalarBlending {
  const CliqueLists& cliques;
  std::vector<BlendedGroup>& groups;
  std::vector<double>& shares;

  /// Calls visit(group, 1) for groups of the first clique alone, visit(group, -1) for those of the second.
  template <class Visit>
  void forEachOwn(int first, int second, Visit visit) const {
    const std::vector<int>& a = at(cliques, first);
    const std::vector<int>& b = at(cliques, second);
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() || j < b.size()) {
      if (j == b.size() || (i < a.size() && a[i] < b[j])) {
        visit(at(groups, a[i++]), 1.0);
      } else if (i == a.size() || b[j] < a[i]) {
        visit(at(groups, b[j++]), -1.0);
      } else {
        ++i;
        ++j;
      }
    }
  }
};

#define formula inline
using Blending = const ScalarBlending&;
int cliqueCount(Blending blending) { return static_cast<int>(blending.cliques.size()); }
Real shareOf(Blending blending, int clique) { return at(blending.shares, clique); }
Exchange exchangeOf(Blending blending, int first, int second) {
  Exchange out{0.0, 0.0};
  blending.forEachOwn(first, second, [&](const BlendedGroup& group, Real sense) {
    out.gain += sense * softRate(group.sum, group.softness, group.share);
    out.fall += group.softness;
  });
  return out;
}
void exchange(Blending blending, int first, int second, Real given) {
  at(blending.shares, first) += given;
  at(blending.shares, second) -= given;
  blending.forEachOwn(first, second, [&](BlendedGroup& group, Real sense) { group.share += sense * given; });
}
#include "core/geometry/formulas/blend.h"
#undef formula

}  // namespace
}  // namespace in_double

std::vector<BlendedGroup>& GroupBlend::reset(const CliqueLists& cliques) {
  int last = 0;
  areAlone_ = true;
  for (const std::vector<int>& clique : cliques) {
    last = std::max(last, clique.back());
    areAlone_ = areAlone_ && clique.size() == 1;
  }
  groups_.assign(toIndex(last + 1), {});
  return groups_;
}

void GroupBlend::levelShares(double rate) {
  const auto softnessOf = [](const BlendedGroup& group) { return std::max(group.softness, 1e-12 * group.sum); };
  const auto aboveOf = [&](const BlendedGroup& group) { return group.sum + 0.5 * softnessOf(group) - rate; };
  double shares = 0.0;
  int holders = 0;
  for (std::size_t step = 0; step <= groups_.size(); ++step) {
    shares = 0.0;
    holders = 0;
    double fall = 0.0;
    for (const BlendedGroup& group : groups_) {
      const double above = aboveOf(group);
      if (above <= 0.0) continue;
      ++holders;
      shares += above / softnessOf(group);
      fall += 1.0 / softnessOf(group);
    }
    if (shares <= 1.0 + 1e-13) break;
    rate += (shares - 1.0) / fall;
  }
  for (BlendedGroup& group : groups_) {
    const double above = std::max(0.0, aboveOf(group));
    if (above > 0.0) group.share = holders == 1 ? 1.0 : above / (softnessOf(group) * shares);
    else group.share = 0.0;
  }
}

double GroupBlend::settle(const CliqueLists& cliques) {
  constexpr double kSettled = 1e-11;  // Times the largest sum.
  shares_.resize(cliques.size());
  std::size_t highest = 0;
  double largest = 0.0;
  double surely = 0.0;
  for (std::size_t k = 0; k < cliques.size(); ++k) {
    double sum = 0.0;
    double softness = 0.0;
    for (const int group : cliques[k]) {
      sum += at(groups_, group).sum;
      softness += at(groups_, group).softness;
    }
    if (sum > largest) highest = k;
    largest = std::max(largest, sum);
    surely = std::max(surely, sum - 0.5 * softness);
    shares_[k] = sum + 0.5 * softness;
  }
  if (largest <= 0.0) return 0.0;
  // Taking from a clique b for k gains at most S_k + Y_k / 2 - S_b + Y_b / 2, with sums S and softness Y.
  int others = -1;
  for (double& share : shares_) {
    share = share >= surely ? 0.0 : -1.0;
    others += share == 0.0 ? 1 : 0;
  }
  shares_[highest] = 1.0;
  for (BlendedGroup& group : groups_) group.share = 0.0;
  for (const int group : cliques[highest]) at(groups_, group).share = 1.0;
  if (others > 0 && areAlone_) levelShares(surely);
  else if (others > 0) in_double::settleShares({cliques, groups_, shares_}, kSettled * largest, true);
  double out = 0.0;
  for (const BlendedGroup& group : groups_) out += in_double::softPart(group.sum, group.softness, group.share);
  return out;
}

}  // namespace sinew
