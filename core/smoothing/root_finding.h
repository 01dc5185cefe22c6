#pragma once  // core/smoothing/root_finding.h: the first root of phi along a ray, by three methods. docs/design.md,
              // paper 4.

#include <optional>

#include "core/rig/rig.h"
#include "core/smoothing/ray_field.h"

namespace sinew {

/// First t in [0, end] where phi changes to the other sign than it has at 0 (a touch does not count; phi(0) = 0 gives
/// 0). nullopt: phi keeps its sign. Methods agree to `tolerance` where the root is unique:
/// - newton: phi is a quartic in Bernstein form between breakpoints; roots are isolated by its sign changes
///   (Descartes' rule), then found by Newton steps kept inside the bracket;
/// - analytic (paper 4.1): the same quartics, roots in closed form (Ferrari), the first taken;
/// - bisection (paper 4.2): the same brackets, each around one root, then 8 halvings and one secant step.
///   The paper halves [anchor, vertex] as it is; in a tangle that misses the first root, or a close pair of roots.
/// @param tolerance world units, > 0.
[[nodiscard]] std::optional<double> firstRoot(const RayField& field, double end, ProjectionKind method,
                                              double tolerance);

/// The same from `begin`, where phi is known to be positive (or not): the first t in [begin, end] where that ends.
[[nodiscard]] std::optional<double> firstChange(const RayField& field, double begin, double end, bool fromPositive,
                                                ProjectionKind method, double tolerance);

}  // namespace sinew
