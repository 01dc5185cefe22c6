// core/files/fit/weight_fit.cpp: Gram matrices gathered over poses, solved with a pull towards the neighbors.
#include "core/files/fit/weight_fit.h"

#include <algorithm>
#include <cassert>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"

namespace sinew::exporting {
namespace {

constexpr int kSweeps = 2;            ///< Rounds of pulling towards the neighbors.
constexpr double kSmoothness = 1e-4;  ///< mu as a share of the Gram matrix's mean diagonal.
constexpr double kShareStep = 3.0;    ///< By which further poses are let count more.
constexpr double kLeastSmoothness = 1e-12;
constexpr std::size_t kToldEvery = 1024;       ///< Vertices.
constexpr std::size_t kLeastWeightRange = 64;  ///< Vertices that are worth a thread.

/// Neighbors of every vertex along edges, ascending.
std::vector<std::vector<int>> neighborsOf(std::size_t count, std::span<const std::array<int, 3>> triangles) {
  std::vector<std::vector<int>> result(count);
  for (const std::array<int, 3>& triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = triangle[i];
      const int b = triangle[(i + 1) % 3];
      if (toIndex(a) >= count || toIndex(b) >= count) continue;
      at(result, a).push_back(b);
      at(result, b).push_back(a);
    }
  }
  for (std::vector<int>& list : result) {
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return result;
}

CandidateWeights onCandidates(std::span<const int> candidates, const FourWeights& weights) {
  CandidateWeights result{};
  for (std::size_t i = 0; i < kMostWeights && weights.binding[i] >= 0; ++i) {
    const auto found = std::ranges::find(candidates, weights.binding[i]);
    if (found == candidates.end()) continue;
    result[static_cast<std::size_t>(found - candidates.begin())] = static_cast<double>(weights.weight[i]);
  }
  return result;
}

}  // namespace

WeightFit::WeightFit(std::vector<glm::vec3> rest, std::vector<std::vector<int>> candidates,
                     std::vector<FourWeights> start)
    : rest_(std::move(rest)), candidates_(std::move(candidates)), start_(std::move(start)) {
  assert(rest_.size() == candidates_.size() && rest_.size() == start_.size());
  begin_.push_back(0);
  for (const std::vector<int>& list : candidates_)
    begin_.push_back(begin_.back() + list.size() * (list.size() + 1) / 2);
  own_.assign(begin_.back(), 0.0);
  further_.assign(begin_.back(), 0.0);
}

void WeightFit::add(std::span<const glm::dmat4> matrices, std::span<const glm::vec3> live, bool further) {
  poses_ += 1.0;
  if (used_ == kept_.size()) kept_.emplace_back();
  Kept& kept = kept_[used_++];
  kept.matrices.assign(matrices.begin(), matrices.end());
  kept.live.assign(live.begin(), live.begin() + static_cast<std::ptrdiff_t>(rest_.size()));
  kept.further = further;
  if (used_ == kPosesAtOnce) addKept();
}

void WeightFit::addKept() {
  std::vector<PoseToFit> poses;
  for (const Kept& kept : std::span(kept_).first(used_)) poses.push_back({kept.matrices, kept.live, kept.further});
  used_ = 0;
  const GramSums sums{rest_, candidates_, begin_, own_.data(), further_.data(), poses};
  const FitKernels kernels = fitKernels(chosenVectorSet());
  forRanges(rest_.size(), kLeastWeightRange,
            [&](std::size_t first, std::size_t end) { kernels.addGrams(sums, first, end); });
}

/// What a vertex is solved with.
struct WeightFit::Vertex {
  std::size_t count = 0;  ///< Candidates.
  CandidateWeights start{};
  Gram all{};                        ///< Every pose counted alike.
  double before = 0.0;               ///< With the weights it starts with.
  std::vector<std::size_t> choices;  ///< Candidates that are tried.
};

Gram WeightFit::gramOf(std::size_t vertex, double ownShare, double furtherShare) const {
  Gram gram{};
  std::size_t sum = begin_[vertex];
  for (std::size_t i = 0; i < candidates_[vertex].size(); ++i) {
    for (std::size_t k = 0; k <= i; ++k, ++sum) {
      gram[i][k] = gram[k][i] = ownShare * own_[sum] + furtherShare * further_[sum];
    }
  }
  return gram;
}

CandidateWeights WeightFit::startOf(std::size_t vertex) const {
  return onCandidates(candidates_[vertex], start_[vertex]);
}

FourWeights WeightFit::fourOf(std::size_t vertex, const CandidateWeights& weights) const {
  std::vector<Share> shares;
  for (std::size_t i = 0; i < candidates_[vertex].size(); ++i) {
    if (weights[i] > 0.0) shares.push_back({candidates_[vertex][i], weights[i]});
  }
  return fourLargest(std::move(shares));
}

/// Among the vertex's choices alone.
CandidateWeights WeightFit::solveAmong(const Vertex& vertex, const Gram& gram, const CandidateWeights& near) const {
  double trace = 0.0;
  for (std::size_t i = 0; i < vertex.count; ++i) trace += gram[i][i];
  const double mu = std::max(kSmoothness * trace / static_cast<double>(vertex.count), kLeastSmoothness);
  Gram own{};
  CandidateWeights ownNear{};
  for (std::size_t i = 0; i < vertex.choices.size(); ++i) {
    ownNear[i] = near[vertex.choices[i]];
    for (std::size_t k = 0; k < vertex.choices.size(); ++k) own[i][k] = gram[vertex.choices[i]][vertex.choices[k]];
  }
  const CandidateWeights best = bestWeights(own, vertex.choices.size(), mu, ownNear);
  CandidateWeights result{};
  for (std::size_t i = 0; i < vertex.choices.size(); ++i) result[vertex.choices[i]] = best[i];
  return result;
}

CandidateWeights WeightFit::meanOf(std::size_t vertex, const std::vector<int>& neighbors,
                                   const std::vector<FourWeights>& current) const {
  CandidateWeights mean{};
  for (const int other : neighbors) {
    const CandidateWeights theirs = onCandidates(candidates_[vertex], at(current, other));
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += theirs[i] / static_cast<double>(neighbors.size());
  }
  return mean;
}

/// With further poses counting as little as they may without the vertex being farther off over all poses.
CandidateWeights WeightFit::notWorse(std::size_t index, const Vertex& vertex, const CandidateWeights& near,
                                     double furtherShare) const {
  for (double share = furtherShare;; share = std::min(1.0, kShareStep * share)) {
    const CandidateWeights best = solveAmong(vertex, gramOf(index, 1.0, share), near);
    if (energyOf(vertex.all, best, vertex.count) <= vertex.before) return best;
    if (share >= 1.0) return vertex.start;
  }
}

std::vector<FourWeights> WeightFit::solve(std::span<const std::array<int, 3>> triangles, double furtherShare,
                                          double tolerance, const StageProgress& progress) {
  addKept();
  const std::vector<std::vector<int>> neighbors = neighborsOf(rest_.size(), triangles);
  std::vector<FourWeights> current = start_;
  std::vector<FourWeights> next = start_;
  for (int sweep = 0; sweep <= kSweeps; ++sweep) {
    const auto solveOne = [&](std::size_t v) {
      Vertex vertex{candidates_[v].size(), startOf(v), gramOf(v, 1.0, 1.0), 0.0, {}};
      vertex.before = energyOf(vertex.all, vertex.start, vertex.count);
      if (vertex.before <= poses_ * tolerance * tolerance) return;
      const bool smooths = sweep > 0 && !neighbors[v].empty();
      const CandidateWeights near = smooths ? meanOf(v, neighbors[v], current) : vertex.start;
      const CandidateWeights now = onCandidates(candidates_[v], current[v]);
      for (std::size_t i = 0; i < vertex.count; ++i) {
        if (sweep == 0 || near[i] + now[i] + vertex.start[i] > 0.0) vertex.choices.push_back(i);
      }
      next[v] = fourOf(v, notWorse(v, vertex, near, furtherShare));
    };
    for (std::size_t first = 0; first < rest_.size(); first += kToldEvery) {
      // The sweeps after the first choose among fewer and are soon done.
      if (sweep == 0) progress.tell(static_cast<double>(first) / static_cast<double>(rest_.size()));
      const std::size_t count = std::min(kToldEvery, rest_.size() - first);
      forEachIndex(count, kLeastWeightRange, [&](std::size_t i) { solveOne(first + i); });
    }
    std::swap(current, next);
  }
  return current;
}

}  // namespace sinew::exporting
