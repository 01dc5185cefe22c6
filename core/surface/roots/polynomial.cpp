// core/surface/roots/polynomial.cpp: de Casteljau's scheme and Ferrari's formulas.
#include "core/surface/roots/polynomial.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/surface/roots/isolation.h"

namespace sinew {
namespace {

std::array<double, 5> powerBasis(const Quartic& q) {
  const auto& b = q.b;
  return {b[0], 4.0 * (b[1] - b[0]), 6.0 * (b[2] - 2.0 * b[1] + b[0]), 4.0 * (b[3] - 3.0 * b[2] + 3.0 * b[1] - b[0]),
          b[4] - 4.0 * b[3] + 6.0 * b[2] - 4.0 * b[1] + b[0]};
}

void addQuadraticRoots(double b, double c, RealRoots& roots) {  // u^2 + b u + c
  const double half = -0.5 * b;
  const double discriminant = half * half - c;
  // Rounding makes a double root's discriminant slightly negative: a test that is not relative would lose roots.
  if (discriminant < -1e-12 * (half * half + std::abs(c))) return;
  const double root = std::sqrt(std::max(discriminant, 0.0));
  const double far = half >= 0.0 ? half + root : half - root;
  roots.add(far);
  roots.add(far != 0.0 ? c / far : 0.0);
}

/// Real roots of u^3 + a u^2 + b u + c.
RealRoots cubicRoots(double a, double b, double c) {
  const double q = (a * a - 3.0 * b) / 9.0;
  const double r = (2.0 * a * a * a - 9.0 * a * b + 27.0 * c) / 54.0;
  if (r * r < q * q * q) {
    const double angle = std::acos(std::clamp(r / std::sqrt(q * q * q), -1.0, 1.0));
    const double scale = -2.0 * std::sqrt(q);
    constexpr double kThird = 2.0 * std::numbers::pi / 3.0;
    RealRoots roots;
    for (const double turn : {0.0, kThird, -kThird}) roots.add(scale * std::cos(angle / 3.0 + turn) - a / 3.0);
    return roots;
  }
  const double s = -std::copysign(std::cbrt(std::abs(r) + std::sqrt(std::max(r * r - q * q * q, 0.0))), r);
  const double t = s != 0.0 ? q / s : 0.0;
  RealRoots roots;
  roots.add(s + t - a / 3.0);
  return roots;
}

/// Real roots of u^4 + a u^3 + b u^2 + c u + d.
RealRoots monicQuarticRoots(double a, double b, double c, double d) {
  // Depressed: y^4 + p y^2 + q y + r, u = y - a/4.
  const double a2 = a * a;
  const double p = b - 0.375 * a2;
  const double q = c - 0.5 * a * b + 0.125 * a2 * a;
  const double r = d - 0.25 * a * c + 0.0625 * a2 * b - 3.0 / 256.0 * a2 * a2;
  const double shift = -0.25 * a;
  RealRoots roots;
  // One ellipsoid makes the quartic biquadratic: q is then only rounding, compared with the terms of its sum.
  const double qScale = std::abs(c) + std::abs(0.5 * a * b) + std::abs(0.125 * a2 * a);
  double z = 0.0;
  if (std::abs(q) > 1e-12 * qScale) z = std::ranges::max(cubicRoots(2.0 * p, p * p - 4.0 * r, -q * q).all());
  if (z > 0.0) {
    const double s = std::sqrt(z);
    addQuadraticRoots(s, 0.5 * (p + z - q / s), roots);
    addQuadraticRoots(-s, 0.5 * (p + z + q / s), roots);
  } else {
    RealRoots squares;
    addQuadraticRoots(p, r, squares);
    for (const double square : squares.all()) {
      if (square < -1e-12 * std::abs(p)) continue;
      const double root = std::sqrt(std::max(square, 0.0));
      roots.add(-root);
      roots.add(root);
    }
  }
  for (double& root : roots.all()) root += shift;
  return roots;
}

/// One Newton step, kept if it helps: closed forms lose digits at close roots.
double polished(const std::array<double, 5>& c, double u) {
  const auto value = [&c](double x) { return (((c[4] * x + c[3]) * x + c[2]) * x + c[1]) * x + c[0]; };
  const double slope = ((4.0 * c[4] * u + 3.0 * c[3]) * u + 2.0 * c[2]) * u + c[1];
  const double next = u - value(u) / slope;
  return std::isfinite(next) && std::abs(value(next)) < std::abs(value(u)) ? next : u;
}

}  // namespace

void Quartic::addConstant(double value) {
  for (double& coefficient : b) coefficient += value;
}

void Quartic::addScaled(const Quartic& other, double factor) {
  for (std::size_t i = 0; i < 5; ++i) b[i] += factor * other.b[i];
}

double Quartic::at(double u) const {
  const double v = 1.0 - u;
  return v * v * (v * v * b[0] + 4.0 * v * u * b[1] + 6.0 * u * u * b[2]) + u * u * u * (4.0 * v * b[3] + u * b[4]);
}

Quartic squareOfQuadratic(double w0, double w1, double w2) {
  return {{w0 * w0, w0 * w1, (w0 * w2 + 2.0 * w1 * w1) / 3.0, w1 * w2, w2 * w2}};
}

void Quartic::split(double u, Quartic& left, Quartic& right) const {
  std::array<double, 5> row = b;
  left.b[0] = row[0];
  right.b[4] = row[4];
  for (std::size_t level = 1; level < 5; ++level) {
    for (std::size_t i = 0; i + level < 5; ++i) row[i] = row[i] + (row[i + 1] - row[i]) * u;
    left.b[level] = row[0];
    right.b[4 - level] = row[4 - level];
  }
}

Quartic::Evaluator::Evaluator(const Quartic& q) : c(powerBasis(q)) {}

std::optional<double> firstFallIsolated(const Quartic& q, double from, double tolerance, BracketSolver solver) {
  return isolation::firstFall(q, from, tolerance, solver);
}

std::optional<double> firstFallClosedForm(const Quartic& q, double from, double tolerance) {
  if (q.at(from) <= 0.0) return from;
  if (std::ranges::all_of(q.b, [](double value) { return value > 0.0; })) return std::nullopt;
  const std::array<double, 5> c = powerBasis(q);
  RealRoots inside;
  const RealRoots everywhere = realRoots(c);
  for (const double root : everywhere.all()) {
    const double close = polished(c, root);
    if (close > from && close <= 1.0) inside.add(close);
  }
  const std::span<const double> roots = inside.all();
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const double after = i + 1 < roots.size() ? 0.5 * (roots[i] + roots[i + 1]) : 0.5 * (roots[i] + 1.0);
    if (q.at(after) < 0.0 || (roots[i] == 1.0 && q.b[4] <= 0.0)) return roots[i];
  }
  // Rounding has hidden a root, though the signs at the ends prove it.
  return q.b[4] < 0.0 ? firstFallIsolated(q, from, tolerance) : std::nullopt;
}

RealRoots realRoots(const std::array<double, 5>& c) {
  double largest = 0.0;
  for (const double value : c) largest = std::max(largest, std::abs(value));
  const double negligible = 1e-13 * largest;
  RealRoots roots;
  if (std::abs(c[4]) > negligible) {
    roots = monicQuarticRoots(c[3] / c[4], c[2] / c[4], c[1] / c[4], c[0] / c[4]);
  } else if (std::abs(c[3]) > negligible) {
    roots = cubicRoots(c[2] / c[3], c[1] / c[3], c[0] / c[3]);
  } else if (std::abs(c[2]) > negligible) {
    addQuadraticRoots(c[1] / c[2], c[0] / c[2], roots);
  } else if (std::abs(c[1]) > negligible) {
    roots.add(-c[0] / c[1]);
  }
  return roots;
}

namespace {

constexpr std::size_t kBernsteinRows = Bernstein::kMostDegree + 1;

/// Pascal's triangle.
constexpr std::array<std::array<double, kBernsteinRows>, kBernsteinRows> kBinomials = [] {
  std::array<std::array<double, kBernsteinRows>, kBernsteinRows> rows{};
  for (std::size_t n = 0; n < kBernsteinRows; ++n) {
    rows[n][0] = 1.0;
    for (std::size_t k = 1; k <= n; ++k) rows[n][k] = rows[n - 1][k - 1] + rows[n - 1][k];
  }
  return rows;
}();

Bernstein raised(const Bernstein& q, std::size_t degree) {
  if (q.degree == degree) return q;
  Bernstein ones;
  ones.degree = degree - q.degree;
  std::fill_n(ones.b.begin(), ones.degree + 1, 1.0);
  return q * ones;
}

}  // namespace

Bernstein::Bernstein(const Quartic& q) : degree(4) { std::ranges::copy(q.b, b.begin()); }

Bernstein Bernstein::linear(double atStart, double atEnd) {
  Bernstein line;
  line.degree = 1;
  line.b[0] = atStart;
  line.b[1] = atEnd;
  return line;
}

void Bernstein::addConstant(double value) {
  for (std::size_t i = 0; i <= degree; ++i) b[i] += value;
}

void Bernstein::addScaled(const Bernstein& other, double factor) {
  if (other.degree > degree) *this = raised(*this, other.degree);
  const Bernstein& added = other.degree < degree ? raised(other, degree) : other;
  for (std::size_t i = 0; i <= degree; ++i) b[i] += factor * added.b[i];
}

double Bernstein::at(double u) const {
  std::array<double, kBernsteinRows> row = b;
  for (std::size_t left = degree; left > 0; --left) {
    for (std::size_t i = 0; i < left; ++i) row[i] += (row[i + 1] - row[i]) * u;
  }
  return row[0];
}

ValueAndSlope Bernstein::Evaluator::operator()(double u) const {
  if (polynomial.degree == 0) return {polynomial.b[0], 0.0};
  std::array<double, kBernsteinRows> row = polynomial.b;
  for (std::size_t left = polynomial.degree; left > 1; --left) {
    for (std::size_t i = 0; i < left; ++i) row[i] += (row[i + 1] - row[i]) * u;
  }
  const double rise = row[1] - row[0];
  return {row[0] + rise * u, static_cast<double>(polynomial.degree) * rise};
}

void Bernstein::split(double u, Bernstein& left, Bernstein& right) const {
  std::array<double, kBernsteinRows> row = b;
  left.degree = right.degree = degree;
  left.b[0] = row[0];
  right.b[degree] = row[degree];
  for (std::size_t level = 1; level <= degree; ++level) {
    for (std::size_t i = 0; i + level <= degree; ++i) row[i] += (row[i + 1] - row[i]) * u;
    left.b[level] = row[0];
    right.b[degree - level] = row[degree - level];
  }
}

Bernstein operator*(const Bernstein& x, const Bernstein& y) {
  Bernstein product;
  product.degree = x.degree + y.degree;
  assert(product.degree <= Bernstein::kMostDegree);
  for (std::size_t i = 0; i <= x.degree; ++i) {
    const double own = kBinomials[x.degree][i] * x.b[i];
    for (std::size_t j = 0; j <= y.degree; ++j) product.b[i + j] += own * kBinomials[y.degree][j] * y.b[j];
  }
  for (std::size_t k = 0; k <= product.degree; ++k) product.b[k] /= kBinomials[product.degree][k];
  return product;
}

std::optional<double> firstFallIsolated(const Bernstein& q, double from, double tolerance, BracketSolver solver) {
  return isolation::firstFall(q, from, tolerance, solver);
}

}  // namespace sinew
