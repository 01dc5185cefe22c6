// core/surface/roots/quartic_lanes.h: psi as a quartic, and its first root in closed form, a lane each. Included once
// per instruction set.
#if defined(SINEW_QUARTIC_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SINEW_QUARTIC_LANES_H
#undef SINEW_QUARTIC_LANES_H
#else
#define SINEW_QUARTIC_LANES_H
#endif

#include <array>
#include <cstdint>

#include "core/surface/roots/ray_lanes.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace sinew::HWY_NAMESPACE {

/// Cube root of x >= 1e-30 to a few parts in a million: a third of the bits, then two of Newton's steps.
HWY_INLINE V cubeRoot(V x) {
  const hn::RebindToSigned<FloatTag> bits;
  const V third = hn::ConvertTo(kTag, hn::BitCast(bits, x)) * all(1.0f / 3.0f) + all(709921077.0f);
  V root = hn::BitCast(kTag, hn::ConvertTo(bits, third));
  for (int step = 0; step < 2; ++step) root = all(1.0f / 3.0f) * (root + root + x / (root * root));
  return root;
}

/// Largest real root of z^3 + 2 p z^2 + (p^2 - 4 r) z - q^2: the resolvent of y^4 + p y^2 + q y + r (Ferrari).
HWY_INLINE V largestResolventRoot(V p, V q, V r) {
  const V cubicQ = all(1.0f / 9.0f) * (p * p + all(12.0f) * r);
  const V cubicR = all(1.0f / 54.0f) * (p * (all(72.0f) * r - all(2.0f) * p * p) - all(27.0f) * q * q);
  const V cubed = cubicQ * cubicQ * cubicQ;
  const V discriminant = cubicR * cubicR - cubed;
  // Three real roots: cos(acos(x) / 3), a polynomial (to 2e-6) of y = cos(acos(x) / 2).
  const V rootQ = hn::Sqrt(hn::Max(zero(), cubicQ));
  const V x = zero() - cubicR / (rootQ * hn::Max(zero(), cubicQ));
  const V y = hn::Sqrt(hn::Max(zero(), all(0.5f) + all(0.5f) * hn::Min(x, all(1.0f))));
  V cosine = all(0.0041208f);
  for (const float coefficient : {-0.01912183f, 0.0476345f, -0.10988446f, 0.5772504f, 0.50000137f}) {
    cosine = all(coefficient) + y * cosine;
  }
  const V ofThree = all(2.0f) * rootQ * cosine;
  // One: Cardano.
  const V size = cubeRoot(hn::Max(all(1e-30f), hn::Abs(cubicR) + hn::Sqrt(hn::Max(zero(), discriminant))));
  const V s = zero() - hn::CopySign(size, cubicR);
  return select(hn::Lt(discriminant, zero()), ofThree, s + cubicQ / s) - all(2.0f / 3.0f) * p;
}

/// Largest real root of y^4 - y^3 + c y^2 + d y + e; of none: not a number, or any.
HWY_INLINE V largestQuarticRoot(V c, V d, V e) {
  // y = Y + 1/4: Y^4 + p Y^2 + q Y + r.
  const V p = c - all(0.375f);
  const V q = d + all(0.5f) * c - all(0.125f);
  const V r = e + all(0.25f) * d + all(0.0625f) * c - all(3.0f / 256.0f);
  const V z = largestResolventRoot(p, q, r);
  const V half = all(0.5f) * hn::Sqrt(z);
  // (Y^2 + sqrt(z) Y + (p + z - q / sqrt(z)) / 2) (Y^2 - sqrt(z) Y + (p + z + q / sqrt(z)) / 2)
  const V middle = zero() - all(0.5f) * p - all(0.25f) * z;
  const V apart = q / (all(4.0f) * half);
  const V left = middle + apart;
  const V right = middle - apart;
  const V ofLeft = hn::Sqrt(left) - half;
  const V ofRight = hn::Sqrt(right) + half;
  const V ofBoth = hn::Max(ofLeft, ofRight);
  return select(hn::Lt(left, zero()), ofRight, select(hn::Lt(right, zero()), ofLeft, ofBoth)) + all(0.25f);
}

/// psi of ellipsoids between places where terms begin and end: quartics, one a clique.
class RayQuartics {
 public:
  explicit RayQuartics(const RayLanes& rays) : rays_(rays) {}

  /// Cuts brackets where terms begin or end in them, those nearest to the middle first.
  void narrow(LaneSearch& search) const {
    constexpr int kMaxCuts = 8;
    M open = search.bracketed;
    for (int i = 0; i < kMaxCuts; ++i) {
      const Breakpoint cut = nearestBreakpoint(search);
      open = both(open, cut.found);
      if (!any(open)) return;
      const M above = hn::Gt(rays_.sample(cut.t).value, zero());
      rays_.count(open);
      search.low = select(both(open, above), cut.t, search.low);
      search.high = select(andNot(open, above), cut.t, search.high);
    }
  }

  /// In each bracket; where there is no closed form, its beginning.
  V firstRoot(const LaneSearch& search) const {
    const Coefficients c = about(search.low, all(0.5f) * (search.low + search.high));
    rays_.countQuartics(both(search.bracketed, hn::Not(c.hasShape)));
    // In units of the way to where the tangent at the beginning falls to 0, and in 1 / u, of which the first root is
    // the largest: close to 1 if psi is close to a line.
    const V tangent = zero() - c.of[0] / c.of[1];
    const V scale = tangent / c.of[0];
    const V c2 = c.of[2] * tangent * scale;
    const V c3 = c.of[3] * tangent * tangent * scale;
    const V c4 = c.of[4] * tangent * tangent * tangent * scale;
    const V t = search.low + tangent / largestQuarticRoot(c2, c3, c4);
    const M inside = both(hn::Gt(t, search.low), hn::Lt(t, search.high));
    return select(andNot(inside, c.hasShape), t, search.low);
  }

 private:
  struct Breakpoint {
    V t;
    M found;
  };

  Breakpoint nearestBreakpoint(const LaneSearch& search) const {
    const V middle = all(0.5f) * (search.low + search.high);
    Breakpoint nearest{middle, none()};
    V distance = search.high - search.low;
    const auto consider = [&](V t, M exists) HWY_ATTR {
      const V apart = hn::Abs(t - middle);
      const M inside = both(hn::Gt(t, search.low), hn::Lt(t, search.high));
      const M closer = both(both(exists, inside), hn::Lt(apart, distance));
      nearest.t = select(closer, t, nearest.t);
      nearest.found = hn::Or(nearest.found, closer);
      distance = select(closer, apart, distance);
    };
    for (const LaneTerm& term : rays_.terms()) {
      const M exists = both(hn::Ne(rays_.load(term.factor), zero()), hn::Gt(rays_.load(term.peak), zero()));
      const Range extent = rays_.extentOf(term);
      consider(extent.low, exists);
      consider(extent.high, exists);
    }
    // Outwards the skin's own field ends.
    const LaneSkin& skin = rays_.skin();
    if (skin.falls) consider((all(1.0f) - skin.isoRadius) / skin.inverseWidth, hn::Gt(skin.sign, zero()));
    return nearest;
  }

  struct Coefficients {
    std::array<V, 5> of;
    M hasShape;
  };

  /// Coefficients in powers of t - low, summed over the terms that are above 0 at `inside`.
  Coefficients about(V low, V inside) const {
    Coefficients sum{ofSkin(low, inside), none()};
    rays_.clearSums();
    for (const LaneTerm& term : rays_.terms()) {
      const V factor = rays_.load(term.factor);
      const V a = rays_.load(term.a);
      const V middle = rays_.load(term.middle);
      const V peak = rays_.load(term.peak);
      const V d = low - middle;
      const V e = inside - middle;
      const V counted = select(hn::Gt(peak - a * e * e, zero()), factor, zero());
      // w = w0 + w1 u - a u^2
      const V w0 = peak - a * d * d;
      const V w1 = all(-2.0f) * a * d;
      const std::array<V, 5> squared{counted * w0 * w0, counted * (w0 + w0) * w1, counted * (w1 * w1 - (w0 + w0) * a),
                                     counted * all(-2.0f) * w1 * a, counted * a * a};
      for (std::size_t k = 0; k < squared.size(); ++k) {
        if (rays_.isEverywhere(term.slot)) sum.of[k] = sum.of[k] + squared[k];
        else rays_.add(term.slot, k, squared[k]);
      }
    }
    for (const LaneShape& shape : rays_.shapes()) {
      const ShapeOnRays ray = rays_.onRays(shape);
      const Range box = ray.box();
      const M there = both(hn::Lt(box.low, inside + (inside - low)), hn::Gt(box.high, low));
      sum.hasShape = hn::Or(sum.hasShape, both(hn::Ne(ray.factor(), zero()), there));
    }
    addWinner(sum);
    return sum;
  }

  std::array<V, 5> ofSkin(V low, V inside) const {
    const LaneSkin& skin = rays_.skin();
    if (!skin.falls) return {skin.offset, zero(), zero(), zero(), zero()};
    // w = 1 - (r + k u)^2
    const M there = hn::Lt(skin.fall(inside), skin.maxFall);
    const V k = select(there, skin.sign * skin.inverseWidth, zero());
    const V r = skin.radius(low);
    const V w = skin.root(low);
    const V kk = k * k;
    return {skin.value(low), skin.sign * all(-4.0f) * k * (r * w), skin.sign * kk * (all(4.0f) * r * r - (w + w)),
            skin.sign * all(4.0f) * r * kk * k, skin.sign * kk * kk};
  }

  /// Coefficients of the clique that is the maximum at `low`.
  void addWinner(Coefficients& sum) const {
    const V sign = rays_.skin().sign;
    std::array<V, 5> best{zero(), zero(), zero(), zero(), zero()};
    for (std::size_t clique = 0; clique < rays_.cliques().count(); ++clique) {
      const M wins = hn::Gt(sign * rays_.sumOf(clique, 0), sign * best[0]);
      for (std::size_t k = 0; k < best.size(); ++k) best[k] = select(wins, rays_.sumOf(clique, k), best[k]);
    }
    for (std::size_t k = 0; k < best.size(); ++k) sum.of[k] = sum.of[k] + best[k];
  }

  const RayLanes& rays_;
};

}  // namespace sinew::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
