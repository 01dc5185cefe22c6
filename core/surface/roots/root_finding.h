// core/surface/roots/root_finding.h: the first root of phi along a ray, by three methods.
// docs/design.md, Projection; paper 4.
#pragma once

#include <optional>

#include "core/surface/roots/ray_field.h"
#include "sinew/surface/projection_kind.h"

namespace sinew {

/// First t in [begin, end] where phi, taken to be positive at `begin` (or not), changes to the other sign; a touch does
/// not count, and phi(begin) = 0 gives `begin`. nullopt: it keeps its sign. Methods agree to `tolerance` where the root
/// is unique:
/// - newton: phi is a quartic in Bernstein form between breakpoints, or of degree 6, 8 or 10 with shaped primitives;
///   roots are isolated by its sign changes (Descartes' rule), then found by Newton steps kept inside the bracket;
/// - analytic (paper 4.1): the same quartics, roots in closed form (Ferrari), the first taken; above degree 4 as
/// newton;
/// - bisection (paper 4.2): the same brackets, each around one root, then 8 halvings and one secant step.
///   The paper halves [anchor, vertex] as it is; in a tangle that misses the first root, or a close pair of roots.
/// The sign is the caller's to know: where phi is all but 0, rounding would decide it anew, and differently.
/// @param tolerance world units, > 0.
[[nodiscard]] std::optional<double> firstChange(const RayField& field, double begin, double end, bool fromPositive,
                                                ProjectionKind method, double tolerance, RayScratch& scratch);

}  // namespace sinew
