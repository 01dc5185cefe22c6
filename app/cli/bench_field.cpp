// app/cli/bench_field.cpp: the same sums over spheres and over ellipsoids of the same size.
#include "app/cli/bench_field.h"

#include <cmath>
#include <cstdio>
#include <vector>

#include "app/cli/measuring.h"
#include "core/blending/field.h"
#include "core/smoothing/roots/ray_field.h"

namespace sinew::app {
namespace {

constexpr int kPrimitives = 40;
constexpr int kPoints = 20'000;

/// A point of the unit cube; evenly spread, the same on every machine.
glm::vec3 spread(int i) {
  const auto part = [i](double step) { return static_cast<float>(std::fmod(0.5 + step * i, 1.0)); };
  return {part(0.8191725133961645), part(0.6710436067037893), part(0.5497004779019703)};
}

std::vector<PosedPrimitive> primitivesOf(const glm::vec3& radii) {
  std::vector<FieldPrimitive> primitives(kPrimitives);
  for (int i = 0; i < kPrimitives; ++i) primitives[static_cast<std::size_t>(i)].placement = {spread(i), {}, radii};
  std::vector<PosedPrimitive> posed;
  poseField(primitives, std::vector{glm::mat4(1.0f)}, posed);
  return posed;
}

/// One kind's work; `checksum` keeps the compiler from leaving it out.
struct Kind {
  std::vector<PosedPrimitive> primitives;
  std::vector<double> atPoint, onRay;
  double checksum = 0.0;

  void round(const std::vector<Candidate>& candidates) {
    const CliqueLists sumsAlone;
    const double start = secondsNow();
    for (int i = 0; i < kPoints; ++i) {
      checksum += static_cast<double>(sampleField(primitives, candidates, sumsAlone, spread(i)).value);
    }
    const double middle = secondsNow();
    RayField ray;
    for (int i = 0; i < kPoints; ++i) {
      ray.reset(0.25, sumsAlone);
      for (const Candidate& c : candidates) {
        ray.addPrimitive(primitives[static_cast<std::size_t>(c.primitive)], c.weight, 0, spread(i), {0.0f, 0.6f, 0.8f});
      }
      checksum += static_cast<double>(ray.terms().size());
    }
    constexpr double kEach = 1e9 / (double{kPoints} * kPrimitives);
    atPoint.push_back((middle - start) * kEach);
    onRay.push_back((secondsNow() - middle) * kEach);
  }
};

}  // namespace

FieldCosts measureField(int rounds) {
  std::vector<Candidate> candidates;
  for (int i = 0; i < kPrimitives; ++i) candidates.push_back({i, 1.0f, 0});
  Kind ellipsoids{primitivesOf({0.20f, 0.22f, 0.24f}), {}, {}};
  Kind spheres{primitivesOf(glm::vec3(0.22f)), {}, {}};
  for (int i = 0; i < rounds; ++i) {
    ellipsoids.round(candidates);
    spheres.round(candidates);
  }
  return {median(ellipsoids.atPoint), median(spheres.atPoint), medianRatio(spheres.atPoint, ellipsoids.atPoint),
          median(ellipsoids.onRay),   median(spheres.onRay),   medianRatio(spheres.onRay, ellipsoids.onRay)};
}

std::string fieldTable(const FieldCosts& costs) {
  char text[400];
  std::snprintf(text, sizeof text,
                "nanoseconds a primitive, medians; sphere / ellipsoid within one round, median\n"
                "                       ellipsoid    sphere   ratio\n"
                "value and gradient      %8.2f  %8.2f  %6.2f\n"
                "quadratic along a ray   %8.2f  %8.2f  %6.2f\n",
                costs.ellipsoidAtPoint, costs.sphereAtPoint, costs.pointRatio, costs.ellipsoidOnRay, costs.sphereOnRay,
                costs.rayRatio);
  return text;
}

}  // namespace sinew::app
