// core/rig/field.cpp: maximal cliques of the blending graph; sums and maxima of potentials.
#include "core/rig/field.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <tuple>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/potential.h"

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

}  // namespace

Result<BlendingGraph> makeBlendingGraph(int groupCount, std::span<const GroupLink> links) {
  std::vector<float> amounts{1.0f};
  for (const GroupLink& link : links) {
    if (link.a != link.b) amounts.push_back(link.amount);
  }
  std::ranges::sort(amounts);
  amounts.erase(std::unique(amounts.begin(), amounts.end()), amounts.end());
  BlendingGraph graph;
  graph.groupCount = groupCount;
  int left = kMaxCliques;
  for (const float amount : amounts) {
    GraphLevel& level = graph.levels.emplace_back(amount);
    if (groupCount > 0 && !CliqueSearch(neighborsOf(groupCount, links, amount), left, level.cliques).run()) {
      return errorAt("links", "the blending graph has more than " + std::to_string(kMaxCliques) +
                                  " maximal sets of mutually linked groups; merge groups or remove links");
    }
    left -= static_cast<int>(level.cliques.size());
    std::ranges::sort(level.cliques);
  }
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

CliqueLists cliquesAmong(const CliqueLists& cliques, std::span<const int> presentGroups) {
  std::vector<Groups> cut;
  for (const Groups& clique : cliques) {
    Groups left;
    std::ranges::set_intersection(clique, presentGroups, std::back_inserter(left));
    if (!left.empty()) cut.push_back(std::move(left));
  }
  std::ranges::sort(
      cut, [](const Groups& a, const Groups& b) { return a.size() != b.size() ? a.size() > b.size() : a < b; });
  std::vector<Groups> maximal;
  for (const Groups& set : cut) {
    const bool contained =
        std::ranges::any_of(maximal, [&](const Groups& larger) { return std::ranges::includes(larger, set); });
    if (!contained) maximal.push_back(set);
  }
  for (Groups& clique : maximal) {
    for (int& group : clique) {
      group = static_cast<int>(std::ranges::lower_bound(presentGroups, group) - presentGroups.begin());
    }
  }
  return maximal;
}

}  // namespace

CliqueLevels cliquesAmong(const BlendingGraph& graph, std::span<const int> presentGroups) {
  CliqueLevels levels;
  double begin = 0.0;  // Of the last level's amounts,
  double end = 0.0;    // and their end.
  for (const GraphLevel& level : graph.levels) {
    CliqueLists cliques = cliquesAmong(level.cliques, presentGroups);
    if (levels.empty() || levels.back().cliques != cliques) {
      levels.push_back({0.0, std::move(cliques)});
      begin = end;
    }
    end = static_cast<double>(level.amount);
    levels.back().weight = end - begin;
  }
  const bool allAddUp = levels.size() == 1 && levels.front().cliques.size() < 2;
  return allAddUp ? CliqueLevels() : levels;
}

namespace {

/// Value and gradient of one candidate, weight and sign included.
FieldSample sampleCandidate(const PosedPrimitive& primitive, float weight, const glm::vec3& point) {
  const UnitBallMap& ball = primitive.influence;
  const float rSquared = ball.rSquared(point);
  if (!(rSquared < 1.0f) || ball.boundingRadius == 0.0f) return {};
  const float factor = primitive.strength * weight;
  return {factor * potential(rSquared), factor * potentialSlope(rSquared) * ball.rSquaredSlope(point)};
}

void add(FieldSample& sum, const FieldSample& part) {
  sum.value += part.value;
  sum.gradient += part.gradient;
}

/// The highest sum above 0, with a mean of the gradients if another one ties with it.
FieldSample highest(std::span<const FieldSample> sums) {
  FieldSample best;
  for (const FieldSample& sum : sums) {
    if (sum.value > best.value) best = sum;
  }
  FieldSample other;  // `value`: kTie minus the difference.
  float most = 0.0f;
  for (const FieldSample& sum : sums) {
    const float near = std::min(kTie - (best.value - sum.value), sum.value);
    if (!(near > 0.0f)) continue;
    const glm::vec3 apart = sum.gradient - best.gradient;
    const float pull = near * near * glm::dot(apart, apart);
    if (!(pull > most)) continue;
    most = pull;
    other = {near, sum.gradient};
  }
  const float share = other.value / kTie;
  best.gradient = (best.gradient + share * other.gradient) / (1.0f + share);
  return best;
}

}  // namespace

PosedPrimitive posedPrimitive(const FieldPrimitive& primitive, const glm::mat4& carrier, float grooves) {
  const UnitBallMap influence = unitBallMap(primitive.placement, primitive.reach, carrier);
  const float radius = influence.meanRadius / primitive.reach;
  const float groove = grooves > 0.0f && radius > 0.0f ? in_float::grooveOf(grooves, radius, primitive.reach) : 0.0f;
  return {influence, primitive.strength, radius, groove};
}

void poseField(std::span<const FieldPrimitive> primitives, std::span<const glm::mat4> boneInWorld, float grooves,
               std::vector<PosedPrimitive>& out) {
  out.resize(primitives.size());
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    out[i] = posedPrimitive(primitives[i], at(boneInWorld, primitives[i].bone), grooves);
  }
}

namespace {

/// The highest sum of a clique, with its gradient.
FieldSample highest(const CliqueLists& cliques, FieldScratch& scratch) {
  scratch.ofClique.assign(cliques.size(), {});
  for (std::size_t k = 0; k < cliques.size(); ++k) {
    for (const int slot : cliques[k]) {
      if (static_cast<std::size_t>(slot) < scratch.ofSlot.size()) add(scratch.ofClique[k], at(scratch.ofSlot, slot));
    }
  }
  return highest(scratch.ofClique);
}

/// F's maximum over shares of the cliques, with its gradient.
FieldSample softest(const CliqueLists& cliques, FieldScratch& scratch) {
  const std::vector<FieldSample>& sums = scratch.ofSlot;
  scratch.softness.resize(sums.size());
  std::vector<BlendedGroup>& groups = scratch.blend.start(cliques);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    groups[i].sum = static_cast<double>(sums[i].value);
    groups[i].softness = static_cast<double>(scratch.softness[i].value);
  }
  FieldSample out;
  out.value = static_cast<float>(scratch.blend.settle());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const float m = static_cast<float>(groups[i].share);
    out.gradient += m * (sums[i].gradient + 0.5f * (1.0f - m) * scratch.softness[i].gradient);
  }
  return out;
}

}  // namespace

FieldSample sampleField(std::span<const PosedPrimitive> primitives, std::span<const Candidate> candidates,
                        const CliqueLevels& levels, const glm::vec3& point, FieldScratch& scratch) {
  FieldSample carved;
  FieldSample linked;
  std::vector<FieldSample>& ofSlot = scratch.ofSlot;
  std::vector<FieldSample>& softness = scratch.softness;
  ofSlot.clear();
  softness.clear();
  for (const Candidate& candidate : candidates) {
    const PosedPrimitive& primitive = at(primitives, candidate.primitive);
    const FieldSample part = sampleCandidate(primitive, candidate.weight, point);
    if (primitive.strength < 0.0f) {
      add(carved, part);
    } else if (levels.empty()) {
      add(linked, part);
    } else {
      const auto slot = static_cast<std::size_t>(candidate.slot);
      if (ofSlot.size() <= slot) ofSlot.resize(slot + 1);
      add(ofSlot[slot], part);
      if (!(primitive.groove > 0.0f)) continue;
      if (softness.size() <= slot) softness.resize(slot + 1);
      add(softness[slot], {primitive.groove * part.value, primitive.groove * part.gradient});
    }
  }
  FieldSample out = linked;
  for (const CliqueLevel& level : levels) {
    const FieldSample part = softness.empty() ? highest(level.cliques, scratch) : softest(level.cliques, scratch);
    const float weight = static_cast<float>(level.weight);
    add(out, {weight * part.value, weight * part.gradient});
  }
  add(out, carved);
  return out;
}

FieldSample sampleField(std::span<const PosedPrimitive> primitives, std::span<const Candidate> candidates,
                        const CliqueLevels& levels, const glm::vec3& point) {
  FieldScratch scratch;
  return sampleField(primitives, candidates, levels, point, scratch);
}

}  // namespace sinew
