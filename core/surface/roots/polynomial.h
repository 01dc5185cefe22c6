// core/surface/roots/polynomial.h: polynomials on [0, 1] in Bernstein form and their first roots.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <optional>
#include <span>

namespace sinew {

/// How to narrow a bracket around one root: Newton steps kept inside it, down to the tolerance; or 8 halvings and one
/// secant step (paper 4.2: "less than eight steps are necessary").
enum class BracketSolver { kNewton, kBisection };

/// Value and derivative of a polynomial.
struct ValueAndSlope {
  double value = 0.0;
  double slope = 0.0;
};

/// sum b_i B_i^4(u), u in [0, 1]. Products of quadratics are exact and stable in this form, and its sign changes bound
/// the number of roots (Descartes' rule; Farouki & Rajan 1987).
struct Quartic {
  std::array<double, 5> b{};

  void addConstant(double value);
  void addScaled(const Quartic& other, double factor);
  [[nodiscard]] double at(double u) const;
  [[nodiscard]] std::span<const double> coefficients() const { return b; }
  /// De Casteljau: the parts left and right of u, each on [0, 1] again.
  void split(double u, Quartic& left, Quartic& right) const;

  /// Horner's scheme, for many values of one polynomial.
  struct Evaluator {
    std::array<double, 5> c;

    explicit Evaluator(const Quartic& q);
    [[nodiscard]] ValueAndSlope operator()(double u) const {
      return {(((c[4] * u + c[3]) * u + c[2]) * u + c[1]) * u + c[0],
              ((4.0 * c[4] * u + 3.0 * c[3]) * u + 2.0 * c[2]) * u + c[1]};
    }
  };
};

/// (w0, w1, w2 Bernstein quadratic) squared.
[[nodiscard]] Quartic squareOfQuadratic(double w0, double w1, double w2);

/// First u in [from, 1] at which q, positive before, becomes <= 0: by subdivision until one sign change is left, then
/// by `solver`. q(from) <= 0 gives `from`. May miss a root where q only touches 0.
[[nodiscard]] std::optional<double> firstFallIsolated(const Quartic& q, double from, double tolerance,
                                                      BracketSolver solver = BracketSolver::kNewton);

/// The same in closed form: the first of all real roots (Ferrari) at which q changes its sign.
[[nodiscard]] std::optional<double> firstFallClosedForm(const Quartic& q, double from, double tolerance);

/// Up to four numbers, ascending.
class RealRoots {
 public:
  void add(double root) {
    assert(count_ < roots_.size());
    std::size_t place = count_++;
    for (; place > 0 && roots_[place - 1] > root; --place) roots_[place] = roots_[place - 1];
    roots_[place] = root;
  }
  [[nodiscard]] std::span<double> all() { return std::span(roots_).first(count_); }
  [[nodiscard]] std::span<const double> all() const { return std::span(roots_).first(count_); }

 private:
  std::array<double, 4> roots_{};
  std::size_t count_ = 0;
};

/// Real roots of c[0] + ... + c[4] u^4, ascending; a multiple root may come once. Negligible leading c count as 0.
[[nodiscard]] RealRoots realRoots(const std::array<double, 5>& c);

/// sum b_i B_i^n(u), u in [0, 1], with a degree up to 10, for shaped primitives.
struct Bernstein {
  static constexpr std::size_t kMostDegree = 10;  ///< (1 - r^2)^2 of a primitive with belly and bend.

  std::size_t degree = 0;
  std::array<double, kMostDegree + 1> b{};  ///< The first degree + 1.

  Bernstein() = default;
  explicit Bernstein(const Quartic& q);
  [[nodiscard]] static Bernstein linear(double atStart, double atEnd);

  void addConstant(double value);
  void addScaled(const Bernstein& other, double factor);  ///< Raises the degree of the lower one first.
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

/// Exact except for rounding. The sum of both degrees is at most kMostDegree.
[[nodiscard]] Bernstein operator*(const Bernstein& x, const Bernstein& y);

[[nodiscard]] std::optional<double> firstFallIsolated(const Bernstein& q, double from, double tolerance,
                                                      BracketSolver solver = BracketSolver::kNewton);

}  // namespace sinew
