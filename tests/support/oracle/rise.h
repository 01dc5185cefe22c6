// tests/support/oracle/rise.h: rise directions and limits of the bind pose, in double (docs/design.md).
#pragma once

#include <vector>

#include "sinew/geometry/control_mesh.h"
#include "tests/support/oracle/math.h"

namespace sinew::oracle {

/// Vertex normals averaged along the edges on which they converge, at most 60 degrees off the normal.
/// @param rise  world units that an edge should allow.  @return [V] unit.
std::vector<Vec> relaxedDirections(const ControlMesh& mesh, double rise);

/// How far skin can rise along its directions before it meets other skin: 1/L of every vertex, 0 for none.
/// @param most  world units: limits fade out from here to one and a half times this.
std::vector<double> inverseLimits(const ControlMesh& mesh, const std::vector<Vec>& directions, double most);

/// The least of s + psi(s) / sigma up to a root, as far as parts of the way show it.
double heightBelowOverhangs(double root, double sigma, double part, const Function& psi, const Function& slope);

/// A height as the limit lets it stand.
double heightWithin(double height, double inverseLimit);

}  // namespace sinew::oracle
