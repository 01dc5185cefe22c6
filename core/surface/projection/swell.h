// core/surface/projection/swell.h: the default mode: skin rises over the muscles along the rise direction.
// docs/design.md, Swell.
#pragma once

#include <span>

#include "core/surface/projection/projection_scratch.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/surface.h"

namespace sinew {

inline constexpr float kLeastAlong = 0.2f;  ///< Cosine of rise direction and normal below which slopes are not raised.

/// How the skin may rise in one pose.
struct RiseView {
  std::span<const glm::vec3> directions;  ///< [V'] world, unit, outward (rise_directions.h).
  std::span<const float> inverseLimits;   ///< [V'] 1/L, 0: none (rise_limits.h).
};

/// Constants of one character and rig.
struct SwellSettings {
  float iso = kDefaultIso;
  float blendWidth = 0.04f;  ///< h, world units: the most; a smaller muscle blends over its mean radius.
  ProjectionKind projection = ProjectionKind::kNewton;
  double tolerance = 1e-6;  ///< Tolerance of roots, world units.
};

/// Moves the surface's positions, which hold the patch, along the directions d to the first root of
/// f_skin(s) + F(p + s d) - T going outwards from s = 0; inwards where F(p) < 0, down to s = -r_T W at most.
/// A root beyond half the rise limit, or half of how far what the skin only touches may move it (inverseTouchLimit), is
/// drawn in below the limit (limitedRise).
/// Normals of moved vertices become the field's at the root: exact, and finer than the mesh can show
/// (shading_normals.h).
/// A vertex where F(p) = 0 is not touched. Fills displacement (s) and counts in the report.
void swell(const ControlMesh& mesh, const FieldView& field, const SwellSettings& settings, const RiseView& rise,
           Surface& surface, ProjectionScratch& scratch);

/// The same for one vertex.
void swellVertex(const CarriedVertex& vertex, const FieldView& field, const SwellSettings& settings,
                 const RiseView& rise, Surface& surface, VertexScratch& scratch);

}  // namespace sinew
