// core/surface/patches/triangulation.h: small triangles of a control triangle with diagonals of their own.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/surface/patches/split_triangle.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// Other triangles between the points of a SplitTriangle, as many as it has.
struct Triangulation {
  SplitLevels levels;                                  ///< Of the split that it belongs to.
  std::vector<std::array<std::uint8_t, 3>> triangles;  ///< Counter-clockwise. Empty: those of SplitTriangle.

  friend bool operator==(const Triangulation&, const Triangulation&) = default;
};

[[nodiscard]] SplitLevels splitOf(const ControlMesh& mesh, const RefinementLevels& levels, int triangle);

/// @param triangulations [T]; those of other levels than the triangle's are not used
[[nodiscard]] Refinement refine(const ControlMesh& mesh, const RefinementLevels& levels,
                                std::span<const Triangulation> triangulations);

}  // namespace sinew
