// core/geometry/potential.h: the potential g of r squared, and the constants that follow from the iso value.
#pragma once

#include "core/geometry/formulas.h"

namespace sinew {

using scalar_operations::smoothstep;

/// g (core/geometry/formulas/potential.h). C1; support radius 1; g(0) = 1.
[[nodiscard]] inline float potential(float rSquared) {
  return in_float::potential(1.0f, std::max(0.0f, 1.0f - rSquared));
}

/// d g / d (r^2)
[[nodiscard]] inline float potentialSlope(float rSquared) {
  return -2.0f * in_float::potentialRate(std::max(0.0f, 1.0f - rSquared));
}

/// 1 - r^2 where g equals the iso value. 0 < iso < 1.
[[nodiscard]] inline float isoRoot(float iso) { return in_float::potentialInverse(iso); }

/// r_T: where g equals the iso value.
[[nodiscard]] inline double isoRadius(double iso) { return std::sqrt(1.0 - in_double::potentialInverse(iso)); }

/// s = T / g(1 / reach): a single primitive's iso surface is then its visible ellipsoid. reach > 1. docs/design.md.
[[nodiscard]] inline float strengthFor(float iso, float reach) { return iso / potential(1.0f / (reach * reach)); }

}  // namespace sinew
