// core/include/sinew/surface/surface.h: the smoothed mesh of one pose, and the report on it.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sinew/rig/rig.h"
#include "sinew/surface/projection_kind.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// Class of a control triangle (paper 3). In `swell`, which does not use classes, by the region of influence.
enum class TriangleClass : std::uint8_t { kNormal, kStraddling, kImplicit };

/// Seconds of the last smoothing, by stage.
struct StageSeconds {
  double skin = 0.0;
  double patch = 0.0;
  double project = 0.0;
  double folds = 0.0;    ///< Folds found and removed.
  double normals = 0.0;  ///< Shading normals made.
  [[nodiscard]] double total() const { return skin + patch + project + folds + normals; }
};

/// Counts and measures of the last smoothing. Keys of --report (docs/formats.md).
struct SmoothingReport {
  SurfaceMode mode = SurfaceMode::kSwell;
  PatchKind patch = PatchKind::kPn;
  ProjectionKind projection = ProjectionKind::kNewton;
  int depth = 1;
  int controlTriangles = 0;
  int refinedTriangles = 0;
  int refinedVertices = 0;
  int implicitTriangles = 0;
  int straddlingTriangles = 0;
  int normalTriangles = 0;
  int culledTriangles = 0;  ///< Control triangles; 0 without an eye.
  int primitives = 0;       ///< Attached and not hidden.
  int cliques = 0;
  int projected = 0;    ///< Vertices for which a root was sought.
  int unresolved = 0;   ///< ... and not found: they lie on the patch.
  int uncertified = 0;  ///< ... in double precision, since vector code could not certify the first; not in --report.
  int unwrapped = 0;    ///< `replace`: control vertices under muscles that do not wrap the body: they keep the skin.
  int guarded = 0;      ///< Vertices moved again because a triangle had folded (fold_spread.h).
  int anchorFallbacks = 0;   ///< `replace`: anchors outside the implicit surface, replaced by the normal.
  double residualMax = 0.0;  ///< Largest |phi| at the found roots.
  StageSeconds seconds;
};

/// Refined surface in world space. Positions and normals change per pose; topology is shared and constant per detail.
struct Surface {
  std::shared_ptr<const Refinement> refinement;
  std::vector<glm::vec3> positions;       ///< [V'] world.
  std::vector<glm::vec3> normals;         ///< [V'] unit, outward, for shading (shading_normals.h).
  std::vector<glm::vec3> shadingNormals;  ///< [D] unit, of the drawn vertices; empty where nothing is creased.
  std::vector<float> displacement;     ///< [V'] signed distance from the patch, character units: in `swell` along the
                                       ///< rise direction, in `replace` along the patch normal.
  std::vector<TriangleClass> classes;  ///< [T] of the control triangles.
  SmoothingReport report;
};

/// The normal of a drawn vertex (0 .. D-1) for shading and export: the surface's own, except at creases.
[[nodiscard]] inline glm::vec3 shadingNormal(const Surface& surface, std::size_t drawn) {
  if (!surface.shadingNormals.empty()) return surface.shadingNormals[drawn];
  return surface.normals[static_cast<std::size_t>(surface.refinement->drawVertex[drawn])];
}

}  // namespace sinew
