// core/smoothing/finish/moved_triangles.h: the part of the mesh that muscles have changed in this pose.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sinew/mesh/control_mesh.h"
#include "sinew/smoothing/refinement.h"

namespace sinew {

/// What the stages after projection have to look at. Kept from pose to pose for its memory.
struct MovedTriangles {
  std::vector<int> control;          ///< Control triangles that hold a moved vertex. Ascending.
  std::vector<int> aroundControl;    ///< Those, and all that share a control vertex with one. Ascending.
  std::vector<int> refined;          ///< Refined triangles at moved vertices and at their neighbours. Ascending.
  std::vector<std::uint8_t> isNear;  ///< [V'] 1: has moved, or a neighbour has.
  std::vector<int> near;             ///< Those vertices. Ascending.
  std::vector<int> corners;          ///< The vertices of `refined`, those among them. Ascending.

  /// @param patch, positions [V'] world; a vertex has moved where they differ.
  void find(const ControlMesh& mesh, const Refinement& refinement, std::span<const glm::vec3> patch,
            std::span<const glm::vec3> positions);

 private:
  std::vector<std::uint8_t> moved_;      ///< [V']
  std::vector<std::uint8_t> movedEdge_;  ///< [E]
  std::vector<std::uint8_t> corner_;     ///< [V] of a triangle in `control`.
  std::vector<std::uint8_t> isCorner_;   ///< [V'] of a triangle in `refined`.
};

/// The n^2 refined triangles of a control triangle.
[[nodiscard]] inline std::span<const std::array<int, 3>> refinedTriangles(const Refinement& refinement, int control) {
  const auto count = static_cast<std::size_t>(refinement.depth * refinement.depth);
  return std::span(refinement.triangles).subspan(static_cast<std::size_t>(control) * count, count);
}

}  // namespace sinew
