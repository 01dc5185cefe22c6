// core/bodies/fit_equations.h: normal equations of a fit: blocks of the pairs of muscles that overlap.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/bodies/height_model.h"

namespace sinew {

/// The derivative of one residual by the numbers of one unknown muscle.
struct UnknownChange {
  int unknown = 0;
  FitVector by{};
};
using ResidualRow = std::vector<UnknownChange>;  ///< Each unknown at most once, ascending.

/// a + factor * b
[[nodiscard]] ResidualRow sumOfRows(const ResidualRow& a, float factor, const ResidualRow& b);

/// J^T J and J^T r, added up residual by residual. Sparse by blocks.
class FitEquations {
 public:
  explicit FitEquations(std::size_t unknowns);

  /// Adds weight^2 times the row's products.
  void add(const ResidualRow& row, double weight, double residual);
  void add(const FitEquations& other);  ///< Of as many unknowns.
  /// Adds to one number alone: as a row with only this number.
  void addToNumber(std::size_t number, double square, double product) {
    diagonal(number) += square;
    right_[number] += product;
  }
  [[nodiscard]] std::size_t size() const { return right_.size(); }
  [[nodiscard]] double diagonalAt(std::size_t number) const;

  /// The solution with the diagonal made larger by `added`, by conjugate gradients with the blocks of the diagonal as
  /// preconditioner.  @param added [size()] above 0
  [[nodiscard]] std::vector<double> solved(std::span<const double> added) const;

 private:
  using Block = std::array<double, kFitNumbers * kFitNumbers>;  ///< Row by row.
  [[nodiscard]] double& diagonal(std::size_t number);
  [[nodiscard]] Block& blockOf(std::size_t low, std::size_t high);  ///< low <= high
  void multiply(std::span<const double> x, std::span<const double> added, std::vector<double>& out) const;

  struct Placed {
    int low = 0;
    int high = 0;
    Block values{};
  };
  std::size_t unknowns_ = 0;
  std::vector<int> places_;  ///< [unknowns * unknowns] index into blocks_, -1: zeros.
  std::vector<Placed> blocks_;
  std::vector<double> right_;  ///< [unknowns * kFitNumbers]
};

}  // namespace sinew
