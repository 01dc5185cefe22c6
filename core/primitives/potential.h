// core/primitives/potential.h: the quartic potential and the constants that follow from the iso value.
#pragma once

#include <cmath>

namespace sinew {

/// g(r) = (1 - r^2)^2 for r < 1, else 0 (paper 3.1), from r squared. C1; support radius 1; g(0) = 1.
[[nodiscard]] inline float potential(float rSquared) {
  const float w = 1.0f - rSquared;
  return w > 0.0f ? w * w : 0.0f;
}

/// d g / d (r^2) = -2 (1 - r^2) for r < 1, else 0.
[[nodiscard]] inline float potentialSlope(float rSquared) {
  const float w = 1.0f - rSquared;
  return w > 0.0f ? -2.0f * w : 0.0f;
}

/// r_T: where g equals the iso value, sqrt(1 - sqrt T). 0 < iso < 1.
[[nodiscard]] inline float isoRadius(float iso) { return std::sqrt(1.0f - std::sqrt(iso)); }

/// s: factor that puts the iso surface of a lone primitive on its visible ellipsoid, T / g(1 / reach). reach > 1.
/// docs/field.md.
[[nodiscard]] inline float strengthFor(float iso, float reach) { return iso / potential(1.0f / (reach * reach)); }

}  // namespace sinew
