// core/surface/roots/soft_fall.cpp: bounds of coefficients, halvings, and steps in a bracket.
#include "core/surface/roots/soft_fall.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/at.h"
#include "core/geometry/formulas.h"
#include "core/surface/roots/isolation.h"

namespace sinew {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void add(Extent& sum, const Extent& part, double weight = 1.0) {
  sum.low += weight * part.low;
  sum.high += weight * part.high;
}

/// A polynomial lies between its least and its largest coefficient.
Extent valuesOf(const Bernstein& q) {
  const auto [low, high] = std::ranges::minmax(q.coefficients());
  return {low, high};
}

Extent slopesOf(const Bernstein& q) {
  const std::span<const double> b = q.coefficients();
  if (b.size() < 2) return {};
  Extent out{kInfinity, -kInfinity};
  for (std::size_t i = 0; i + 1 < b.size(); ++i) {
    const double slope = static_cast<double>(q.degree) * (b[i + 1] - b[i]);
    out = {std::min(out.low, slope), std::max(out.high, slope)};
  }
  return out;
}

/// Bounds of factor * of, with a factor >= 0.
Extent scaled(const Extent& factor, const Extent& of) {
  return {(of.low < 0.0 ? factor.high : factor.low) * of.low, (of.high > 0.0 ? factor.high : factor.low) * of.high};
}

/// Bounds of m (1 - m) / 2.
Extent halfSpread(const Extent& share) {
  const auto of = [](double m) { return 0.5 * m * (1.0 - m); };
  const double nearest = std::clamp(0.5, share.low, share.high);
  return {std::min(of(share.low), of(share.high)), of(nearest)};
}

/// F without carves on an interval.
struct LevelBounds {
  Extent value;
  Extent slope;
};

/// sense * phi on an interval.
struct FallBounds {
  double least = 0.0;
  Extent slope;
  Extent slopeByShares;  ///< Not wider.
};

/// Lengths of the interval that is halved to the end.
constexpr double kShortest = 1.0 / static_cast<double>(1LL << isolation::kMostHalvings);

class SoftFall {
 public:
  SoftFall(CliqueLevelsView levels, double sense, double tolerance, BracketSolver solver, SoftFallScratch& scratch)
      : levels_(levels), sense_(sense), tolerance_(tolerance), solver_(solver), scratch_(scratch) {}

  /// On scratch.halves[level], whose [0, 1] is [low, high] of the interval.
  std::optional<double> find(std::size_t level, int halvingsLeft, double low, double high) {
    for (;; --halvingsLeft) {
      const double atStart = valueAtStart(level);
      if (atStart <= 0.0) return low;
      const FallBounds bounds = boundsOf(scratch_.halves[level]);
      // The bound of the value alone does not become tight where parts get short.
      if (bounds.least > 0.0 || atStart + bounds.slopeByShares.low >= 0.0) return std::nullopt;
      if (bounds.slope.high <= 0.0) {
        if (!endsBelow(level)) return std::nullopt;
        return low + (high - low) * rootIn(level, tolerance_ / (high - low));
      }
      if (bounds.slopeByShares.high <= 0.0 && solver_ == BracketSolver::kNewton) {
        if (!endsBelow(level)) return std::nullopt;
        // What halving to the end finds.
        const double root = low + (high - low) * rootIn(level, kShortest / (high - low));
        return kShortest * std::floor(root / kShortest);
      }
      if (halvingsLeft == 0) return endsBelow(level) ? std::optional(low) : std::nullopt;
      split(level);
      const double middle = 0.5 * (low + high);
      if (const auto root = find(level + 1, halvingsLeft - 1, low, middle)) return root;
      low = middle;
    }
  }

 private:
  bool endsBelow(std::size_t level) { return valueAt(level, 1.0).value < 0.0; }

  double valueAtStart(std::size_t level) {
    const SoftSums& sums = scratch_.halves[level];
    double out = sums.everywhere.b.front();
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      std::vector<BlendedGroup>& groups = scratch_.blends[i].clear();
      for (const SoftPart& part : sums.parts) {
        at(groups, part.slot).sum = part.sum.b.front();
        at(groups, part.slot).softness = part.softness.b.front();
      }
      out += levels_[i].weight * scratch_.blends[i].settle();
    }
    return sense_ * out;
  }

  /// sense * phi and its derivative.
  ValueAndSlope valueAt(std::size_t level, double u) {
    const SoftSums& sums = scratch_.halves[level];
    const auto evaluate = [u](const Bernstein& q) { return Bernstein::Evaluator(q)(u); };
    ValueAndSlope out = evaluate(sums.everywhere);
    std::vector<SoftSample>& samples = scratch_.samples;
    samples.clear();
    for (const SoftPart& part : sums.parts) samples.push_back({evaluate(part.sum), evaluate(part.softness)});
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      GroupBlend& blend = scratch_.blends[i];
      std::vector<BlendedGroup>& groups = blend.clear();
      for (std::size_t p = 0; p < samples.size(); ++p) {
        at(groups, sums.parts[p].slot).sum = samples[p].sum.value;
        at(groups, sums.parts[p].slot).softness = samples[p].softness.value;
      }
      const double weight = levels_[i].weight;
      out.value += weight * blend.settle();
      for (std::size_t p = 0; p < samples.size(); ++p) {
        const double share = at(groups, sums.parts[p].slot).share;
        if (share == 0.0) continue;
        out.slope += weight * in_double::softPart(samples[p].sum.slope, samples[p].softness.slope, share);
      }
    }
    return {sense_ * out.value, sense_ * out.slope};
  }

  /// After valueAtStart().
  FallBounds boundsOf(const SoftSums& sums) {
    std::vector<SoftPartBounds>& bounds = scratch_.bounds;
    bounds.assign(scratch_.blends.front().groups().size(), {});
    for (const SoftPart& part : sums.parts) {
      at(bounds, part.slot) = {valuesOf(part.sum), slopesOf(part.sum), valuesOf(part.softness), slopesOf(part.softness),
                               0};
    }
    Extent value;
    Extent slope;
    Extent byShares;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      const LevelBounds of = boundsOf(levels_[i].cliques);
      const Extent narrower = slopeByShares(levels_[i].cliques, scratch_.blends[i].groups());
      add(value, of.value, levels_[i].weight);
      add(slope, of.slope, levels_[i].weight);
      add(byShares, {std::max(of.slope.low, narrower.low), std::min(of.slope.high, narrower.high)}, levels_[i].weight);
    }
    const Extent everywhere = slopesOf(sums.everywhere);
    add(value, valuesOf(sums.everywhere));
    add(slope, everywhere);
    add(byShares, everywhere);
    if (sense_ > 0.0) return {value.low, slope, byShares};
    return {-value.high, {-slope.high, -slope.low}, {-byShares.high, -byShares.low}};
  }

  /// F lies between the largest sum of a clique and that plus sum y_j / 8; its derivative between the cliques' least
  /// and largest, with sum y_j' / 8. Cliques that certainly have no share are left out. From scratch.bounds.
  LevelBounds boundsOf(const CliqueLists& cliques) {
    std::vector<SoftPartBounds>& bounds = scratch_.bounds;
    for (SoftPartBounds& part : bounds) part.holders = 0;
    scratch_.sharing.clear();
    double surely = 0.0;
    for (const std::span<const int> clique : cliques) {
      double least = 0.0;
      for (const int slot : clique) least += at(bounds, slot).sum.low - 0.5 * at(bounds, slot).softness.high;
      surely = std::max(surely, least);
    }
    Extent value{0.0, 0.0};
    Extent slope{kInfinity, -kInfinity};
    for (int k = 0; k < static_cast<int>(cliques.size()); ++k) {
      Extent own;
      Extent ownSlope;
      double possibly = 0.0;
      for (const int slot : at(cliques, k)) {
        add(own, at(bounds, slot).sum);
        add(ownSlope, at(bounds, slot).slope);
        possibly += 0.5 * at(bounds, slot).softness.high;
      }
      if (own.high + possibly <= surely) continue;  // An empty clique may tie.
      scratch_.sharing.push_back(k);
      for (const int slot : at(cliques, k)) ++at(bounds, slot).holders;
      value = {std::max(value.low, own.low), std::max(value.high, own.high)};
      slope = {std::min(slope.low, ownSlope.low), std::max(slope.high, ownSlope.high)};
    }
    if (scratch_.sharing.empty()) return {{surely, surely}, {}};
    if (scratch_.sharing.size() > 1) {
      for (const SoftPartBounds& part : bounds) {
        if (part.holders == 0) continue;
        add(slope, {0.125 * std::min(0.0, part.softnessSlope.low), 0.125 * std::max(0.0, part.softnessSlope.high)});
        value.high += 0.125 * part.softness.high;
      }
    }
    return {value, slope};
  }

  /// Of the slots that no other clique with a share holds.
  SoftPartBounds ownBounds(std::span<const int> clique) const {
    SoftPartBounds own;
    for (const int slot : clique) {
      const SoftPartBounds& part = at(scratch_.bounds, slot);
      if (part.holders != 1) continue;
      add(own.slope, part.slope);
      add(own.softness, part.softness);
      add(own.softnessSlope, part.softnessSlope);
    }
    return own;
  }

  /// The same for F's derivative, sum x_j' m_j + y_j' m_j (1 - m_j) / 2, from the shares where the interval begins.
  /// With sums S and softness Y of the slots that only one clique holds, and a = S' + (1/2 - m) Y', a share's
  /// derivative is its a, less a mean of those of all cliques, over Y. So the bounds close where intervals get short.
  /// If a slot is in several of the cliques that may have a share, but not in all, there are none. After boundsOf().
  Extent slopeByShares(const CliqueLists& cliques, const std::vector<BlendedGroup>& atStart) const {
    const std::vector<int>& sharing = scratch_.sharing;
    const Extent none{-kInfinity, kInfinity};
    if (sharing.size() < 2) return none;
    const int all = static_cast<int>(sharing.size());
    Extent rates{kInfinity, -kInfinity};
    Extent out;
    for (const int k : sharing) {
      for (const int slot : at(cliques, k)) {
        const int holders = at(scratch_.bounds, slot).holders;
        if (holders > 1 && holders < all) return none;
        if (holders == all && k == sharing.front()) add(out, at(scratch_.bounds, slot).slope);
      }
      const SoftPartBounds own = ownBounds(at(cliques, k));
      const double half = 0.5 * std::max(-own.softnessSlope.low, own.softnessSlope.high);
      rates = {std::min(rates.low, own.slope.low - half), std::max(rates.high, own.slope.high + half)};
    }
    for (const int k : sharing) {
      const SoftPartBounds own = ownBounds(at(cliques, k));
      const double least = own.softness.low;
      const double change = least > 0.0 ? 1e-9 + (rates.high - rates.low) / least : 1.0;
      double share = 0.0;
      for (const int slot : at(cliques, k)) {
        if (at(scratch_.bounds, slot).holders == 1) share = std::max(share, at(atStart, slot).share);
      }
      const Extent shares{std::max(0.0, share - change), std::min(1.0, share + change)};
      add(out, scaled(shares, own.slope));
      add(out, scaled(halfSpread(shares), own.softnessSlope));
    }
    return out;
  }

  /// The part's first half goes to the next level, the second takes its place.
  void split(std::size_t level) {
    if (scratch_.halves.size() <= level + 1) scratch_.halves.emplace_back();
    SoftSums& sums = scratch_.halves[level];
    SoftSums& first = scratch_.halves[level + 1];
    const auto halve = [](Bernstein& q, Bernstein& left) {
      Bernstein right;
      q.split(0.5, left, right);
      q = right;
    };
    halve(sums.everywhere, first.everywhere);
    first.parts.resize(sums.parts.size());
    for (std::size_t i = 0; i < sums.parts.size(); ++i) {
      first.parts[i].slot = sums.parts[i].slot;
      halve(sums.parts[i].sum, first.parts[i].sum);
      halve(sums.parts[i].softness, first.parts[i].softness);
    }
  }

  /// The root of the part, on which phi only falls.
  double rootIn(std::size_t level, double tolerance) {
    double low = 0.0;
    double high = 1.0;
    double above = valueAt(level, 0.0).value;
    double below = valueAt(level, 1.0).value;
    const auto secant = [&] { return low + (high - low) * above / (above - below); };
    const auto narrow = [&](double u, double value) {
      (value > 0.0 ? low : high) = u;
      (value > 0.0 ? above : below) = value;
    };
    if (solver_ == BracketSolver::kBisection) {
      for (int i = 0; i < isolation::kBisectionHalvings; ++i)
        narrow(0.5 * (low + high), valueAt(level, 0.5 * (low + high)).value);
      return secant();
    }
    double u = secant();
    for (int step = 0; step < isolation::kMostNewtonSteps; ++step) {
      const ValueAndSlope here = valueAt(level, u);
      narrow(u, here.value);
      double next = u - here.value / here.slope;
      if (!(next >= low && next <= high)) next = 0.5 * (low + high);
      if (std::abs(next - u) <= tolerance || high - low <= tolerance) return next;
      u = next;
    }
    return u;
  }

  CliqueLevelsView levels_;
  double sense_;
  double tolerance_;
  BracketSolver solver_;
  SoftFallScratch& scratch_;
};

}  // namespace

SoftPart& SoftSums::of(int slot) {
  const auto known = std::ranges::find(parts, slot, &SoftPart::slot);
  if (known != parts.end()) return *known;
  SoftPart& added = parts.emplace_back();
  added.slot = slot;
  return added;
}

std::optional<double> firstSoftFall(CliqueLevelsView levels, double sense, double tolerance, BracketSolver solver,
                                    SoftFallScratch& scratch) {
  return SoftFall(levels, sense, tolerance, solver, scratch).find(0, isolation::kMostHalvings, 0.0, 1.0);
}

}  // namespace sinew
