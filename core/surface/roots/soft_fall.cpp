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

/// F without carves on an interval.
struct LevelBounds {
  Extent value;
  Extent slope;
};

/// sense * phi on an interval.
struct FallBounds {
  double least = 0.0;
  Extent slope;
};

class SoftFall {
 public:
  SoftFall(CliqueLevelsView levels, double sense, double tolerance, BracketSolver solver, SoftFallScratch& scratch)
      : levels_(levels), sense_(sense), tolerance_(tolerance), solver_(solver), scratch_(scratch) {}

  /// On scratch.halves[level], whose [0, 1] is [low, high] of the interval.
  std::optional<double> find(std::size_t level, int halvingsLeft, double low, double high) {
    for (;; --halvingsLeft) {
      const double atStart = valueAt(level, 0.0).value;
      if (atStart <= 0.0) return low;
      const FallBounds bounds = boundsOf(scratch_.halves[level]);
      // The bound of the value alone does not become tight where parts get short.
      if (bounds.least > 0.0 || atStart + bounds.slope.low >= 0.0) return std::nullopt;
      const bool endsBelow = valueAt(level, 1.0).value < 0.0;
      if (bounds.slope.high <= 0.0) {
        if (!endsBelow) return std::nullopt;
        return low + (high - low) * rootIn(level, tolerance_ / (high - low));
      }
      if (halvingsLeft == 0) return endsBelow ? std::optional(low) : std::nullopt;
      split(level);
      const double middle = 0.5 * (low + high);
      if (const auto root = find(level + 1, halvingsLeft - 1, low, middle)) return root;
      low = middle;
    }
  }

 private:
  /// sense * phi and its derivative.
  ValueAndSlope valueAt(std::size_t level, double u) {
    const SoftSums& sums = scratch_.halves[level];
    const auto evaluate = [u](const Bernstein& q) { return Bernstein::Evaluator(q)(u); };
    ValueAndSlope out = evaluate(sums.everywhere);
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      GroupBlend& blend = scratch_.blends[i];
      std::vector<BlendedGroup>& groups = blend.clear();
      for (const SoftPart& part : sums.parts) {
        at(groups, part.slot).sum = part.sum.at(u);
        at(groups, part.slot).softness = part.softness.at(u);
      }
      const double weight = levels_[i].weight;
      out.value += weight * blend.settle();
      for (const SoftPart& part : sums.parts) {
        const double share = at(groups, part.slot).share;
        if (share == 0.0) continue;
        out.slope += weight * in_double::softPart(evaluate(part.sum).slope, evaluate(part.softness).slope, share);
      }
    }
    return {sense_ * out.value, sense_ * out.slope};
  }

  FallBounds boundsOf(const SoftSums& sums) {
    std::vector<SoftPartBounds>& bounds = scratch_.bounds;
    bounds.assign(scratch_.blends.front().clear().size(), {});
    for (const SoftPart& part : sums.parts) {
      at(bounds, part.slot) = {valuesOf(part.sum), slopesOf(part.sum), valuesOf(part.softness).high,
                               slopesOf(part.softness), false};
    }
    LevelBounds whole;
    for (const CliqueLevel& level : levels_) {
      const LevelBounds of = boundsOf(level.cliques);
      add(whole.value, of.value, level.weight);
      add(whole.slope, of.slope, level.weight);
    }
    add(whole.value, valuesOf(sums.everywhere));
    add(whole.slope, slopesOf(sums.everywhere));
    if (sense_ > 0.0) return {whole.value.low, whole.slope};
    return {-whole.value.high, {-whole.slope.high, -whole.slope.low}};
  }

  /// F lies between the largest sum of a clique and that plus sum y_j / 8; its derivative between the cliques' least
  /// and largest, with sum y_j' / 8. Cliques that certainly have no share are left out. From scratch.bounds.
  LevelBounds boundsOf(const CliqueLists& cliques) {
    std::vector<SoftPartBounds>& bounds = scratch_.bounds;
    for (SoftPartBounds& part : bounds) part.mayShare = false;
    double surely = 0.0;
    for (const std::span<const int> clique : cliques) {
      double least = 0.0;
      for (const int slot : clique) least += at(bounds, slot).sum.low - 0.5 * at(bounds, slot).softest;
      surely = std::max(surely, least);
    }
    Extent value{0.0, 0.0};
    Extent slope{kInfinity, -kInfinity};
    int mayWin = 0;
    for (const std::span<const int> clique : cliques) {
      Extent own;
      Extent ownSlope;
      double possibly = 0.0;
      for (const int slot : clique) {
        add(own, at(bounds, slot).sum);
        add(ownSlope, at(bounds, slot).slope);
        possibly += 0.5 * at(bounds, slot).softest;
      }
      if (own.high + possibly <= surely) continue;  // An empty clique may tie.
      ++mayWin;
      for (const int slot : clique) at(bounds, slot).mayShare = true;
      value = {std::max(value.low, own.low), std::max(value.high, own.high)};
      slope = {std::min(slope.low, ownSlope.low), std::max(slope.high, ownSlope.high)};
    }
    if (mayWin == 0) return {{surely, surely}, {}};
    if (mayWin > 1) {
      for (const SoftPartBounds& part : bounds) {
        if (!part.mayShare) continue;
        add(slope, {0.125 * std::min(0.0, part.softnessSlope.low), 0.125 * std::max(0.0, part.softnessSlope.high)});
        value.high += 0.125 * part.softest;
      }
    }
    return {value, slope};
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
