// core/surface/roots/bernstein.cpp: sums, products and de Casteljau's scheme.
#include "core/surface/roots/bernstein.h"

#include <algorithm>
#include <cassert>

#include "core/surface/roots/isolation.h"

namespace sinew {
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
