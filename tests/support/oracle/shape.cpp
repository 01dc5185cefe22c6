// tests/support/oracle/shape.cpp: direct transcription of the page, without rearrangement.
#include "tests/support/oracle/shape.h"

#include <algorithm>
#include <cmath>

namespace sinew::oracle {
namespace {

constexpr int kDiscs = 4000;

struct Parts {
  double kappa;
  double e;
  double p;
};

Parts partsOf(const Shape& shape) {
  const auto kappa = static_cast<double>(shape.core);
  return {kappa, 1.0 - kappa, static_cast<double>(shape.belly)};
}

double taper(const Parts& parts, double y) { return 1.0 - 2.0 * parts.p * y + parts.p * parts.p; }

/// By how many e y lies beyond the core.
double beyond(const Parts& parts, double y) { return std::max(std::abs(y) - parts.kappa, 0.0) / parts.e; }

double lateralSquared(const Shape& shape, double y, double reach) {
  const Parts parts = partsOf(shape);
  const double end = beyond(parts, y);
  return std::max(0.0, reach * reach - end * end) / (nu(shape) * taper(parts, y));
}

}  // namespace

double nu(const Shape& shape) {
  const auto [kappa, e, p] = partsOf(shape);
  if (std::abs(p) < 1e-6) return 1.0;
  const double s = 1.0 + p * p - 2.0 * std::abs(p) * kappa;
  const double v = (s - std::sqrt(s * s - 4.0 * p * p * e * e)) / (2.0 * std::abs(p));
  return v / (std::abs(p) * e * e);
}

double rho(const Shape& shape, const Vec& point) {
  const Parts parts = partsOf(shape);
  const double bow = 1.0 - point.y * point.y;
  const double x = point.x - static_cast<double>(shape.bend.x) * bow;
  const double z = point.z - static_cast<double>(shape.bend.y) * bow;
  const double end = beyond(parts, point.y);
  // Beyond the influence of any reach for which S is positive there, S means nothing.
  const double s = std::max(taper(parts, point.y), 0.0);
  return std::sqrt(nu(shape) * s * (x * x + z * z) + end * end);
}

double volume(const Shape& shape) {
  double sum = 0.0;
  for (int i = 0; i < kDiscs; ++i) sum += lateralSquared(shape, -1.0 + (i + 0.5) * 2.0 / kDiscs, 1.0);
  return 0.75 * sum * 2.0 / kDiscs;
}

double widest(const Shape& shape, double reach) {
  const Parts parts = partsOf(shape);
  const double end = parts.kappa + reach * parts.e;
  double most = 0.0;
  for (int i = 0; i < kDiscs; ++i) {
    most = std::max(most, lateralSquared(shape, end * (-1.0 + (i + 0.5) * 2.0 / kDiscs), reach));
  }
  return std::sqrt(most);
}

}  // namespace sinew::oracle
