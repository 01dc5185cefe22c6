// tests/rig/via_shift_test.cpp: shift of a belly's middle by a via point anywhere along it.
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/rig/line_rest.h"

namespace sinew::test {
namespace {

const glm::dvec3 kOrigin(3.0, -1.0, 2.0);
const glm::dvec3 kAlong = glm::normalize(glm::dvec3(1.0, 2.0, -2.0));
const glm::dvec3 kBeside = glm::normalize(glm::cross(kAlong, glm::dvec3(0.3, 0.1, 1.0)));
constexpr double kTendon = 2.0;
constexpr double kBellyLength = 10.0;

/// Shift by a via point at y; the belly's ends are -1 and 1.
glm::dvec3 shiftAt(double y, double beside) {
  const glm::dvec3 via = kOrigin + (kTendon + 0.5 * kBellyLength * (1.0 + y)) * kAlong + beside * kBeside;
  return viaShift(kOrigin, kAlong, via, kTendon, kBellyLength);
}

/// Factor applied to `beside`.
double factorAt(double y) { return glm::dot(shiftAt(y, 1.0), kBeside); }

TEST(ViaShift, PutsAParabolaThroughAViaPointOverTheBelly) {
  for (double y = -0.59; y <= 0.59; y += 0.01) {
    // A parabola from end to end with height `shift` in the middle.
    const double atVia = factorAt(y) * (1.0 - y * y);
    EXPECT_NEAR(atVia, 1.0, 1e-14) << y;
  }
}

TEST(ViaShift, FadesSmoothlyTowardsTheBellysEnds) {
  constexpr double kStep = 1e-3;
  double most = 0.0;
  for (double y = -2.0; y < 2.0; y += kStep) {
    const double factor = factorAt(y);
    most = std::max(most, factor);
    EXPECT_GT(factor, 1.0 - 1e-12) << y;
    EXPECT_NEAR(factorAt(-y), factor, 1e-12) << y;
    EXPECT_LT(std::abs(factorAt(y + kStep) - factor), 7.0 * kStep) << y;
    const double bend = factorAt(y + kStep) - 2.0 * factor + factorAt(y - kStep);
    EXPECT_LT(std::abs(bend), 170.0 * kStep * kStep) << y;
    if (std::abs(y) >= 1.0) {
      EXPECT_NEAR(factor, 1.0, 1e-12) << y;
    }
  }
  EXPECT_GT(most, 1.9);
  EXPECT_LT(most, 1.94);
}

TEST(ViaShift, IsPerpendicularToTheLineAndAtMostHalfTheBelly) {
  for (const double y : {-1.5, -0.7, 0.0, 0.3, 0.9}) {
    for (const double beside : {-3.0, 0.5, 4.9, 50.0}) {
      const glm::dvec3 shift = shiftAt(y, beside);
      EXPECT_NEAR(glm::dot(shift, kAlong), 0.0, 1e-12);
      EXPECT_LT(glm::length(shift), 0.5 * kBellyLength + 1e-12);
      EXPECT_GT(glm::dot(shift, kBeside) * beside, 0.0);
    }
    EXPECT_NEAR(glm::length(shiftAt(y, 50.0)), 0.5 * kBellyLength, 1e-12);
    EXPECT_LT(glm::length(shiftAt(y, 0.0)), 1e-12);
  }
}

}  // namespace
}  // namespace sinew::test
