// core/rig/blending_graph.h: the groups that add up: maximal cliques of the link graph, for each amount of a link.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/rig/clique_lists.h"
#include "sinew/geometry/result.h"

namespace sinew {

/// Largest number of maximal cliques; nobody draws such a graph on purpose. docs/design.md.
inline constexpr int kMaxCliques = 4096;

/// Two groups and how much they blend, above 0, at most 1.
struct GroupLink {
  int a = 0;
  int b = 0;
  float amount = 1.0f;
  bool isAnimated = false;  ///< Keys or drivers change the amount.

  friend bool operator==(const GroupLink&, const GroupLink&) = default;
};

/// The graph without links below an amount.
struct GraphLevel {
  float amount = 1.0f;
  CliqueLists cliques;  ///< Of groups: maximal, each sorted; the list is sorted. Every group is in at least one.
};

/// A link whose amount keys or drivers change.
struct AnimatedLink {
  int a = 0;
  int b = 0;
  int link = 0;  ///< Its index among all links.
};

/// The blending graph after Guy & Wyvill 1995: the field is the maximum over cliques of sums; with links in part, the
/// mean of these over all amounts that a link may have to have. docs/design.md.
struct BlendingGraph {
  int groupCount = 0;
  std::vector<GraphLevel> levels;  ///< For each amount of a link, ascending; the last is that of 1. Not empty.
  std::vector<AnimatedLink> animated;
  std::vector<GraphLevel> fixed;  ///< The same levels without animated links; empty if there are none.
};

/// Enumerates the maximal cliques (Bron & Kerbosch 1973, with pivoting).
/// @param links  between groups < groupCount; order does not matter, of repeats the largest amount counts, a group
/// linked to itself is ignored.
/// Error: more than kMaxCliques.
[[nodiscard]] Result<BlendingGraph> makeBlendingGraph(int groupCount, std::span<const GroupLink> links);

/// Remembers the last graph, so that repeated calls do not enumerate its cliques again.
class BlendingGraphMemo {
 public:
  /// makeBlendingGraph(); valid until the next call. An error keeps the graph before.
  [[nodiscard]] Result<const BlendingGraph*> graph(int groupCount, std::span<const GroupLink> links);

 private:
  std::optional<BlendingGraph> graph_;
  std::vector<GroupLink> links_;  ///< Links of graph_.
};

/// One part of the field at a place.
struct CliqueLevel {
  double weight = 1.0;
  CliqueLists cliques;           ///< Of slots.
  std::vector<int> owners = {};  ///< See findOwners().
};
/// The parts of the field at a place, whose weights add up to 1: several where groups are linked in part. Empty: all
/// groups add up.
using CliqueLevels = std::vector<CliqueLevel>;
using CliqueLevelsView = std::span<const CliqueLevel>;
[[nodiscard]] inline bool allAddUp(CliqueLevelsView levels) {
  return levels.size() == 1 && levels.front().cliques.size() < 2;
}
/// The order of cliques at a place: larger ones first, those of a size by their slots.
[[nodiscard]] bool comesFirst(std::span<const int> a, std::span<const int> b);

/// The cliques restricted to `presentGroups` (sorted), without those that others contain, as slots: their indices
/// there. Where only these groups reach, the field is the same as with the whole graph, since positive parts are >= 0.
[[nodiscard]] CliqueLevels cliquesAmong(const BlendingGraph& graph, std::span<const int> presentGroups);

/// What cliquesAmong() needs for other amounts of the animated links.
struct AnimatedCliques {
  std::vector<GraphLevel> fixed;    ///< Of slots, without animated links.
  std::vector<AnimatedLink> links;  ///< Between slots.

  [[nodiscard]] bool isEmpty() const { return links.empty(); }  ///< No such link joins groups of the place.
};
[[nodiscard]] AnimatedCliques animatedAmong(const BlendingGraph& graph, std::span<const int> presentGroups);

}  // namespace sinew
