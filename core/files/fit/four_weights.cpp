// core/files/fit/four_weights.cpp: transfer over the patch, the largest four, skinning with them.
#include "core/files/fit/four_weights.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/geometry/at.h"

namespace sinew::exporting {

// Every choice of up to four candidates, solved in closed form.

namespace {

constexpr std::size_t kMost = 4;

/// Cholesky's factor of A = G + mu I on the candidates chosen so far, grown by one row at a time, with the forward
/// substitutions of the two right-hand sides that the weights are made of: mu near, and ones.
class Choice {
 public:
  Choice(const Gram& gram, double mu, const CandidateWeights& near) : gram_(gram), mu_(mu), near_(near) {}

  /// Takes one more. False where A is not positive definite on them.
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

  /// The least of w^T A w - 2 mu near^T w with sum 1 on the first `size`, signs aside.
  [[nodiscard]] double cost(std::size_t size) const {
    const Sums& sums = sums_[size - 1];
    return (1.0 - sums.both) * (1.0 - sums.both) / sums.ones - sums.pulls;
  }

  /// The weights of that. False where one is below 0.
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
  std::array<double, kMost> inverse_{};  ///< Reciprocals of the factor's diagonal.
  std::array<double, kMost> pull_{};
  std::array<double, kMost> ones_{};
  std::array<Sums, kMost> sums_{};
};

class BestWeightsSearch {
 public:
  BestWeightsSearch(const Gram& gram, std::size_t count, double mu, const CandidateWeights& near)
      : count_(count), choice_(gram, mu, near) {}

  CandidateWeights run() {
    extend(0, 0);
    return best_;
  }

 private:
  /// All choices that begin with the `size` candidates chosen so far, from `first` on.
  void extend(std::size_t size, std::size_t first) {
    for (std::size_t next = first; next < count_; ++next) {
      if (!choice_.add(size, next)) continue;
      const double cost = choice_.cost(size + 1);
      if (cost < least_ && choice_.weights(size + 1, best_)) least_ = cost;
      if (size + 1 < kMost) extend(size + 1, next + 1);
    }
  }

  std::size_t count_;
  Choice choice_;
  double least_ = std::numeric_limits<double>::infinity();
  CandidateWeights best_{};
};

}  // namespace

double energyOf(const Gram& gram, const CandidateWeights& weights, std::size_t count) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < count; ++k) sum += weights[i] * gram[i][k] * weights[k];
  }
  return sum;
}

CandidateWeights bestWeights(const Gram& gram, std::size_t count, double mu, const CandidateWeights& near) {
  return BestWeightsSearch(gram, count, mu, near).run();
}

namespace {

/// Adds `by` times a control vertex's weights.
void addVertex(const ControlMesh& mesh, int vertex, double by, std::vector<Share>& shares) {
  if (by <= 0.0) return;
  for (const Influence& influence : mesh.influencesOf(vertex)) {
    const auto place = std::ranges::lower_bound(shares, influence.binding, {}, &Share::binding);
    const double weight = by * static_cast<double>(influence.weight);
    if (place != shares.end() && place->binding == influence.binding) place->weight += weight;
    else shares.insert(place, {influence.binding, weight});
  }
}

}  // namespace

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
    const double n = refinement.edgeLevel(e);
    for (int step = 1; step <= refinement.edgeVertices(e); ++step) {
      std::vector<Share>& own = at(shares, refinement.edgeVertex(e, step));
      addVertex(mesh, ends[0], 1.0 - step / n, own);
      addVertex(mesh, ends[1], step / n, own);
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

}  // namespace sinew::exporting
