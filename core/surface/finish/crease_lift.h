// core/surface/finish/crease_lift.h: heights where the pose folds the skin itself. docs/design.md, Creases of a pose.
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

/// A control mesh in its pose, and the refined mesh that it carries.
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

/// Lowers muscles in the crease of a bent joint. There the bare skin is folded and hidden, and muscles that lifted both
/// banks would lift them through each other. With rho the least front of the control triangles at a control vertex over
/// that in the bind pose (fold.h), at most 1, at least -1 and linear in between, heights fall to
/// 0.4 + 0.6 smoothstep(-0.3, 0.4, rho) of themselves. Triangles that are all but edge-on in the bind pose, front below
/// 0.05, have no say. Continuous in time; the same at every detail, since refined triangles are not looked at.
class CreaseLift {
 public:
  /// @param moved  of the refinement.  @param heights [V'] in and out.  On all cores.
  void lower(const CarryingMesh& carrying, const MovedTriangles& moved, std::span<float> heights);

 private:
  void findRho(const CarryingMesh& carrying, const MovedTriangles& moved);
  void lowerInside(const CarryingMesh& carrying, const MovedTriangles& moved, std::span<float> heights);
  void lowerEdges(const CarryingMesh& carrying, std::span<float> heights);

  std::vector<std::uint8_t> isNear_;     ///< [V] at a moved triangle.
  std::vector<float> fronts_;            ///< [T] over those of the bind pose, where a corner is near; else not read.
  std::vector<float> rho_;               ///< [V] of this pose; 1 where not near.
  std::vector<std::uint8_t> isLowered_;  ///< [E] of moved triangles with a corner below kLevel.
};

}  // namespace sinew
