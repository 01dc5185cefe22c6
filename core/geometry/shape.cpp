// core/geometry/shape.cpp: the table of numbers, and a shape's unit space, bounds and volume. Formulas: docs/design.md.
#include "sinew/geometry/shape.h"

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "core/geometry/affine_image.h"
#include "core/geometry/formulas.h"

namespace sinew {
namespace {

constexpr std::array<ShapeNumber, kShapeNumbers> kNumbers{
    {{"core", "core", "Straight", "Straighten",
      "Straight part along the longest axis: 0 is an ellipsoid, 0.9 a cylinder with rounded ends",
      [](Shape& shape) -> float& { return shape.core; }, 0.0f, kMostCore},
     {"belly", "belly", "Belly", "Move the belly of",
      "Where along the longest axis the muscle is thickest. A larger reach allows less",
      [](Shape& shape) -> float& { return shape.belly; }, -1.0f, 1.0f, 1,
      [](const Shape& shape, float reach) { return mostBelly(shape.core, reach); }},
     {"bend", "bend.x", "Bend X", "Bend", "How far the middle is moved along the muscle's own x axis, in its radii",
      [](Shape& shape) -> float& { return shape.bend.x; }, -kMostBend, kMostBend, 0},
     {"bend", "bend.z", "Bend Z", "Bend", "How far the middle is moved along the muscle's own z axis, in its radii",
      [](Shape& shape) -> float& { return shape.bend.y; }, -kMostBend, kMostBend, 2}}};
static_assert(kNumbers.back().key != nullptr, "a row for each member of Shape");

std::vector<std::span<const ShapeNumber>> byKey() {
  std::vector<std::span<const ShapeNumber>> keys;
  for (auto first = kNumbers.begin(); first != kNumbers.end();) {
    const auto end = std::find_if(
        first, kNumbers.end(), [&](const ShapeNumber& number) { return std::string_view(number.key) != first->key; });
    keys.emplace_back(first, end);
    first = end;
  }
  return keys;
}

constexpr double kMargin = 0.95;        ///< Fraction of the belly at which S would reach 0 at the influence's end.
constexpr double kStraightShare = 0.6;  ///< Fraction of the sphere's height for a full core in onShape().

/// A shape's constants in double.
struct Numbers {
  double core;
  double end;    ///< e
  double belly;  ///< p
  double nu;

  explicit Numbers(const Shape& shape)
      : core(static_cast<double>(shape.core)), end(1.0 - core), belly(static_cast<double>(shape.belly)) {
    nu = 2.0 /
         (taperAt(core) + std::sqrt(std::max(0.0, taperAt(core) * taperAt(core) - 4.0 * belly * belly * end * end)));
  }

  /// S at y on the thick side.
  [[nodiscard]] double taperAt(double y) const { return 1.0 + belly * belly - 2.0 * std::abs(belly) * y; }

  /// Largest lateral radius where rho <= reach, squared.
  [[nodiscard]] double lateralSquared(double reach) const {
    const double s = taperAt(core);
    const double root = std::sqrt(std::max(0.0, s * s - 4.0 * belly * belly * reach * reach * end * end));
    return 2.0 * reach * reach / (nu * (s + root));
  }

  /// Area of the visible section at y, divided by pi.
  [[nodiscard]] double section(double y) const {
    const double beyond = std::max(0.0, std::abs(y) - core) / end;
    return (1.0 - beyond * beyond) / (nu * (1.0 + belly * belly - 2.0 * belly * y));
  }

  /// Integral of the section: Gauss-Legendre quadrature with eight points.
  [[nodiscard]] double volume(double from, double to) const {
    constexpr std::array<std::pair<double, double>, 4> kPoints{{{0.1834346424956498, 0.3626837833783620},
                                                                {0.5255324099163290, 0.3137066458778873},
                                                                {0.7966664774136267, 0.2223810344533745},
                                                                {0.9602898564975363, 0.1012285362903763}}};
    const double middle = 0.5 * (from + to);
    const double half = 0.5 * (to - from);
    double sum = 0.0;
    for (const auto& [at, weight] : kPoints)
      sum += weight * (section(middle - half * at) + section(middle + half * at));
    return half * sum;
  }

  [[nodiscard]] double volume() const {
    if (belly == 0.0) return (4.0 + 2.0 * core) / 3.0;
    return volume(-1.0, -core) + volume(-core, core) + volume(core, 1.0);
  }
};

template <class Numbers, class Real>
Numbers numbersOf(const UnitShape& unit) {
  return {Real(unit.lateral), Real(unit.taper),   Real(unit.bend.x), Real(unit.bend.y),
          Real(unit.curve.x), Real(unit.curve.y), Real(unit.core),   Real(unit.inverseEnd)};
}
constexpr auto kInFloat = numbersOf<in_float::ShapeNumbers, float>;
constexpr auto kInDouble = numbersOf<in_double::ShapeNumbers, double>;

/// ballAround() of the unit ball.
double ballAroundEllipsoid(const glm::dmat3& axes) {
  // Half extents of the world box around the ellipsoid: row norms of the axes.
  glm::dvec3 half(0.0);
  for (int row = 0; row < 3; ++row) {
    half[row] = std::sqrt(axes[0][row] * axes[0][row] + axes[1][row] * axes[1][row] + axes[2][row] * axes[2][row]);
  }
  const double frobenius =
      std::sqrt(glm::dot(axes[0], axes[0]) + glm::dot(axes[1], axes[1]) + glm::dot(axes[2], axes[2]));
  return std::min(glm::length(half), frobenius);
}

/// Largest length of the image of a unit vector under the map with these two columns.
double mostStretch(const glm::dvec3& a, const glm::dvec3& b) {
  const double mean = 0.5 * (glm::dot(a, a) + glm::dot(b, b));
  const double half = 0.5 * (glm::dot(a, a) - glm::dot(b, b));
  return std::sqrt(mean + std::hypot(half, glm::dot(a, b)));
}

}  // namespace

std::pair<float, float> ShapeNumber::range(const Shape& shape, float reach) const {
  if (most == nullptr) return {low, high};
  const float limit = most(shape, reach);
  return {std::max(low, -limit), std::min(high, limit)};
}

std::span<const ShapeNumber, kShapeNumbers> shapeNumbers() { return kNumbers; }

std::span<const std::span<const ShapeNumber>> shapeKeys() {
  static const std::vector<std::span<const ShapeNumber>> keys = byKey();
  return keys;
}

float mostBelly(float core, float reach) {
  // S(y) > 0 up to y = K: p < K - sqrt(K^2 - 1), written without the difference.
  const double k = static_cast<double>(core) + static_cast<double>(reach) * (1.0 - static_cast<double>(core));
  return static_cast<float>(kMargin / (k + std::sqrt(std::max(0.0, k * k - 1.0))));
}

Shape legalShape(const Shape& shape, float reach) {
  Shape legal;
  for (const ShapeNumber& number : shapeNumbers()) {
    const auto [low, high] = number.range(legal, reach);
    const float value = number.of(shape);
    number.member(legal) = std::isfinite(value) ? std::clamp(value, low, high) : 0.0f;
  }
  return legal;
}

float thickestAt(const Shape& shape) {
  if (shape.belly == 0.0f) return 0.0f;
  const Numbers numbers(shape);
  const double beyond = std::abs(numbers.belly) * numbers.nu * numbers.end * numbers.end;  // v of docs/design.md.
  return static_cast<float>(std::copysign(numbers.core + beyond, numbers.belly));
}

float sectionAt(const Shape& shape, float y) {
  const UnitShape unit = unitShape(shape, 1.0f);
  const float end = std::max(std::abs(y) - unit.core, 0.0f) * unit.inverseEnd;
  return std::sqrt(std::max(1.0f - end * end, 0.0f) / (unit.lateral + unit.taper * y));
}

glm::vec2 axisAt(const Shape& shape, float y) { return shape.bend * (1.0f - y * y); }

glm::vec3 onShape(const Shape& shape, float scale, const glm::vec3& onSphere) {
  if (shape.isPlain()) return scale * onSphere;
  const Numbers numbers(shape);
  const double size = static_cast<double>(scale);
  const double height = std::min(1.0, std::abs(static_cast<double>(onSphere.y)));
  const double straight = kStraightShare * numbers.core / (numbers.core + numbers.end * size);
  const double beyond = std::max(0.0, height - straight) / (1.0 - straight);
  const double along =
      height < straight ? numbers.core * height / straight : numbers.core + numbers.end * size * beyond;
  const double y = std::copysign(along, static_cast<double>(onSphere.y));
  const double s = 1.0 + numbers.belly * numbers.belly - 2.0 * numbers.belly * y;
  const double lateral = size * std::sqrt(std::max(0.0, 1.0 - beyond * beyond) / (numbers.nu * s));
  const double length = std::hypot(static_cast<double>(onSphere.x), static_cast<double>(onSphere.z));
  const double spread = length > 0.0 ? lateral / length : 0.0;
  const double bend = 1.0 - y * y;
  return {static_cast<float>(spread * static_cast<double>(onSphere.x) + static_cast<double>(shape.bend.x) * bend),
          static_cast<float>(y),
          static_cast<float>(spread * static_cast<double>(onSphere.z) + static_cast<double>(shape.bend.y) * bend)};
}

UnitShape unitShape(const Shape& shape, float reach) {
  UnitShape unit;
  unit.isPlain = shape.isPlain();
  if (unit.isPlain) return unit;
  const Numbers numbers(shape);
  const double k = static_cast<double>(reach);
  unit.lateral = static_cast<float>(numbers.nu * (1.0 + numbers.belly * numbers.belly));
  unit.taper = static_cast<float>(-2.0 * numbers.nu * numbers.belly * k);
  unit.bend = shape.bend / reach;
  unit.curve = -reach * shape.bend;
  unit.core = static_cast<float>(numbers.core / k);
  unit.inverseEnd = static_cast<float>(1.0 / numbers.end);
  unit.meanRadius = static_cast<float>(std::cbrt(0.75 * numbers.volume()));

  constexpr float kRoom = 1.0f + 1e-6f;
  const float along = kRoom * static_cast<float>(numbers.core / k + numbers.end);
  const float lateral = kRoom * static_cast<float>(std::sqrt(numbers.lateralSquared(k)) / k);
  const glm::vec2 middle = unit.bend;
  const glm::vec2 ends = unit.bend + along * along * unit.curve;
  const glm::vec2 low = glm::vec2(std::min(middle.x, ends.x), std::min(middle.y, ends.y)) - lateral;
  const glm::vec2 high = glm::vec2(std::max(middle.x, ends.x), std::max(middle.y, ends.y)) + lateral;
  unit.low = {low.x, -along, low.y};
  unit.high = {high.x, along, high.y};
  return unit;
}

float UnitShape::rSquared(const glm::vec3& p) const {
  return in_float::shapeRSquared(in_float::shapePoint(kInFloat(*this), p));
}
double UnitShape::rSquared(const glm::dvec3& p) const {
  return in_double::shapeRSquared(in_double::shapePoint(kInDouble(*this), p));
}
glm::vec3 UnitShape::rSquaredSlope(const glm::vec3& p) const {
  const in_float::ShapeNumbers numbers = kInFloat(*this);
  return 2.0f * in_float::shapeHalfSlope(numbers, in_float::shapePoint(numbers, p));
}
glm::dvec3 UnitShape::rSquaredSlope(const glm::dvec3& p) const {
  const in_double::ShapeNumbers numbers = kInDouble(*this);
  return 2.0 * in_double::shapeHalfSlope(numbers, in_double::shapePoint(numbers, p));
}

double ballAround(const UnitShape& shape, const glm::dmat3& axes) {
  if (shape.isPlain) return ballAroundEllipsoid(axes);
  const double along = static_cast<double>(shape.high.y);
  const double core = static_cast<double>(shape.core);
  const glm::dvec3 middle = axes[0] * static_cast<double>(shape.bend.x) + axes[2] * static_cast<double>(shape.bend.y);
  const glm::dvec3 curve =
      (axes[0] * static_cast<double>(shape.curve.x) + axes[2] * static_cast<double>(shape.curve.y)) * (along * along);
  // First bound: a tube around the axis, a parabola inside the triangle of its control points.
  const double lateral =
      0.5 * static_cast<double>(shape.high.x - shape.low.x - std::abs(shape.curve.x) * shape.high.y * shape.high.y);
  const double around = mostStretch(axes[0], axes[2]) * lateral;
  double tube = glm::length(middle - curve);
  // Second bound: an ellipsoid as wide as the section could be at the thick end, moved along the core and the bend.
  const double thinnest = static_cast<double>(shape.lateral) - std::abs(static_cast<double>(shape.taper)) * along;
  const double widest = 1.0 / std::sqrt(thinnest);
  const double end =
      ballAroundEllipsoid({axes[0] * widest, axes[1] / static_cast<double>(shape.inverseEnd), axes[2] * widest});
  double moved = 0.0;
  for (const double side : {-1.0, 1.0}) {
    tube = std::max(tube, glm::length(middle + curve + side * along * axes[1]));
    moved = std::max(
        {moved, glm::length(middle + side * core * axes[1]), glm::length(middle + curve + side * core * axes[1])});
  }
  return std::min(tube + around, moved + end);
}

}  // namespace sinew
