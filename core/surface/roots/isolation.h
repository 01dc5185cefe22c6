// core/surface/roots/isolation.h: first roots of polynomials in Bernstein form by subdivision (Descartes' rule).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/surface/roots/polynomial.h"

namespace sinew::isolation {

inline constexpr int kMostHalvings = 40;     ///< Two roots closer than 1e-12 of the interval are one touch.
inline constexpr int kMostNewtonSteps = 60;  ///< Bisection would need 50.
inline constexpr int kBisectionHalvings = 8;

template <class Polynomial>
int signChanges(const Polynomial& q) {
  int changes = 0;
  double last = 0.0;
  for (const double value : q.coefficients()) {
    if (value == 0.0) continue;
    if (last * value < 0.0) ++changes;
    last = value;
  }
  return changes;
}

/// The one root of q on [0, 1], q(0) > 0 > q(1).
template <class Polynomial>
double bracketedNewton(const Polynomial& q, double tolerance) {
  const typename Polynomial::Evaluator evaluate(q);
  double low = 0.0;
  double high = 1.0;
  double u = q.coefficients().front() / (q.coefficients().front() - q.coefficients().back());
  for (int step = 0; step < kMostNewtonSteps; ++step) {
    const auto [value, slope] = evaluate(u);
    (value > 0.0 ? low : high) = u;
    double next = u - value / slope;
    if (!(next >= low && next <= high)) next = 0.5 * (low + high);
    if (std::abs(next - u) <= tolerance || high - low <= tolerance) return next;
    u = next;
  }
  return u;
}

/// The same by bisection.
template <class Polynomial>
double bracketedBisection(const Polynomial& q) {
  double low = 0.0;
  double high = 1.0;
  double valueLow = q.coefficients().front();
  double valueHigh = q.coefficients().back();
  for (int i = 0; i < kBisectionHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    const double value = q.at(middle);
    (value > 0.0 ? low : high) = middle;
    (value > 0.0 ? valueLow : valueHigh) = value;
  }
  return low + (high - low) * valueLow / (valueLow - valueHigh);
}

struct Wanted {
  double tolerance;
  BracketSolver solver;
};

template <class Polynomial>
std::optional<double> isolate(const Polynomial& q, double low, double high, const Wanted& wanted, int halvingsLeft) {
  if (q.coefficients().front() <= 0.0) return low;
  const int changes = signChanges(q);
  if (changes == 0) return std::nullopt;
  const bool endsBelow = q.coefficients().back() < 0.0;
  if (changes == 1 && endsBelow) {
    const double inside = wanted.solver == BracketSolver::kNewton ? bracketedNewton(q, wanted.tolerance / (high - low))
                                                                  : bracketedBisection(q);
    return low + (high - low) * inside;
  }
  if (halvingsLeft == 0) return endsBelow ? std::optional(low) : std::nullopt;
  Polynomial left;
  Polynomial right;
  q.split(0.5, left, right);
  const double middle = 0.5 * (low + high);
  if (const auto root = isolate(left, low, middle, wanted, halvingsLeft - 1)) return root;
  return isolate(right, middle, high, wanted, halvingsLeft - 1);
}

/// firstFallIsolated() (polynomial.h) for any degree.
template <class Polynomial>
std::optional<double> firstFall(const Polynomial& q, double from, double tolerance, BracketSolver solver) {
  const Wanted wanted{tolerance, solver};
  if (from <= 0.0) return isolate(q, 0.0, 1.0, wanted, kMostHalvings);
  if (from >= 1.0) return q.coefficients().back() <= 0.0 ? std::optional(1.0) : std::nullopt;
  Polynomial left;
  Polynomial right;
  q.split(from, left, right);
  return isolate(right, from, 1.0, wanted, kMostHalvings);
}

/// Changes of sign of a polynomial of low degree, ascending.
struct Roots {
  std::array<double, 8> at{};
  std::size_t count = 0;
};

/// Adds changes of sign of q, whose [0, 1] is [low, high]; two closer than 2^-halvingsLeft are a touch, left out.
template <class Polynomial>
void allRoots(const Polynomial& q, double low, double high, double tolerance, Roots& roots, int halvingsLeft = 26) {
  const int changes = signChanges(q);
  if (changes == 0 || roots.count == roots.at.size()) return;
  const double atStart = q.coefficients().front();
  if (changes == 1 && atStart * q.coefficients().back() < 0.0) {
    Polynomial falling = q;
    if (atStart < 0.0) std::ranges::transform(falling.b, falling.b.begin(), [](double value) { return -value; });
    roots.at[roots.count++] = low + (high - low) * bracketedNewton(falling, tolerance / (high - low));
    return;
  }
  if (halvingsLeft == 0) return;
  Polynomial left;
  Polynomial right;
  q.split(0.5, left, right);
  const double middle = 0.5 * (low + high);
  allRoots(left, low, middle, tolerance, roots, halvingsLeft - 1);
  if (q.at(0.5) == 0.0 && roots.count < roots.at.size()) roots.at[roots.count++] = middle;
  allRoots(right, middle, high, tolerance, roots, halvingsLeft - 1);
}

}  // namespace sinew::isolation
