// app/cli/bench_field.h: what one evaluation of the field costs, spheres beside ellipsoids.
#pragma once

#include <string>

namespace sinew::app {

/// Nanoseconds a primitive and point or ray, medians of the rounds; ratios of one round, median.
struct FieldCosts {
  double ellipsoidAtPoint = 0.0;
  double sphereAtPoint = 0.0;
  double pointRatio = 1.0;  ///< Sphere over ellipsoid.
  double ellipsoidOnRay = 0.0;
  double sphereOnRay = 0.0;
  double rayRatio = 1.0;
};

/// The same 40 places and 20,000 points for both kinds, in turn; a ray is met by a primitive when it becomes a
/// quadratic along it (core/smoothing/roots/ray_field.h).
[[nodiscard]] FieldCosts measureField(int rounds);

[[nodiscard]] std::string fieldTable(const FieldCosts& costs);

}  // namespace sinew::app
