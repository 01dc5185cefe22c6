// core/surface/projection/candidates.cpp: candidates of vertices gathered for edges and triangles.
#include "core/surface/projection/candidates.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>

namespace sinew {
namespace {

class Gatherer {
 public:
  Gatherer(const Attachment& attachment, CandidateLists& out) : attachment_(attachment), out_(out) {
    out_.begin.push_back(0);
    if (out_.cliqueSets.empty()) out_.cliqueSets.emplace_back();
  }

  /// Merges the candidates of the corners, each of which are in ascending order.
  void addCarrier(std::span<const int> corners) {
    const std::size_t first = out_.items.size();
    std::array<std::span<const Candidate>, 3> left{};
    for (std::size_t corner = 0; corner < corners.size(); ++corner) {
      left[corner] = at(attachment_.candidatesOfVertex, corners[corner]);
    }
    while (const std::optional<int> next = nextIn(left)) {
      CarrierCandidate& added = out_.items.emplace_back(CarrierCandidate{*next, 0, {}});
      for (std::size_t corner = 0; corner < corners.size(); ++corner) {
        if (left[corner].empty() || left[corner].front().primitive != *next) continue;
        added.weights[corner] = left[corner].front().weight;
        left[corner] = left[corner].subspan(1);
      }
    }
    finishCarrier(first);
  }

  /// Adds a carrier with its candidates, except hidden ones.
  void addShown(std::span<const CarrierCandidate> candidates, int cliqueSet, const std::vector<bool>& hidden) {
    const std::size_t first = out_.items.size();
    std::ranges::copy_if(candidates, std::back_inserter(out_.items),
                         [&](const CarrierCandidate& candidate) { return !at(hidden, candidate.primitive); });
    const bool all = out_.items.size() - first == candidates.size();
    all ? closeCarrier(cliqueSet) : finishCarrier(first);
  }

  /// Adds a carrier for other links.
  void addRelinked(std::span<const CarrierCandidate> candidates) {
    const std::size_t first = out_.items.size();
    out_.items.insert(out_.items.end(), candidates.begin(), candidates.end());
    finishCarrier(first);
  }

 private:
  void finishCarrier(std::size_t first) { closeCarrier(numberSlots(std::span(out_.items).subspan(first))); }

  void closeCarrier(int cliqueSet) {
    out_.cliqueSet.push_back(cliqueSet);
    out_.begin.push_back(static_cast<int>(out_.items.size()));
  }

  static std::optional<int> nextIn(std::span<const std::span<const Candidate>> lists) {
    std::optional<int> next;
    for (const std::span<const Candidate> list : lists) {
      if (!list.empty() && (!next || list.front().primitive < *next)) next = list.front().primitive;
    }
    return next;
  }

  int groupOf(const CarrierCandidate& candidate) const { return at(attachment_.primitives, candidate.primitive).group; }

  /// Numbers the groups present and returns the index of their clique set, which many carriers have in common.
  int numberSlots(std::span<CarrierCandidate> own) {
    std::vector<int> groups;
    for (const CarrierCandidate& candidate : own) groups.push_back(groupOf(candidate));
    std::ranges::sort(groups);
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    for (CarrierCandidate& candidate : own) {
      candidate.slot = static_cast<int>(std::ranges::lower_bound(groups, groupOf(candidate)) - groups.begin());
    }
    if (groups.size() < 2) return 0;
    const auto known = setOfGroups_.find(groups);
    if (known != setOfGroups_.end()) return known->second;
    const int index = makeSet(groups);
    setOfGroups_.emplace(std::move(groups), index);
    return index;
  }

  int makeSet(const std::vector<int>& groups) {
    CliqueSet set{cliquesAmong(attachment_.graph, groups), animatedAmong(attachment_.graph, groups)};
    if (set.drawn.empty() && set.animated.isEmpty()) return 0;
    out_.most.cover(sizesOf(set.drawn));
    out_.cliqueSets.push_back(std::move(set));
    return static_cast<int>(out_.cliqueSets.size()) - 1;
  }

  const Attachment& attachment_;
  CandidateLists& out_;
  std::map<std::vector<int>, int> setOfGroups_;
};

}  // namespace

bool sameSeen(const CandidateLists& a, const CandidateLists& b) {
  return &a == &b || (a.begin == b.begin && a.cliqueSet == b.cliqueSet && a.items == b.items);
}

void PosedCliqueSets::pose(const CandidateLists& lists, std::span<const float> amounts) {
  const std::size_t count = lists.cliqueSets.size();
  if (sets_.size() < count) sets_.resize(count);
  views_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const CliqueSet& set = lists.cliqueSets[i];
    views_[i] = set.drawn;
    if (set.animated.isEmpty()) continue;
    const CliqueSizes sizes = sizesOf(set.animated);
    growth_.reserve(sizes.cliques, sizes.slots);
    sets_[i].reserve(sizes);
    views_[i] = sets_[i].pose(set.animated, amounts, set.drawn, growth_);
    most_.cover(sizes);
    most_.cover(sizesOf(views_[i]));
  }
}

CandidateLists relinked(const CandidateLists& lists, const Attachment& attachment) {
  CandidateLists out;
  out.items.reserve(lists.items.size());
  Gatherer gatherer(attachment, out);
  for (std::size_t carrier = 0; carrier < lists.cliqueSet.size(); ++carrier) {
    gatherer.addRelinked(lists.of(static_cast<int>(carrier)));
  }
  return out;
}

CandidateLists makeCandidateLists(const ControlMesh& mesh, const Attachment& attachment, const MeshLayers* layers) {
  CandidateLists lists;
  Gatherer gatherer(attachment, lists);
  std::size_t carrier = 0;
  const auto add = [&](std::span<const int> corners) {
    const bool isSkin = !layers || layers->carriers[carrier] == SkinLayer::kSkin;
    gatherer.addCarrier(isSkin ? corners : std::span<const int>());
    ++carrier;
  };
  for (int v = 0; v < static_cast<int>(mesh.positions.size()); ++v) add(std::span(&v, 1));
  for (const Edge& edge : mesh.edges) add(edge.vertices);
  for (const ControlTriangle& triangle : mesh.triangles) add(triangle.vertices);
  return lists;
}

CandidateLists withoutHidden(const CandidateLists& lists, const Attachment& attachment,
                             const std::vector<bool>& hidden) {
  CandidateLists shown;
  shown.items.reserve(lists.items.size());
  shown.cliqueSets = lists.cliqueSets;
  shown.most = lists.most;
  Gatherer gatherer(attachment, shown);
  for (std::size_t carrier = 0; carrier < lists.cliqueSet.size(); ++carrier) {
    gatherer.addShown(lists.of(static_cast<int>(carrier)), lists.cliqueSet[carrier], hidden);
  }
  return shown;
}

}  // namespace sinew
