// tests/support/oracle/heights.h: heights that remain before folds are searched. Written from docs/design.md, "Creases
// of a pose", "Slopes" and "Sampling". It shares no code with the smoothing.
#pragma once

#include <vector>

#include "sinew/surface/refinement.h"
#include "tests/support/oracle/triangles.h"

namespace sinew::oracle {

/// Positions and normals of a patch.
struct PatchOf {
  const std::vector<Vec>& positions;
  const std::vector<Vec>& normals;
};

/// Lowers heights in a pose's creases, and limits their slope to 1.5 along any path.
/// @param raw [V'] as projected
[[nodiscard]] std::vector<double> boundHeights(const ControlMesh& mesh, const Refinement& refinement,
                                               const PatchOf& bind, const PatchOf& patch,
                                               const std::vector<float>& raw);

/// How far each vertex's height is from what edges can follow, 0..1, and at least that of each neighbor.
struct Sampling {
  std::vector<double> weights;
  std::vector<double> heights;  ///< Filtered.
};

[[nodiscard]] Sampling filterHeights(const Triangles& triangles, const std::vector<Vec>& patch,
                                     const std::vector<double>& start);

}  // namespace sinew::oracle
