// core/files/fit/weight_fit.cpp: the best weights of one vertex; Gram matrices over poses, solved with smoothing.
#include "core/files/fit/weight_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "core/geometry/at.h"
#include "core/geometry/parallel.h"

namespace sinew::exporting {

// One vertex.

namespace {

constexpr std::size_t kMost = 4;

/// Cholesky factor of A = G + mu I on chosen candidates, row by row, and the forward substitutions of mu near and ones.
class Choice {
 public:
  Choice(const Gram& gram, double mu, const CandidateWeights& near) : gram_(gram), mu_(mu), near_(near) {}

  /// Adds a candidate. False where A is not positive definite.
  bool add(std::size_t size, std::size_t candidate) {
    chosen_[size] = candidate;
    std::array<double, kMost>& row = factor_[size];
    Sums sums = size == 0 ? Sums{} : sums_[size - 1];
    double diagonal = gram_[candidate][candidate] + mu_;
    double pull = mu_ * near_[candidate];
    double one = 1.0;
    for (std::size_t k = 0; k < size; ++k) {
      double sum = gram_[candidate][chosen_[k]];
      for (std::size_t m = 0; m < k; ++m) sum -= row[m] * factor_[k][m];
      row[k] = sum * inverse_[k];
      diagonal -= row[k] * row[k];
      pull -= row[k] * pull_[k];
      one -= row[k] * ones_[k];
    }
    if (!(diagonal > 0.0)) return false;
    inverse_[size] = 1.0 / std::sqrt(diagonal);
    pull_[size] = pull * inverse_[size];
    ones_[size] = one * inverse_[size];
    sums.pulls += pull_[size] * pull_[size];
    sums.both += pull_[size] * ones_[size];
    sums.ones += ones_[size] * ones_[size];
    sums_[size] = sums;
    return true;
  }

  /// Minimum of w^T A w - 2 mu near^T w with sum 1 on the first `size`, whatever the signs.
  [[nodiscard]] double cost(std::size_t size) const {
    const Sums& sums = sums_[size - 1];
    return (1.0 - sums.both) * (1.0 - sums.both) / sums.ones - sums.pulls;
  }

  /// The weights at that minimum. False if one is below 0.
  bool weights(std::size_t size, CandidateWeights& out) const {
    const Sums& sums = sums_[size - 1];
    const double lambda = (1.0 - sums.both) / sums.ones;
    std::array<double, kMost> x{};
    for (std::size_t i = size; i-- > 0;) {
      x[i] = pull_[i] + lambda * ones_[i];
      for (std::size_t k = i + 1; k < size; ++k) x[i] -= factor_[k][i] * x[k];
      x[i] *= inverse_[i];
      if (!(x[i] >= 0.0)) return false;
    }
    out = {};
    for (std::size_t i = 0; i < size; ++i) out[chosen_[i]] = x[i];
    return true;
  }

 private:
  /// Products of the substituted right-hand sides.
  struct Sums {
    double pulls = 0.0;
    double both = 0.0;
    double ones = 0.0;
  };

  const Gram& gram_;
  double mu_;
  const CandidateWeights& near_;
  std::array<std::size_t, kMost> chosen_{};
  std::array<std::array<double, kMost>, kMost> factor_{};
  std::array<double, kMost> inverse_{};  ///< 1 / the factor's diagonal.
  std::array<double, kMost> pull_{};
  std::array<double, kMost> ones_{};
  std::array<Sums, kMost> sums_{};
};

/// Tries all choices that extend the first `size` candidates, from `first` on.
void extend(Choice& choice, std::size_t count, std::size_t size, std::size_t first, double& least,
            CandidateWeights& best) {
  for (std::size_t next = first; next < count; ++next) {
    if (!choice.add(size, next)) continue;
    const double cost = choice.cost(size + 1);
    if (cost < least && choice.weights(size + 1, best)) least = cost;
    if (size + 1 < kMost) extend(choice, count, size + 1, next + 1, least, best);
  }
}

}  // namespace

double energyOf(const Gram& gram, const CandidateWeights& weights, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < count; ++k) sum += weights[i] * gram[i][k] * weights[k];
  }
  return sum;
}

CandidateWeights bestWeights(const Gram& gram, std::size_t count, double mu, const CandidateWeights& near) {
  Choice choice(gram, mu, near);
  double least = std::numeric_limits<double>::infinity();
  CandidateWeights best{};
  extend(choice, count, 0, 0, least, best);
  return best;
}

namespace {

/// Adds `by` times the weights of a control vertex.
void addVertex(const ControlMesh& mesh, int vertex, double by, std::vector<Share>& shares) {
  if (by <= 0.0) return;
  for (const Influence& influence : mesh.influencesOf(vertex)) {
    addShare(shares, influence.binding, by * static_cast<double>(influence.weight));
  }
}

}  // namespace

void addShare(std::vector<Share>& shares, int binding, double weight) {
  const auto place = std::ranges::lower_bound(shares, binding, {}, &Share::binding);
  if (place != shares.end() && place->binding == binding) place->weight += weight;
  else shares.insert(place, {binding, weight});
}

FourWeights fourLargest(std::vector<Share> shares) {
  std::erase_if(shares, [](const Share& share) { return !(share.weight > 0.0); });
  assert(!shares.empty());
  std::ranges::sort(shares, [](const Share& a, const Share& b) {
    return a.weight != b.weight ? a.weight > b.weight : a.binding < b.binding;
  });
  if (shares.size() > kMostWeights) shares.resize(kMostWeights);
  double sum = 0.0;
  for (const Share& share : shares) sum += share.weight;
  FourWeights result;
  float others = 0.0f;
  for (std::size_t i = 1; i < shares.size(); ++i) {
    const auto weight = static_cast<float>(shares[i].weight / sum);
    if (!(weight > 0.0f)) break;
    result.binding[i] = shares[i].binding;
    result.weight[i] = weight;
    others += weight;
  }
  result.binding[0] = shares[0].binding;
  result.weight[0] = 1.0f - others;
  return result;
}

std::vector<std::vector<Share>> interpolatedWeights(const ControlMesh& mesh, const Refinement& refinement) {
  std::vector<std::vector<Share>> shares(toIndex(refinement.vertexCount));
  for (int v = 0; v < refinement.controlVertices; ++v) addVertex(mesh, v, 1.0, at(shares, v));
  for (int e = 0; e < refinement.controlEdges; ++e) {
    const auto& ends = at(mesh.edges, e).vertices;
    for (int step = 1; step <= refinement.edgeVertices(e); ++step) {
      std::vector<Share>& own = at(shares, refinement.edgeVertex(e, step));
      const double share = refinement.shareAt(e, step);
      addVertex(mesh, ends[0], 1.0 - share, own);
      addVertex(mesh, ends[1], share, own);
    }
  }
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const auto& corners = at(mesh.triangles, t).vertices;
    for (int v = at(refinement.insideBegin, t); v < at(refinement.insideBegin, t + 1); ++v) {
      const glm::dvec2& place = refinement.insideAt(v);
      std::vector<Share>& own = at(shares, v);
      addVertex(mesh, corners[0], 1.0 - place.x - place.y, own);
      addVertex(mesh, corners[1], place.x, own);
      addVertex(mesh, corners[2], place.y, own);
    }
  }
  return shares;
}

void bindingMatrices(const Skeleton& skeleton, const Pose& pose, std::vector<glm::dmat4>& out) {
  out.clear();
  for (const Binding& binding : skeleton.bindings) {
    out.push_back(glm::dmat4(at(pose.boneInWorld, binding.bone)) * glm::dmat4(binding.inverseBind));
  }
}

glm::dvec3 skinPoint(std::span<const glm::dmat4> matrices, const FourWeights& weights, const glm::dvec3& point) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < kMostWeights && weights.binding[i] >= 0; ++i) {
    sum += static_cast<double>(weights.weight[i]) * carryPoint(at(matrices, weights.binding[i]), point);
  }
  return sum;
}

// The fit.

namespace {

constexpr int kSweeps = 2;            ///< Smoothing sweeps.
constexpr double kSmoothness = 1e-4;  ///< mu as a fraction of the Gram matrix's mean diagonal.
constexpr double kShareStep = 3.0;    ///< Factor for letting further poses count more.
constexpr double kLeastSmoothness = 1e-12;
constexpr std::size_t kToldEvery = 1024;       ///< Vertices.
constexpr std::size_t kLeastWeightRange = 64;  ///< Vertices per thread, at least.

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

struct WeightFit::Vertex {
  std::size_t count = 0;  ///< Candidates.
  CandidateWeights start{};
  Gram all{};                        ///< All poses counted alike.
  double before = 0.0;               ///< Energy of `start`.
  std::vector<std::size_t> choices;  ///< Candidates to try.
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

FourWeights WeightFit::fourOf(std::size_t vertex, const CandidateWeights& weights) const {
  std::vector<Share> shares;
  for (std::size_t i = 0; i < candidates_[vertex].size(); ++i) {
    if (weights[i] > 0.0) shares.push_back({candidates_[vertex][i], weights[i]});
  }
  return fourLargest(std::move(shares));
}

/// Solves with the vertex's choices only.
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

/// Counts further poses as little as possible without the vertex being farther off over all poses.
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
      Vertex vertex{candidates_[v].size(), onCandidates(candidates_[v], start_[v]), gramOf(v, 1.0, 1.0), 0.0, {}};
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
      // Later sweeps have fewer choices and are fast.
      if (sweep == 0) progress.tell(static_cast<double>(first) / static_cast<double>(rest_.size()));
      const std::size_t count = std::min(kToldEvery, rest_.size() - first);
      forEachIndex(count, kLeastWeightRange, [&](std::size_t i) { solveOne(first + i); });
    }
    std::swap(current, next);
  }
  return current;
}

}  // namespace sinew::exporting
