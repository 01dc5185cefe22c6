// tests/support/surface/marched_rays.cpp: steps, then halvings.
#include "tests/support/surface/marched_rays.h"

namespace sinew::test {

std::optional<double> firstChangeByMarching(const RayField& field, double end, int steps) {
  RayScratch scratch;
  const double sign = field.sample(0.0, scratch).value > 0.0 ? 1.0 : -1.0;
  double low = 0.0;
  for (int i = 1; i <= steps; ++i) {
    double high = end * i / steps;
    if (field.sample(high, scratch).value * sign <= 0.0) {
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (field.sample(middle, scratch).value * sign > 0.0 ? low : high) = middle;
      }
      return high;
    }
    low = high;
  }
  return std::nullopt;
}

}  // namespace sinew::test
