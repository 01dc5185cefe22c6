// core/rig/curve.cpp: Fritsch and Carlson, Monotone Piecewise Cubic Interpolation, 1980.
#include <algorithm>
#include <cassert>
#include <cmath>

#include "sinew/rig/animated_number.h"

namespace sinew {
namespace {

double slopeBetween(const glm::vec2& a, const glm::vec2& b) {
  return (static_cast<double>(b.y) - static_cast<double>(a.y)) / (static_cast<double>(b.x) - static_cast<double>(a.x));
}

/// Slope at a point from those on both sides: the harmonic mean, weighted by the lengths (Fritsch and Butland, 1984),
/// which keeps every piece monotone; 0 at the ends of the curve and where it turns.
double slopeAt(const std::vector<glm::vec2>& points, std::size_t i) {
  if (i == 0 || i + 1 == points.size()) return 0.0;
  const double before = slopeBetween(points[i - 1], points[i]);
  const double after = slopeBetween(points[i], points[i + 1]);
  if (!(before * after > 0.0)) return 0.0;
  const double widthBefore = static_cast<double>(points[i].x) - static_cast<double>(points[i - 1].x);
  const double widthAfter = static_cast<double>(points[i + 1].x) - static_cast<double>(points[i].x);
  const double a = 2.0 * widthAfter + widthBefore;
  const double b = widthAfter + 2.0 * widthBefore;
  return (a + b) / (a / before + b / after);
}

float smoothBetween(const std::vector<glm::vec2>& points, std::size_t i, float x) {
  const glm::vec2& from = points[i];
  const glm::vec2& to = points[i + 1];
  const double width = static_cast<double>(to.x) - static_cast<double>(from.x);
  const double u = (static_cast<double>(x) - static_cast<double>(from.x)) / width;
  const double rise = static_cast<double>(to.y) - static_cast<double>(from.y);
  const double u2 = u * u;
  const double u3 = u2 * u;
  const double y = static_cast<double>(from.y) + rise * (3.0 * u2 - 2.0 * u3) +
                   width * (slopeAt(points, i) * (u3 - 2.0 * u2 + u) + slopeAt(points, i + 1) * (u3 - u2));
  return static_cast<float>(y);
}

/// In double: differences of large numbers stay finite.
float straightBetween(const glm::vec2& from, const glm::vec2& to, float x) {
  const double u = (static_cast<double>(x) - static_cast<double>(from.x)) /
                   (static_cast<double>(to.x) - static_cast<double>(from.x));
  return static_cast<float>(static_cast<double>(from.y) +
                            u * (static_cast<double>(to.y) - static_cast<double>(from.y)));
}

}  // namespace

float valueAt(const Curve& curve, float x) {
  const std::vector<glm::vec2>& points = curve.points;
  assert(!points.empty());
  if (!(x > points.front().x)) return points.front().y;
  if (x >= points.back().x) return points.back().y;
  const auto next = std::ranges::upper_bound(points, x, {}, [](const glm::vec2& point) { return point.x; });
  const auto i = static_cast<std::size_t>(next - points.begin()) - 1;
  if (curve.kind == CurveKind::kStep) return points[i].y;
  const glm::vec2& from = points[i];
  const glm::vec2& to = points[i + 1];
  const float y = curve.kind == CurveKind::kSmooth ? smoothBetween(points, i, x) : straightBetween(from, to, x);
  // Rounding alone could leave the interval.
  return std::clamp(y, std::min(from.y, to.y), std::max(from.y, to.y));
}

}  // namespace sinew
