// core/rig/blending_graph.h: the groups that add up: maximal cliques of the link graph.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "sinew/geometry/result.h"

namespace sinew {

/// Largest number of maximal cliques; nobody draws such a graph on purpose. docs/design.md.
inline constexpr int kMaxCliques = 4096;

/// The blending graph after Guy & Wyvill 1995: the field is the maximum over cliques of sums. docs/design.md.
struct BlendingGraph {
  int groupCount = 0;
  std::vector<std::vector<int>> cliques;  ///< Maximal, each sorted; the list is sorted. Every group is in at least one.
};

/// Enumerates the maximal cliques (Bron & Kerbosch 1973, with pivoting).
/// @param links pairs of groups < groupCount; order and repeats do not matter, a group linked to itself is ignored.
/// Error: more than kMaxCliques.
[[nodiscard]] Result<BlendingGraph> makeBlendingGraph(int groupCount, std::span<const std::array<int, 2>> links);

/// Remembers the last graph, so that repeated calls do not enumerate its cliques again.
class BlendingGraphMemo {
 public:
  /// makeBlendingGraph(); valid until the next call. An error keeps the graph before.
  [[nodiscard]] Result<const BlendingGraph*> graph(int groupCount, std::span<const std::array<int, 2>> links);

 private:
  std::optional<BlendingGraph> graph_;
  std::vector<std::array<int, 2>> links_;  ///< Links of graph_.
};

/// The cliques restricted to `presentGroups` (sorted), without those that others contain. Where only these groups
/// reach, the field is the same as with the whole graph, since positive parts are >= 0.
[[nodiscard]] std::vector<std::vector<int>> cliquesAmong(const BlendingGraph& graph,
                                                         std::span<const int> presentGroups);

}  // namespace sinew
