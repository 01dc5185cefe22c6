// core/smoothing/projection/overhang.h: heights where psi falls slowly, as below what hangs over the skin.
// docs/design.md, Overhangs.
#pragma once

#include <algorithm>

namespace sinew {

/// The root t of psi moves as fast as psi changes, over its slope: without limit where a dip of psi comes to 0, and it
/// leaps from there. The height is therefore the least of s + psi(s) / sigma on the way, 0 <= s <= t: no change of psi
/// moves it by more than 1 / sigma times as much. It is t wherever psi falls by sigma or more all the way.
///
/// The least is looked for at the ends of parts of the way that do not depend on the root, and inside a part by steps
/// of false position on the slope.
struct Overhang {
  /// sigma over the slope that the skin's own field would have on the skin, were the muscles' mean radius its width.
  static constexpr float kSlope = 0.5f;
  static constexpr float kPart = 0.25f;  ///< Fraction of the blend width h.
  static constexpr int kMostParts = 32;
  static constexpr int kNarrowings = 3;
};

/// @param t  the root, > 0.  @param sigma  > 0.  @param part  length.  @param psi  (s) -> a value and a slope.
template <class Real, class Psi>
[[nodiscard]] Real heightBelowOverhangs(Real t, Real sigma, Real part, const Psi& psi) {
  auto from = psi(Real(0));
  Real height = std::min(t, from.value / sigma);
  for (int i = 0; i < Overhang::kMostParts && Real(i) * part < t; ++i) {
    Real low = Real(i) * part;
    Real high = std::min(Real(i + 1) * part, t);
    const auto to = psi(high);
    if (high < t) height = std::min(height, high + to.value / sigma);
    Real falls = from.slope + sigma;  // The slope of sigma s + psi(s).
    Real rises = to.slope + sigma;
    for (int k = 0; k < Overhang::kNarrowings && falls < Real(0) && rises > Real(0); ++k) {
      const Real lowest = low - falls * (high - low) / (rises - falls);
      const auto at = psi(lowest);
      height = std::min(height, lowest + at.value / sigma);
      const bool fallsOn = at.slope + sigma < Real(0);
      (fallsOn ? low : high) = lowest;
      (fallsOn ? falls : rises) = at.slope + sigma;
    }
    from = to;
  }
  return std::max(height, Real(0));
}

}  // namespace sinew
