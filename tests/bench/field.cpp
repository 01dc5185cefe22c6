// tests/bench/field.cpp: what one evaluation of the field costs, kind by kind: the same sums over ellipsoids, spheres
// and shapes of the same size.

#include <cmath>
#include <cstdio>
#include <vector>

#include "app/command/measuring.h"
#include "core/geometry/stopwatch.h"
#include "core/rig/field.h"
#include "core/surface/roots/ray_field.h"
#include "tests/bench/parts.h"

namespace sinew::app {
namespace {

/// Nanoseconds a primitive and point or ray, medians of the rounds; ratios to the ellipsoid of one round, median. A ray
/// is met by a primitive when it becomes terms along it (core/surface/roots/ray_field.h).
struct FieldCost {
  std::string kind;
  double atPoint = 0.0;
  double pointRatio = 1.0;
  double onRay = 0.0;
  double rayRatio = 1.0;
};

constexpr int kPrimitives = 40;
constexpr int kPoints = 20'000;

/// A point of the unit cube; evenly spread, the same on every machine.
glm::vec3 spread(int i) {
  const auto part = [i](double step) { return static_cast<float>(std::fmod(0.5 + step * i, 1.0)); };
  return {part(0.8191725133961645), part(0.6710436067037893), part(0.5497004779019703)};
}

std::vector<PosedPrimitive> primitivesOf(const glm::vec3& radii, const Shape& shape) {
  std::vector<FieldPrimitive> primitives(kPrimitives);
  for (int i = 0; i < kPrimitives; ++i) {
    primitives[static_cast<std::size_t>(i)].placement = {spread(i), glm::quat(1.0f, 0.0f, 0.0f, 0.0f), radii, shape};
  }
  std::vector<PosedPrimitive> posed;
  poseField(primitives, std::vector{glm::mat4(1.0f)}, 0.0f, posed);
  return posed;
}

/// One kind's work; `checksum` keeps the compiler from leaving it out.
struct Kind {
  const char* name;
  std::vector<PosedPrimitive> primitives;
  std::vector<double> atPoint, onRay;
  double checksum = 0.0;

  void round(const std::vector<Candidate>& candidates) {
    const CliqueLevels sumsAlone;
    Stopwatch watch;
    for (int i = 0; i < kPoints; ++i) {
      checksum += static_cast<double>(sampleField(primitives, candidates, sumsAlone, spread(i)).value);
    }
    const double pointSeconds = watch.lap();
    RayField ray;
    for (int i = 0; i < kPoints; ++i) {
      ray.reset(0.25, sumsAlone);
      for (const Candidate& c : candidates) {
        ray.addPrimitive(primitives[static_cast<std::size_t>(c.primitive)], c.weight, 0, spread(i), {0.0f, 0.6f, 0.8f});
      }
      checksum += static_cast<double>(ray.terms().size());
    }
    constexpr double kEach = 1e9 / (double{kPoints} * kPrimitives);
    atPoint.push_back(pointSeconds * kEach);
    onRay.push_back(watch.lap() * kEach);
  }
};

/// The same places and points for all kinds, in turn.
std::vector<FieldCost> measureField(int rounds) {
  std::vector<Candidate> candidates;
  for (int i = 0; i < kPrimitives; ++i) candidates.push_back({i, 1.0f, 0});
  const glm::vec3 radii(0.20f, 0.22f, 0.24f);
  std::vector<Kind> kinds;
  const auto add = [&](const char* name, const glm::vec3& size, const Shape& shape) {
    kinds.push_back({name, primitivesOf(size, shape), {}, {}});
  };
  add("ellipsoid", radii, {});
  add("sphere", glm::vec3(0.22f), {});
  add("core", radii, {0.5f, 0.0f, {}});
  add("belly", radii, {0.0f, 0.3f, {}});
  add("bend", radii, {0.0f, 0.0f, {0.5f, 0.2f}});
  add("all three", radii, {0.5f, 0.3f, {0.5f, 0.2f}});
  for (int i = 0; i < rounds; ++i) {
    for (Kind& kind : kinds) kind.round(candidates);
  }
  std::vector<FieldCost> costs;
  for (const Kind& kind : kinds) {
    costs.push_back({kind.name, median(kind.atPoint), medianRatio(kind.atPoint, kinds.front().atPoint),
                     median(kind.onRay), medianRatio(kind.onRay, kinds.front().onRay)});
  }
  return costs;
}

std::string tableOf(const std::vector<FieldCost>& costs) {
  std::string table =
      "nanoseconds a primitive, medians; ratio to the ellipsoid within one round, median\n"
      "kind          value and gradient   ratio   terms along a ray   ratio\n";
  for (const FieldCost& cost : costs) {
    char row[120];
    std::snprintf(row, sizeof row, "%-13s %18.2f  %6.2f  %18.2f  %6.2f\n", cost.kind.c_str(), cost.atPoint,
                  cost.pointRatio, cost.onRay, cost.rayRatio);
    table += row;
  }
  return table;
}

}  // namespace

Result<Report> reportField(Files, const Effort& effort) { return Report{tableOf(measureField(effort.rounds))}; }

}  // namespace sinew::app
