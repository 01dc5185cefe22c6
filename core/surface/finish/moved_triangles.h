// core/surface/finish/moved_triangles.h: the part of the mesh that muscles have changed in this pose.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "sinew/surface/refinement.h"

namespace sinew {

/// What the stages after projection have to look at. Kept from pose to pose for its memory.
struct MovedTriangles {
  std::vector<std::uint8_t> isControl;  ///< [T] 1: the control triangle holds a moved vertex.
  std::vector<int> refined;             ///< Refined triangles at moved vertices and at their neighbors. Ascending.
  std::vector<std::uint8_t> isNear;     ///< [V'] 1: has moved, or a neighbor has.
  std::vector<int> near;                ///< Those vertices. Ascending.
  std::vector<int> corners;             ///< The vertices of `refined`, those among them. Ascending.

  /// @param patch, positions [V'] world; a vertex has moved where they differ.
  void find(const Refinement& refinement, std::span<const glm::vec3> patch, std::span<const glm::vec3> positions);

 private:
  std::vector<std::uint8_t> isMoved_;   ///< [V']
  std::vector<std::uint8_t> isCorner_;  ///< [V'] of a triangle in `refined`.
};

}  // namespace sinew
