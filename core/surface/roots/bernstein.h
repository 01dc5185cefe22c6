// core/surface/roots/bernstein.h: polynomials of degree up to 10 on [0, 1] in Bernstein form, for shaped primitives.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "core/surface/roots/quartic.h"

namespace sinew {

/// sum b_i B_i^n(u), u in [0, 1]. What quartic.h says of its form holds here.
struct Bernstein {
  static constexpr std::size_t kMostDegree = 10;  ///< (1 - r^2)^2 of a primitive with belly and bend.

  std::size_t degree = 0;
  std::array<double, kMostDegree + 1> b{};  ///< The first degree + 1.

  Bernstein() = default;
  explicit Bernstein(const Quartic& q);
  /// From `atStart` to `atEnd`.
  [[nodiscard]] static Bernstein linear(double atStart, double atEnd);

  void addConstant(double value);
  /// Raises the degree of the lower one first.
  void addScaled(const Bernstein& other, double factor);
  [[nodiscard]] double at(double u) const;
  [[nodiscard]] std::span<const double> coefficients() const { return std::span(b).first(degree + 1); }
  void split(double u, Bernstein& left, Bernstein& right) const;

  /// De Casteljau's scheme: powers of u would lose digits at degree 10.
  struct Evaluator {
    const Bernstein& polynomial;

    explicit Evaluator(const Bernstein& q) : polynomial(q) {}
    [[nodiscard]] ValueAndSlope operator()(double u) const;
  };
};

/// Exact but for rounding. The degrees' sum is at most kMostDegree.
[[nodiscard]] Bernstein operator*(const Bernstein& x, const Bernstein& y);

/// As the one for quartics.
[[nodiscard]] std::optional<double> firstFallIsolated(const Bernstein& q, double from, double tolerance,
                                                      BracketSolver solver = BracketSolver::kNewton);

}  // namespace sinew
