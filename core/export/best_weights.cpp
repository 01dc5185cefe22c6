// core/export/best_weights.cpp: every choice of up to four candidates, solved in closed form.
#include "core/export/best_weights.h"

#include <cmath>
#include <limits>
#include <span>

namespace sinew::exporting {
namespace {

constexpr std::size_t kMost = 4;

/// The weights of one choice of candidates.
class Choice {
 public:
  Choice(const Gram& gram, double mu, const CandidateWeights& near) : gram_(gram), mu_(mu), near_(near) {}

  /// Cholesky's factor of (G + mu I) on the choice, one row more; false where it is not positive definite.
  bool factorRow(std::span<const std::size_t> chosen, std::size_t row) {
    for (std::size_t column = 0; column <= row; ++column) {
      double sum = gram_[chosen[row]][chosen[column]] + (row == column ? mu_ : 0.0);
      for (std::size_t k = 0; k < column; ++k) sum -= factor_[row][k] * factor_[column][k];
      if (row != column) {
        factor_[row][column] = sum / factor_[column][column];
      } else {
        if (!(sum > 0.0)) return false;
        factor_[row][row] = std::sqrt(sum);
      }
    }
    return true;
  }

  /// Least w^T (G + mu I) w - 2 mu near^T w with sum 1. False where a weight is below 0.
  bool solve(std::span<const std::size_t> chosen, std::array<double, kMost>& weights) const {
    std::array<double, kMost> pull{};
    std::array<double, kMost> ones{};
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      pull[i] = mu_ * near_[chosen[i]];
      ones[i] = 1.0;
    }
    substitute(chosen.size(), pull);
    substitute(chosen.size(), ones);
    double pulled = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      pulled += pull[i];
      all += ones[i];
    }
    const double lambda = (1.0 - pulled) / all;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      weights[i] = pull[i] + lambda * ones[i];
      if (!(weights[i] >= 0.0)) return false;
    }
    return true;
  }

 private:
  void substitute(std::size_t size, std::array<double, kMost>& x) const {
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t k = 0; k < i; ++k) x[i] -= factor_[i][k] * x[k];
      x[i] /= factor_[i][i];
    }
    for (std::size_t i = size; i-- > 0;) {
      for (std::size_t k = i + 1; k < size; ++k) x[i] -= factor_[k][i] * x[k];
      x[i] /= factor_[i][i];
    }
  }

  const Gram& gram_;
  double mu_;
  const CandidateWeights& near_;
  std::array<std::array<double, kMost>, kMost> factor_{};
};

class Search {
 public:
  Search(const Gram& gram, std::size_t count, double mu, const CandidateWeights& near)
      : gram_(gram), count_(count), mu_(mu), near_(near), choice_(gram, mu, near) {}

  CandidateWeights run() {
    extend(0, 0);
    return best_;
  }

 private:
  /// All choices that begin with the `size` candidates chosen so far, from `first` on. Factors grow row by row.
  void extend(std::size_t size, std::size_t first) {
    for (std::size_t next = first; next < count_; ++next) {
      chosen_[size] = next;
      if (!choice_.factorRow(chosen_, size)) continue;
      consider(size + 1);
      if (size + 1 < kMost) extend(size + 1, next + 1);
    }
  }

  void consider(std::size_t size) {
    const std::span chosen = std::span(chosen_).first(size);
    std::array<double, kMost> weights{};
    if (!choice_.solve(chosen, weights)) return;
    const double cost = costOf(chosen, weights);
    if (!(cost < least_)) return;
    least_ = cost;
    best_ = {};
    for (std::size_t i = 0; i < size; ++i) best_[chosen[i]] = weights[i];
  }

  [[nodiscard]] double costOf(std::span<const std::size_t> chosen, const std::array<double, kMost>& weights) const {
    double cost = 0.0;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      double row = mu_ * (weights[i] - 2.0 * near_[chosen[i]]);
      for (std::size_t k = 0; k < chosen.size(); ++k) row += gram_[chosen[i]][chosen[k]] * weights[k];
      cost += weights[i] * row;
    }
    return cost;
  }

  const Gram& gram_;
  std::size_t count_;
  double mu_;
  const CandidateWeights& near_;
  Choice choice_;
  std::array<std::size_t, kMost> chosen_{};
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
  return Search(gram, count, mu, near).run();
}

}  // namespace sinew::exporting
