// core/surface/finish/crease_lift.h: heights where the pose folds the skin. docs/design.md, Creases of a pose.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "core/surface/finish/moved_triangles.h"
#include "core/surface/finish/vertex_rings.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// A posed control mesh and its refined mesh.
struct CarryingMesh {
  const ControlMesh& mesh;
  std::span<const float> perBindFront;   ///< [T] bindFrontInverses.
  std::span<const glm::vec3> positions;  ///< [V] world.
  std::span<const glm::vec3> normals;    ///< [V] unit.
  const Refinement& refinement;
  const VertexRings& rings;  ///< Of the refinement.
};

/// [T] 1 / the front (fold.h) of each control triangle in the bind pose; 0 where that is below 0.05.
[[nodiscard]] std::vector<float> bindFrontInverses(const ControlMesh& mesh);

/// Lowers muscles in the crease of a bent joint, where the bare skin is folded and hidden, and muscles would lift both
/// sides through each other. With rho the least ratio at a control vertex of the front (fold.h) of a control triangle
/// to that in the bind pose, clamped to [-1, 1] and interpolated linearly, heights are multiplied by 0.4 + 0.6
/// smoothstep(-0.3, 0.4, rho). Triangles nearly edge-on in the bind pose, with a front below 0.05, do not count.
/// Continuous in time, and the same for every detail, since it does not use refined triangles.
class CreaseLift {
 public:
  /// Works on all cores.  @param moved  of the refinement.  @param heights [V'] in and out.
  void lower(const CarryingMesh& carrying, const MovedTriangles& moved, std::span<float> heights);

 private:
  void findRho(const CarryingMesh& carrying, const MovedTriangles& moved);
  void lowerInside(const CarryingMesh& carrying, const MovedTriangles& moved, std::span<float> heights);
  void lowerEdges(const CarryingMesh& carrying, std::span<float> heights);

  std::vector<std::uint8_t> isNear_;     ///< [V] at a moved triangle.
  std::vector<float> fronts_;            ///< [T] over those of the bind pose, valid where a corner is near.
  std::vector<float> rho_;               ///< [V] of this pose; 1 where not near.
  std::vector<std::uint8_t> isLowered_;  ///< [E] at moved triangles with a corner below kLevel.
};

}  // namespace sinew
