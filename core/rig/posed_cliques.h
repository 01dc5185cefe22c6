// core/rig/posed_cliques.h: the cliques at a place for the amounts that links have in a pose.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/rig/blending_graph.h"

namespace sinew {

/// Adds links to cliques one by one. Keeps its memory.
class CliqueGrowth {
 public:
  void reserve(std::size_t cliques, std::size_t slots);  ///< For so many cliques of so many slots.
  void start(const CliqueLists& cliques) { cliques_ = cliques; }
  /// The maximal cliques with one more link. False: there would be too many; the cliques are no longer of use.
  [[nodiscard]] bool link(int a, int b);
  void sorted(CliqueLists& out);  ///< See comesFirst().

 private:
  [[nodiscard]] bool isWithinAnother(const CliqueLists& lists, std::size_t own) const;

  CliqueLists cliques_;
  CliqueLists found_;  ///< With both ends of the new link.
  CliqueLists next_;
  std::vector<int> common_;
  std::vector<std::size_t> order_;
};

/// How much memory the cliques of a place may need.
struct CliqueSizes {
  std::size_t levels = 0;
  std::size_t cliques = 0;  ///< Of a level.
  std::size_t slots = 0;
  std::size_t inCliques = 0;  ///< Sum of a level's cliques' sizes.

  void cover(const CliqueSizes& other);
};
[[nodiscard]] CliqueSizes sizesOf(CliqueLevelsView levels);
/// For all amounts; what seldom occurs is left out: memory then grows when it does.
[[nodiscard]] CliqueSizes sizesOf(const AnimatedCliques& place);

/// cliquesAmong() of one place for other amounts of its animated links. Keeps its memory.
class PosedCliques {
 public:
  void reserve(const CliqueSizes& sizes);
  /// @param amounts  of all links, 0..1; 0: not linked.  @param drawn  returned if the amounts give more cliques than
  /// kMaxCliques.  @return valid until the next call
  CliqueLevelsView pose(const AnimatedCliques& place, std::span<const float> amounts, CliqueLevelsView drawn,
                        CliqueGrowth& growth);

 private:
  /// The largest amount below a number among the place's links and levels; 0: there is none.
  [[nodiscard]] static float nextBelow(float amount, const AnimatedCliques& place, std::span<const float> amounts);
  /// Adds a level of the amounts from `low` to `high`, or to the one before if that has the same cliques.
  void add(float low, float high, CliqueGrowth& growth);

  CliqueLevels levels_;  ///< The first used_ are in use.
  std::size_t used_ = 0;
  CliqueLists cliques_;
  std::vector<float> highs_;  ///< Of the levels in use: their largest amounts.
};

}  // namespace sinew
