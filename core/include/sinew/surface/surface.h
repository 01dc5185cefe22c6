// core/include/sinew/surface/surface.h: the smoothed mesh of one pose, and its report.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sinew/rig/rig.h"
#include "sinew/surface/projection_kind.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// Class of a control triangle (paper 3); in mode `swell` only by the region of influence.
enum class TriangleClass : std::uint8_t { kNormal, kStraddling, kImplicit };

/// Seconds of the last smoothing, by stage.
struct StageSeconds {
  double skin = 0.0;
  double patch = 0.0;
  double project = 0.0;
  double folds = 0.0;    ///< Removing folds.
  double normals = 0.0;  ///< Shading normals.
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
  int projected = 0;    ///< Vertices for which a root was searched.
  int unresolved = 0;   ///< Those without a root: they lie on the patch.
  int uncertified = 0;  ///< Those solved in double precision, as vectors were not accurate enough; not in --report.
  int unwrapped = 0;    ///< `replace`: control vertices under muscles that do not wrap the body; they keep the skin.
  int guarded = 0;      ///< Vertices moved again because of a folded triangle.
  int anchorFallbacks = 0;   ///< `replace`: anchors outside the implicit surface, replaced by the normal.
  double residualMax = 0.0;  ///< Largest |phi| at a root.
  StageSeconds seconds;
};

/// Refined surface in world space. Positions and normals change per pose; topology is shared and constant per detail.
struct Surface {
  std::shared_ptr<const Refinement> refinement;
  std::vector<glm::vec3> positions;       ///< [V'] world.
  std::vector<glm::vec3> normals;         ///< [V'] unit, outward, for shading.
  std::vector<glm::vec3> shadingNormals;  ///< [D] unit, of the drawn vertices; empty if nothing is creased.
  std::vector<float> displacement;        ///< [V'] signed distance from the patch, character units: along the rise
                                          ///< direction in `swell`, along the patch normal in `replace`.
  std::vector<TriangleClass> classes;     ///< [T] classes of control triangles.
  std::vector<std::uint8_t> culled;       ///< [T] 1: not projected, must not be drawn; empty: none.
  SmoothingReport report;
};

/// The normal of a drawn vertex for shading and export: the surface's, except at creases.
/// @param drawn 0 .. D-1
[[nodiscard]] inline glm::vec3 shadingNormal(const Surface& surface, std::size_t drawn) {
  if (!surface.shadingNormals.empty()) return surface.shadingNormals[drawn];
  return surface.normals[static_cast<std::size_t>(surface.refinement->drawVertex[drawn])];
}

}  // namespace sinew
