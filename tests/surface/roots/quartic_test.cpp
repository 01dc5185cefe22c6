// tests/surface/roots/quartic_test.cpp: first roots of random quartics match dense sampling.

#include "core/surface/roots/polynomial.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace sinew {
namespace {

/// First change to <= 0 by 20,000 samples and bisection; `clear` is false for near-tangencies.
struct Reference {
  std::optional<double> root;
  bool clear = true;
};

Reference firstFallByMarching(const Quartic& q, double from) {
  Reference reference;
  constexpr int kSteps = 20000;
  double last = from;
  for (int i = 1; i <= kSteps; ++i) {
    const double u = from + (1.0 - from) * i / kSteps;
    if (q.at(u) <= 0.0) {
      double low = last;
      double high = u;
      for (int k = 0; k < 60; ++k) (q.at(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
      reference.root = high;
      return reference;
    }
    if (q.at(u) < 1e-5) reference.clear = false;
    last = u;
  }
  return reference;
}

TEST(Quartic, BothMethodsFindTheFirstFallingRoot) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int withRoot = 0;
  for (int round = 0; round < 3000; ++round) {
    Quartic q;
    for (double& b : q.b) b = unit(random);
    if (round % 3 == 0) q = {{q.b[0], q.b[1], q.b[2], q.b[1], q.b[0]}};  // symmetric: biquadratic about 1/2
    q.b[0] = std::abs(q.b[0]) + 0.01;
    const double from = round % 2 == 0 ? 0.0 : 0.3;
    if (q.at(from) <= 0.0) continue;
    const Reference reference = firstFallByMarching(q, from);
    if (!reference.clear) continue;
    for (const auto& found : {firstFallIsolated(q, from, 1e-12), firstFallClosedForm(q, from, 1e-12)}) {
      ASSERT_EQ(found.has_value(), reference.root.has_value()) << "round " << round;
      if (found) {
        EXPECT_NEAR(*found, *reference.root, 1e-8) << "round " << round;
      }
    }
    withRoot += reference.root.has_value();
  }
  EXPECT_GT(withRoot, 1000);
}

TEST(Quartic, SquareOfAQuadraticIsExact) {
  const Quartic q = squareOfQuadratic(0.3, -0.7, 1.1);
  for (double u = 0.0; u <= 1.0; u += 0.1) {
    const double w = (1 - u) * (1 - u) * 0.3 + 2 * u * (1 - u) * -0.7 + u * u * 1.1;
    EXPECT_NEAR(q.at(u), w * w, 1e-14);
  }
}

TEST(Quartic, FindsRealRootsOfKnownFactors) {
  std::mt19937 random(29);
  std::uniform_real_distribution<double> unit(-2.0, 2.0);
  for (int round = 0; round < 2000; ++round) {
    std::array<double, 4> r{unit(random), unit(random), unit(random), unit(random)};
    std::ranges::sort(r);
    if (r[1] - r[0] < 0.05 || r[2] - r[1] < 0.05 || r[3] - r[2] < 0.05) continue;
    std::array<double, 5> c{1, 0, 0, 0, 0};
    for (const double root : r) {
      for (std::size_t i = 4; i > 0; --i) c[i] = c[i - 1] - root * c[i];
      c[0] *= -root;
    }
    const RealRoots roots = realRoots(c);
    const std::span<const double> found = roots.all();
    ASSERT_EQ(found.size(), 4u) << "round " << round;
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found[i], r[i], 1e-6);
  }
}

}  // namespace
}  // namespace sinew
