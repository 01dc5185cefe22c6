// core/rig/group_blend.h: soft grooves at one point: what F makes of the sums of groups that are not all linked.
#pragma once

#include <vector>

#include "core/geometry/formulas.h"
#include "core/rig/clique_lists.h"

namespace sinew {

struct BlendedGroup {
  double sum = 0.0;       ///< x_j >= 0, of all m_i f_i.
  double softness = 0.0;  ///< y_j, of all kappa_i m_i f_i.
  double share = 0.0;     ///< m_j
};

struct BlendedClique {
  double sum = 0.0;  ///< S; of disjoint cliques that of their own groups alone, like the next.
  double softness = 0.0;
  in_double::Level level{};
  double share = 0.0;  ///< Negative: it certainly has none.
};

/// F = max over shares of the cliques of sum_j x_j m_j + y_j / 2 m_j (1 - m_j), where m_j is the sum of the shares of
/// the cliques that hold group j. With y = 0 it is the largest sum of a clique; with y <= 2 x it never falls where an
/// x_j rises. docs/design.md, Grooves. Keeps its memory.
class GroupBlend {
 public:
  /// @param cliques  must outlive the use.  @return one group for each slot, with sums 0.
  std::vector<BlendedGroup>& start(const CliqueLists& cliques);
  /// The same for the cliques of the last start().
  std::vector<BlendedGroup>& clear();
  [[nodiscard]] const std::vector<BlendedGroup>& groups() const { return groups_; }
  /// Finds the shares for the groups' sums.  @return F
  double settle();

 private:
  void level();     ///< Disjoint cliques: those that have only groups in common that all have.
  void exchange();  ///< Any others.

  const CliqueLists* cliques_ = nullptr;
  std::vector<BlendedGroup> groups_;
  std::vector<int> owners_;  ///< See findOwners().
  std::vector<BlendedClique> ofClique_;
  std::vector<int> present_;  ///< Cliques with a sum.
};

}  // namespace sinew
