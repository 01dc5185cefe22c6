// core/surface/roots/shaped_ray.cpp: a ray clipped to the shape's box and cut at the ends of its core; then its roots.
#include "core/surface/roots/shaped_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/surface/roots/isolation.h"

namespace sinew {
namespace {

constexpr double kShapedRayRootTolerance = 1e-12;  ///< Fraction of a part's length: f is flat where an influence ends.

struct Interval {
  double begin = 0.0;
  double end = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool isEmpty() const { return !(begin < end); }
};

/// The part of the ray with t >= 0 that lies in the shape's box.
Interval inBox(const ShapedRay& ray) {
  Interval inside;
  for (int i = 0; i < 3; ++i) {
    const double low = static_cast<double>(ray.shape.low[i]) - ray.start[i];
    const double high = static_cast<double>(ray.shape.high[i]) - ray.start[i];
    if (ray.along[i] == 0.0) {
      if (low > 0.0 || high < 0.0) return {0.0, 0.0};
      continue;
    }
    const double a = low / ray.along[i];
    const double b = high / ray.along[i];
    inside = {std::max(inside.begin, std::min(a, b)), std::min(inside.end, std::max(a, b))};
  }
  return inside;
}

/// The ends of an interval, and where the ray crosses the ends of the core between them.
struct Cuts {
  std::array<double, 4> at{};
  std::size_t count = 0;
};

Cuts cutsOf(const ShapedRay& ray, const Interval& whole) {
  Cuts cuts;
  cuts.at[cuts.count++] = whole.begin;
  if (ray.shape.core > 0.0f && ray.along.y != 0.0) {
    const double core = std::copysign(static_cast<double>(ray.shape.core), ray.along.y);
    for (const double y : {-core, core}) {
      const double t = (y - ray.start.y) / ray.along.y;
      if (t > cuts.at[cuts.count - 1] && t < whole.end) cuts.at[cuts.count++] = t;
    }
  }
  cuts.at[cuts.count++] = whole.end;
  return cuts;
}

/// The end of the core that y is beyond: -1, 1, or 0 beside the core. Without a core it does not matter.
double sideOf(const UnitShape& shape, double y) {
  if (shape.core > 0.0f && std::abs(y) <= static_cast<double>(shape.core)) return 0.0;
  return y < 0.0 ? -1.0 : 1.0;
}

/// Adds the intervals of one part, on which 1 - r^2 is `w`.
void addWherePositive(const Bernstein& w, const Interval& part, ShapedStretches& out) {
  isolation::Roots roots;
  isolation::allRoots(w, 0.0, 1.0, kShapedRayRootTolerance, roots);
  double from = 0.0;
  bool wasInside = false;
  const auto length = part.end - part.begin;
  for (std::size_t i = 0; i <= roots.count; ++i) {
    const double to = i < roots.count ? roots.at[i] : 1.0;
    const bool inside = to > from && w.at(0.5 * (from + to)) > 0.0;
    const double leave = to == 1.0 ? part.end : part.begin + to * length;
    if (inside && wasInside) {
      out.last().leave = leave;  // A touch.
    } else if (inside) {
      out.add({from == 0.0 ? part.begin : part.begin + from * length, leave, false});
    }
    if (to > from) wasInside = inside;
    from = to;
  }
}

}  // namespace

ShapedRay::ShapedRay(const UnitBallMap& influence, const glm::vec3& origin, const glm::vec3& direction)
    : shape(influence.shape) {
  const glm::dmat3 linear(influence.toUnit);
  start = linear * glm::dvec3(origin - influence.center);
  along = linear * glm::dvec3(direction);
}

bool ShapedRay::isQuadratic() const {
  return shape.taper == 0.0f && shape.curve == glm::vec2(0.0f) && shape.bend == glm::vec2(0.0f);
}

RayQuadratic ShapedRay::quadraticAround(double t) const {
  const double lateral = static_cast<double>(shape.lateral);
  const double side = sideOf(shape, at(t).y);
  const double inverse = side == 0.0 ? 0.0 : static_cast<double>(shape.inverseEnd);
  const double beyond = (start.y - side * static_cast<double>(shape.core)) * inverse;
  const double rate = along.y * inverse;
  return {lateral * (along.x * along.x + along.z * along.z) + rate * rate,
          lateral * (start.x * along.x + start.z * along.z) + beyond * rate,
          lateral * (start.x * start.x + start.z * start.z) + beyond * beyond};
}

Bernstein ShapedRay::insideness(double begin, double end) const {
  const glm::dvec3 a = at(begin);
  const glm::dvec3 b = at(end);
  Bernstein x = Bernstein::linear(a.x, b.x);
  Bernstein z = Bernstein::linear(a.z, b.z);
  x.addConstant(-static_cast<double>(shape.bend.x));
  z.addConstant(-static_cast<double>(shape.bend.y));
  if (shape.curve != glm::vec2(0.0f)) {
    const Bernstein y = Bernstein::linear(a.y, b.y);
    const Bernstein squared = y * y;
    x.addScaled(squared, -static_cast<double>(shape.curve.x));
    z.addScaled(squared, -static_cast<double>(shape.curve.y));
  }
  Bernstein across = x * x;
  across.addScaled(z * z, 1.0);
  const double lateral = static_cast<double>(shape.lateral);
  const double taper = static_cast<double>(shape.taper);
  Bernstein w;
  w.addConstant(1.0);
  w.addScaled(taper == 0.0 ? across : Bernstein::linear(lateral + taper * a.y, lateral + taper * b.y) * across,
              taper == 0.0 ? -lateral : -1.0);
  const double side = sideOf(shape, at(0.5 * (begin + end)).y);
  if (side == 0.0) return w;
  const double inverse = static_cast<double>(shape.inverseEnd);
  const double core = side * static_cast<double>(shape.core);
  const Bernstein beyond = Bernstein::linear((a.y - core) * inverse, (b.y - core) * inverse);
  w.addScaled(beyond * beyond, -1.0);
  return w;
}

ShapedStretches ShapedRay::stretches() const {
  ShapedStretches out;
  const Interval whole = inBox(*this);
  if (whole.isEmpty() || !std::isfinite(whole.end)) return out;
  const Cuts cuts = cutsOf(*this, whole);
  for (std::size_t i = 0; i + 1 < cuts.count; ++i) {
    const std::size_t before = out.items().size();
    addWherePositive(insideness(cuts.at[i], cuts.at[i + 1]), {cuts.at[i], cuts.at[i + 1]}, out);
    const bool joins = before > 0 && out.items().size() > before && out.items()[before].enter == cuts.at[i] &&
                       out.items()[before - 1].leave == cuts.at[i];
    if (joins) out.markJoined(before - 1);
  }
  return out;
}

}  // namespace sinew
