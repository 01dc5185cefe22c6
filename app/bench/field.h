// app/bench/field.h: what one evaluation of the field costs, kind by kind.
#pragma once

#include <string>
#include <vector>

namespace sinew::app {

/// Nanoseconds a primitive and point or ray, medians of the rounds; ratios to the ellipsoid of one round, median.
struct FieldCost {
  std::string kind;
  double atPoint = 0.0;
  double pointRatio = 1.0;
  double onRay = 0.0;
  double rayRatio = 1.0;
};

/// The same 40 places and 20,000 points for all kinds, in turn; a ray is met by a primitive when it becomes terms along
/// it (core/smoothing/roots/ray_field.h). The ellipsoid comes first.
[[nodiscard]] std::vector<FieldCost> measureField(int rounds);

[[nodiscard]] std::string fieldTable(const std::vector<FieldCost>& costs);

}  // namespace sinew::app
