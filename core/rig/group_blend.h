// core/rig/group_blend.h: soft grooves at one point: what F makes of the sums of groups that are not all linked.
#pragma once

#include <vector>

namespace sinew {

/// Groups that add up: one ascending list for each clique.
using CliqueLists = std::vector<std::vector<int>>;

struct BlendedGroup {
  double sum = 0.0;       ///< x_j >= 0, of all m_i f_i.
  double softness = 0.0;  ///< y_j, of all kappa_i m_i f_i.
  double share = 0.0;     ///< m_j
};

/// F = max over shares of the cliques of sum_j x_j m_j + y_j / 2 m_j (1 - m_j), where m_j is the sum of the shares of
/// the cliques that hold group j. With y = 0 it is the largest sum of a clique; with y <= 2 x it never falls where an
/// x_j rises. docs/design.md, Grooves. Keeps its memory.
class GroupBlend {
 public:
  /// One group for each slot, with sums 0.
  std::vector<BlendedGroup>& reset(const CliqueLists& cliques);
  /// Finds the shares for the groups' sums.  @return F
  double settle(const CliqueLists& cliques);

 private:
  /// For cliques of one group each. Where F is largest, a share changes it as much for every group that has one: by
  /// rate = x + y / 2 - y share. The sum of the shares falls with the rate, by straight pieces that get less steep, so
  /// Newton's steps from below end at the rate for 1.
  /// @param rate  the largest x - y / 2
  void levelShares(double rate);

  std::vector<BlendedGroup> groups_;
  bool areAlone_ = true;        ///< Every clique is one group.
  std::vector<double> shares_;  ///< Of each clique; negative: it certainly has none.
};

}  // namespace sinew
