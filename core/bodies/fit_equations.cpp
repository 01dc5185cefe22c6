// core/bodies/fit_equations.cpp: sums of products by blocks, and preconditioned conjugate gradients.
#include "core/bodies/fit_equations.h"

#include <cassert>
#include <cmath>

#include "core/geometry/at.h"

namespace sinew {
namespace {

constexpr std::size_t kN = kFitNumbers;
constexpr int kMostSolverSteps = 2000;
constexpr double kSolvedTo = 1e-9;  ///< Relative to the right side, by the preconditioner's norm.

using FitBlock = std::array<double, kN * kN>;

/// The lower Cholesky factor, in place. The block is positive definite.
void factor(FitBlock& a) {
  for (std::size_t j = 0; j < kN; ++j) {
    for (std::size_t i = j; i < kN; ++i) {
      double sum = a[i * kN + j];
      for (std::size_t k = 0; k < j; ++k) sum -= a[i * kN + k] * a[j * kN + k];
      a[i * kN + j] = i == j ? std::sqrt(std::max(sum, 1e-300)) : sum / a[j * kN + j];
    }
  }
}

void solveFactored(const FitBlock& l, const double* b, double* x) {
  for (std::size_t i = 0; i < kN; ++i) {
    double sum = b[i];
    for (std::size_t k = 0; k < i; ++k) sum -= l[i * kN + k] * x[k];
    x[i] = sum / l[i * kN + i];
  }
  for (std::size_t i = kN; i-- > 0;) {
    double sum = x[i];
    for (std::size_t k = i + 1; k < kN; ++k) sum -= l[k * kN + i] * x[k];
    x[i] = sum / l[i * kN + i];
  }
}

double product(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

ResidualRow sumOfRows(const ResidualRow& a, float factor, const ResidualRow& b) {
  ResidualRow out;
  out.reserve(a.size() + b.size());
  auto second = b.begin();
  const auto addScaled = [&](FitVector& to, const FitVector& from) {
    for (std::size_t i = 0; i < kN; ++i) to[i] += factor * from[i];
  };
  for (const UnknownChange& change : a) {
    for (; second != b.end() && second->unknown < change.unknown; ++second) {
      addScaled(out.emplace_back(UnknownChange{second->unknown, {}}).by, second->by);
    }
    out.push_back(change);
    if (second == b.end() || second->unknown != change.unknown) continue;
    addScaled(out.back().by, second->by);
    ++second;
  }
  for (; second != b.end(); ++second) addScaled(out.emplace_back(UnknownChange{second->unknown, {}}).by, second->by);
  return out;
}

FitEquations::FitEquations(std::size_t unknowns)
    : unknowns_(unknowns), places_(unknowns * unknowns, -1), right_(unknowns * kN, 0.0) {
  for (std::size_t i = 0; i < unknowns; ++i) (void)blockOf(i, i);
}

FitEquations::Block& FitEquations::blockOf(std::size_t low, std::size_t high) {
  int& place = places_[low * unknowns_ + high];
  if (place < 0) {
    place = static_cast<int>(blocks_.size());
    blocks_.push_back({static_cast<int>(low), static_cast<int>(high), {}});
  }
  return at(blocks_, place).values;
}

double& FitEquations::diagonal(std::size_t number) {
  return blockOf(number / kN, number / kN)[(number % kN) * (kN + 1)];
}

double FitEquations::diagonalAt(std::size_t number) const {
  const std::size_t unknown = number / kN;
  return at(blocks_, places_[unknown * unknowns_ + unknown]).values[(number % kN) * (kN + 1)];
}

void FitEquations::add(const ResidualRow& row, double weight, double residual) {
  const double square = weight * weight;
  for (std::size_t a = 0; a < row.size(); ++a) {
    const auto low = toIndex(row[a].unknown);
    std::array<double, kN> scaled{};
    for (std::size_t i = 0; i < kN; ++i) {
      scaled[i] = square * static_cast<double>(row[a].by[i]);
      right_[low * kN + i] += scaled[i] * residual;
    }
    for (std::size_t b = a; b < row.size(); ++b) {
      Block& block = blockOf(low, toIndex(row[b].unknown));
      for (std::size_t i = 0; i < kN; ++i) {
        for (std::size_t j = 0; j < kN; ++j) block[i * kN + j] += scaled[i] * static_cast<double>(row[b].by[j]);
      }
    }
  }
}

void FitEquations::add(const FitEquations& other) {
  assert(other.unknowns_ == unknowns_);
  for (const Placed& theirs : other.blocks_) {
    Block& block = blockOf(toIndex(theirs.low), toIndex(theirs.high));
    for (std::size_t i = 0; i < block.size(); ++i) block[i] += theirs.values[i];
  }
  for (std::size_t i = 0; i < right_.size(); ++i) right_[i] += other.right_[i];
}

void FitEquations::multiply(std::span<const double> x, std::span<const double> added, std::vector<double>& out) const {
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = added[i] * x[i];
  for (const Placed& block : blocks_) {
    const std::size_t low = toIndex(block.low) * kN;
    const std::size_t high = toIndex(block.high) * kN;
    for (std::size_t i = 0; i < kN; ++i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < kN; ++j) {
        sum += block.values[i * kN + j] * x[high + j];
        if (low != high) out[high + j] += block.values[i * kN + j] * x[low + i];
      }
      out[low + i] += sum;
    }
  }
}

std::vector<double> FitEquations::solved(std::span<const double> added) const {
  std::vector<FitBlock> factors;
  for (std::size_t u = 0; u < unknowns_; ++u) {
    FitBlock block = at(blocks_, places_[u * unknowns_ + u]).values;
    for (std::size_t i = 0; i < kN; ++i) block[i * (kN + 1)] += added[u * kN + i];
    factor(block);
    factors.push_back(block);
  }
  std::vector<double> x(size(), 0.0);
  std::vector<double> rest = right_;
  std::vector<double> guided(size());
  std::vector<double> image(size());
  const auto guide = [&] {
    for (std::size_t u = 0; u < unknowns_; ++u) solveFactored(factors[u], &rest[u * kN], &guided[u * kN]);
  };
  guide();
  std::vector<double> direction = guided;
  double square = product(rest, guided);
  const double enough = kSolvedTo * kSolvedTo * square;
  for (int step = 0; step < kMostSolverSteps && square > enough; ++step) {
    multiply(direction, added, image);
    const double length = square / product(direction, image);
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] += length * direction[i];
      rest[i] -= length * image[i];
    }
    guide();
    const double next = product(rest, guided);
    const double kept = next / square;
    for (std::size_t i = 0; i < x.size(); ++i) direction[i] = guided[i] + kept * direction[i];
    square = next;
  }
  return x;
}

}  // namespace sinew
