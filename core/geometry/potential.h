// core/geometry/potential.h: the quartic potential and the constants that follow from the iso value. Other code that
// relies on its formula: CONTRIBUTING.md, Another potential g.
#pragma once

#include <algorithm>
#include <cmath>

namespace sinew {

/// 0 up to `from`, 1 from `to` on, between them 3 t^2 - 2 t^3. from < to.
[[nodiscard]] inline float smoothstep(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

/// g(r) = (1 - r^2)^2 for r < 1, else 0 (paper 3.1), from r squared. C1; support radius 1; g(0) = 1.
template <class Real>
[[nodiscard]] Real potential(Real rSquared) {
  const Real w = Real(1) - rSquared;
  return w > Real(0) ? w * w : Real(0);
}

/// d g / d (r^2) = -2 (1 - r^2) for r < 1, else 0.
template <class Real>
[[nodiscard]] Real potentialSlope(Real rSquared) {
  const Real w = Real(1) - rSquared;
  return w > Real(0) ? Real(-2) * w : Real(0);
}

/// 1 - r^2 where g equals the iso value, sqrt T. 0 < iso < 1.
template <class Real>
[[nodiscard]] Real isoRoot(Real iso) {
  return std::sqrt(iso);
}

/// r_T: where g equals the iso value, sqrt(1 - sqrt T).
template <class Real>
[[nodiscard]] Real isoRadius(Real iso) {
  return std::sqrt(Real(1) - isoRoot(iso));
}

/// s = T / g(1 / reach): a single primitive's iso surface is then its visible ellipsoid. reach > 1. docs/design.md.
[[nodiscard]] inline float strengthFor(float iso, float reach) { return iso / potential(1.0f / (reach * reach)); }

}  // namespace sinew
