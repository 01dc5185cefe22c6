// core/rig/blending_graph.cpp: finds the cliques of the graph without links below each amount.
#include "core/rig/blending_graph.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>

#include "core/geometry/at.h"

namespace sinew {

// Maximal cliques by Bron & Kerbosch, "Algorithm 457", CACM 16(9), 1973, with pivoting.

namespace {

using Groups = std::vector<int>;  // sorted

/// Lists the maximal cliques, each once. Candidates are groups linked to all members of a clique; `excluded` are those
/// whose extensions are already listed, and a clique is maximal if both lists are empty. A maximal clique contains the
/// pivot or a group not linked to it, so only those branch (choice of the pivot: Tomita, Tanaka and Takahashi 2006). A
/// graph can have 3^(n/3) maximal cliques (Moon and Moser 1965), hence the limit. docs/design.md, Many muscles.
class CliqueSearch {
 public:
  /// @param most  how many there may be.
  CliqueSearch(std::vector<Groups> neighbors, int most, std::vector<Groups>& found)
      : neighbors_(std::move(neighbors)), most_(static_cast<std::size_t>(most)), found_(found) {}

  /// False: too many.
  bool run() {
    Groups all(neighbors_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
    Groups clique;
    return extend(clique, all, {});
  }

 private:
  const Groups& neighborsOf(int group) const { return at(neighbors_, group); }

  /// Looks up members of the smaller set in the larger, which is fast for sparse graphs of thousands of groups.
  static Groups intersection(const Groups& a, const Groups& b) {
    const auto& [smaller, larger] = a.size() <= b.size() ? std::tie(a, b) : std::tie(b, a);
    Groups both;
    std::ranges::copy_if(smaller, std::back_inserter(both),
                         [&larger = larger](int group) { return std::ranges::binary_search(larger, group); });
    return both;
  }

  /// The candidate or excluded group with the most neighbors among the candidates, which need no branch.
  int pivot(const Groups& candidates, const Groups& excluded) const {
    int best = -1;
    std::size_t most = 0;
    for (const Groups* list : {&candidates, &excluded}) {
      for (const int group : *list) {
        const std::size_t count = intersection(neighborsOf(group), candidates).size();
        if (best < 0 || count > most) {
          best = group;
          most = count;
        }
      }
    }
    return best;
  }

  bool extend(Groups& clique, Groups candidates, Groups excluded) {
    if (candidates.empty() && excluded.empty()) {
      if (found_.size() == most_) return false;
      Groups sorted = clique;
      std::ranges::sort(sorted);
      found_.push_back(std::move(sorted));
      return true;
    }
    if (candidates.empty()) return true;
    Groups branches;
    std::ranges::set_difference(candidates, neighborsOf(pivot(candidates, excluded)), std::back_inserter(branches));
    for (const int group : branches) {
      clique.push_back(group);
      if (!extend(clique, intersection(candidates, neighborsOf(group)), intersection(excluded, neighborsOf(group)))) {
        return false;
      }
      clique.pop_back();
      candidates.erase(std::ranges::lower_bound(candidates, group));
      excluded.insert(std::ranges::lower_bound(excluded, group), group);
    }
    return true;
  }

  std::vector<Groups> neighbors_;
  std::size_t most_;
  std::vector<Groups>& found_;
};

/// For every group those that it is linked to by at least an amount.
std::vector<Groups> neighborsOf(int groupCount, std::span<const GroupLink> links, float amount) {
  std::vector<Groups> neighbors(static_cast<std::size_t>(groupCount));
  for (const GroupLink& link : links) {
    if (link.a == link.b || link.amount < amount) continue;
    at(neighbors, link.a).push_back(link.b);
    at(neighbors, link.b).push_back(link.a);
  }
  for (Groups& list : neighbors) {
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbors;
}

/// A level for each amount of a link, and for 1. Nothing: they have too many cliques.
std::optional<std::vector<GraphLevel>> levelsOf(int groupCount, std::span<const GroupLink> links) {
  std::vector<float> amounts{1.0f};
  for (const GroupLink& link : links) {
    if (link.a != link.b) amounts.push_back(link.amount);
  }
  std::ranges::sort(amounts);
  amounts.erase(std::unique(amounts.begin(), amounts.end()), amounts.end());
  std::vector<GraphLevel> levels;
  int left = kMaxCliques;
  for (const float amount : amounts) {
    std::vector<Groups> found;
    if (groupCount > 0 && !CliqueSearch(neighborsOf(groupCount, links, amount), left, found).run()) return std::nullopt;
    left -= static_cast<int>(found.size());
    std::ranges::sort(found);
    GraphLevel& level = levels.emplace_back(amount);
    for (const Groups& clique : found) level.cliques.add(clique);
  }
  return levels;
}

}  // namespace

Result<BlendingGraph> makeBlendingGraph(int groupCount, std::span<const GroupLink> links) {
  const Error tooMany = errorAt("links", "the blending graph has more than " + std::to_string(kMaxCliques) +
                                             " maximal sets of mutually linked groups; merge groups or remove links");
  BlendingGraph graph;
  graph.groupCount = groupCount;
  std::optional<std::vector<GraphLevel>> levels = levelsOf(groupCount, links);
  if (!levels) return tooMany;
  graph.levels = std::move(*levels);
  std::vector<GroupLink> fixed;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto& [a, b, amount, isAnimated] = links[i];
    if (!isAnimated) fixed.push_back(links[i]);
    else if (a != b) graph.animated.push_back({a, b, static_cast<int>(i)});
  }
  if (graph.animated.empty()) return graph;
  levels = levelsOf(groupCount, fixed);
  if (!levels) return tooMany;
  graph.fixed = std::move(*levels);
  return graph;
}

Result<const BlendingGraph*> BlendingGraphMemo::graph(int groupCount, std::span<const GroupLink> links) {
  if (!graph_ || graph_->groupCount != groupCount || !std::ranges::equal(links_, links)) {
    Result<BlendingGraph> made = makeBlendingGraph(groupCount, links);
    if (!made) return made.error();
    graph_ = std::move(made).value();
    links_.assign(links.begin(), links.end());
  }
  return &*graph_;
}

namespace {

int slotOf(std::span<const int> presentGroups, int group) {
  return static_cast<int>(std::ranges::lower_bound(presentGroups, group) - presentGroups.begin());
}

CliqueLists cliquesAmong(const CliqueLists& cliques, std::span<const int> presentGroups) {
  std::vector<Groups> cut;
  for (const std::span<const int> clique : cliques) {
    Groups left;
    std::ranges::set_intersection(clique, presentGroups, std::back_inserter(left));
    if (!left.empty()) cut.push_back(std::move(left));
  }
  std::ranges::sort(cut, [](const Groups& a, const Groups& b) { return comesFirst(a, b); });
  std::vector<Groups> maximal;
  for (const Groups& set : cut) {
    const bool contained =
        std::ranges::any_of(maximal, [&](const Groups& larger) { return std::ranges::includes(larger, set); });
    if (!contained) maximal.push_back(set);
  }
  CliqueLists slots;
  for (Groups& clique : maximal) {
    for (int& group : clique) group = slotOf(presentGroups, group);
    slots.add(clique);
  }
  return slots;
}

}  // namespace

bool comesFirst(std::span<const int> a, std::span<const int> b) {
  return a.size() != b.size() ? a.size() > b.size() : std::ranges::lexicographical_compare(a, b);
}

CliqueLevels cliquesAmong(const BlendingGraph& graph, std::span<const int> presentGroups) {
  CliqueLevels levels;
  double begin = 0.0;  // Of the last level's amounts,
  double end = 0.0;    // and their end.
  for (const GraphLevel& level : graph.levels) {
    CliqueLists cliques = cliquesAmong(level.cliques, presentGroups);
    if (levels.empty() || levels.back().cliques != cliques) {
      levels.push_back({0.0, std::move(cliques)});
      findOwners(levels.back().cliques, levels.back().owners);
      begin = end;
    }
    end = static_cast<double>(level.amount);
    levels.back().weight = end - begin;
  }
  return allAddUp(levels) ? CliqueLevels() : levels;
}

AnimatedCliques animatedAmong(const BlendingGraph& graph, std::span<const int> presentGroups) {
  AnimatedCliques out;
  const auto isPresent = [&](int group) { return std::ranges::binary_search(presentGroups, group); };
  for (const auto& [a, b, link] : graph.animated) {
    if (isPresent(a) && isPresent(b)) out.links.push_back({slotOf(presentGroups, a), slotOf(presentGroups, b), link});
  }
  if (out.isEmpty()) return out;
  for (const GraphLevel& level : graph.fixed) {
    out.fixed.push_back({level.amount, cliquesAmong(level.cliques, presentGroups)});
  }
  return out;
}

}  // namespace sinew
