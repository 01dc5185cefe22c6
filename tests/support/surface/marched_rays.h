// tests/support/surface/marched_rays.h: first roots along rays without any algebra.
#pragma once

#include <optional>

#include "core/surface/roots/ray_field.h"

namespace sinew::test {

/// First change of sign in [0, end] by equal steps and bisection. nullopt: none.
[[nodiscard]] std::optional<double> firstChangeByMarching(const RayField& field, double end, int steps);

}  // namespace sinew::test
