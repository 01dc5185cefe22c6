// core/rig/blending_graph.h: which groups add up: maximal cliques of the link graph.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "sinew/geometry/result.h"

namespace sinew {

/// More maximal cliques than this are refused: nobody draws such a graph on purpose. docs/design.md.
inline constexpr int kMaxCliques = 4096;

/// The blending graph after Guy & Wyvill 1995, read as docs/design.md does: the field is the maximum over cliques of
/// sums.
struct BlendingGraph {
  int groupCount = 0;
  std::vector<std::vector<int>> cliques;  ///< Maximal, each sorted; the list sorted. Every group is in at least one.
};

/// Enumerates the maximal cliques (Bron & Kerbosch 1973, with pivoting).
/// @param links pairs of groups < groupCount; order and repeats do not matter, a group linked to itself is ignored.
/// Error: more than kMaxCliques.
[[nodiscard]] Result<BlendingGraph> makeBlendingGraph(int groupCount, std::span<const std::array<int, 2>> links);

/// The graph last asked for: its cliques are enumerated once, however often it is asked for again.
class BlendingGraphMemo {
 public:
  /// makeBlendingGraph; valid until the next call. A refused graph leaves the former one remembered.
  [[nodiscard]] Result<const BlendingGraph*> graph(int groupCount, std::span<const std::array<int, 2>> links);

 private:
  std::optional<BlendingGraph> graph_;
  std::vector<std::array<int, 2>> links_;  ///< Links of graph_.
};

/// The cliques cut down to `presentGroups` (sorted), without those another one contains: all that a place sees where
/// only these groups reach. Values there are the same as with the whole graph, as positive parts are >= 0.
[[nodiscard]] std::vector<std::vector<int>> cliquesAmong(const BlendingGraph& graph,
                                                         std::span<const int> presentGroups);

}  // namespace sinew
