// tests/bodies/fit_equations_test.cpp: solutions put back into the residuals they came from.
#include "core/bodies/fit_equations.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/rigs/random_rigs.h"

namespace sinew {
namespace {

using test::Random;

TEST(FitEquations, TheGradientIsZeroAtTheSolution) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    constexpr int kUnknowns = 7;
    struct Residual {
      ResidualRow row;
      double weight = 0.0;
      double value = 0.0;
    };
    std::vector<Residual> residuals;
    for (int i = 0; i < 300; ++i) {
      Residual one;
      one.weight = static_cast<double>(random.uniform(0.1f, 2.0f));
      one.value = static_cast<double>(random.uniform(-1.0f, 1.0f));
      for (int u = 0; u < kUnknowns; ++u) {
        if (!random.chance(0.4f)) continue;
        UnknownChange change{u, {}};
        // Of very different sizes, as numbers of muscles are.
        for (std::size_t k = 0; k < kFitNumbers; ++k)
          change.by[k] = random.uniform(-1.0f, 1.0f) * (k < 3 ? 30.0f : 1.0f);
        one.row.push_back(change);
      }
      residuals.push_back(one);
    }
    FitEquations first(kUnknowns);
    FitEquations second(kUnknowns);
    for (std::size_t i = 0; i < residuals.size(); ++i) {
      (i % 2 == 0 ? first : second).add(residuals[i].row, residuals[i].weight, residuals[i].value);
    }
    first.add(second);
    first.addToNumber(13, 4.0, -2.0);
    const std::vector<double> added(first.size(), 0.01);
    const std::vector<double> x = first.solved(added);
    std::vector<double> gradient(first.size(), 0.0);
    std::vector<double> sizes(first.size(), 0.0);
    for (const Residual& one : residuals) {
      double made = -one.value;
      for (const UnknownChange& change : one.row) {
        for (std::size_t k = 0; k < kFitNumbers; ++k) {
          made += static_cast<double>(change.by[k]) * x[static_cast<std::size_t>(change.unknown) * kFitNumbers + k];
        }
      }
      for (const UnknownChange& change : one.row) {
        for (std::size_t k = 0; k < kFitNumbers; ++k) {
          const std::size_t number = static_cast<std::size_t>(change.unknown) * kFitNumbers + k;
          const double part = one.weight * one.weight * made * static_cast<double>(change.by[k]);
          gradient[number] += part;
          sizes[number] += std::abs(part);
        }
      }
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double whole = gradient[i] + added[i] * x[i] + (i == 13 ? 4.0 * x[i] + 2.0 : 0.0);
      EXPECT_NEAR(whole, 0.0, 1e-6 * (sizes[i] + 1.0)) << seed << ' ' << i;
    }
  }
}

TEST(FitEquations, SumsOfRowsKeepTheirOrder) {
  ResidualRow a{{1, {}}, {4, {}}};
  ResidualRow b{{0, {}}, {4, {}}, {6, {}}};
  for (UnknownChange& change : a) change.by.fill(1.0f);
  for (UnknownChange& change : b) change.by.fill(2.0f);
  const ResidualRow sum = sumOfRows(a, -3.0f, b);
  ASSERT_EQ(sum.size(), 4U);
  const std::array<std::pair<int, float>, 4> expected{{{0, -6.0f}, {1, 1.0f}, {4, -5.0f}, {6, -6.0f}}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(sum[i].unknown, expected[i].first);
    EXPECT_EQ(sum[i].by[9], expected[i].second);
  }
}

}  // namespace
}  // namespace sinew
