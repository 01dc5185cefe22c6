// core/surface/patches/triangulation.h: points and small triangles that are not those of SplitTriangle.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

#include "core/surface/patches/split_triangle.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// Other inner points and triangles for a SplitTriangle, as many as it has.
struct Triangulation {
  SplitLevels levels;                                  ///< Of the split that it belongs to.
  std::vector<glm::dvec2> inside;                      ///< Barycentric (1-x-y, x, y).
  std::vector<std::array<std::uint8_t, 3>> triangles;  ///< Counter-clockwise. Empty: points and triangles are its own.

  friend bool operator==(const Triangulation&, const Triangulation&) = default;
};

struct AlignedSplits {
  std::vector<std::vector<double>> edges;  ///< [E] as Refinement::shareAt(); empty: evenly spaced.
  std::vector<Triangulation> triangles;    ///< [T] of these edges.

  friend bool operator==(const AlignedSplits&, const AlignedSplits&) = default;
};

[[nodiscard]] SplitLevels splitOf(const ControlMesh& mesh, const RefinementLevels& levels, int triangle);

/// @param edges [E] as AlignedSplits::edges; those of other levels than these are not used
[[nodiscard]] SideShares sidesOf(const ControlMesh& mesh, const RefinementLevels& levels,
                                 const std::vector<std::vector<double>>& edges, int triangle);

/// @param splits  parts of other levels than these are not used
[[nodiscard]] Refinement refine(const ControlMesh& mesh, const RefinementLevels& levels, const AlignedSplits& splits);

}  // namespace sinew
