// tests/support/oracle/shape.h: the shapes of docs/design.md, formula by formula, in double.
#pragma once

#include "sinew/geometry/shape.h"
#include "tests/support/oracle/math.h"

namespace sinew::oracle {

/// nu of a shape.
double nu(const Shape& shape);
/// rho at a point of the primitive's space divided by its radii; 1 on the visible surface. @param point  where S > 0.
double rho(const Shape& shape, const Vec& point);
/// Volume of the visible body over that of the unit ball, by summing thin discs.
double volume(const Shape& shape);
/// Largest lateral distance from the axis where rho <= reach.
double widest(const Shape& shape, double reach);

}  // namespace sinew::oracle
