#pragma once  // core/smoothing/swell.h: the default mode: skin rises over the muscles along the patch normal.
              // docs/design.md.

#include "core/mesh/control_mesh.h"
#include "core/rig/rig.h"
#include "core/smoothing/carrier_walk.h"
#include "core/smoothing/surface.h"

namespace sinew {

/// Constants of one character and rig.
struct SwellSettings {
  float iso = kDefaultIso;
  float blendWidth = 0.04f;  ///< h, world units.
  ProjectionKind projection = ProjectionKind::kNewton;
  double tolerance = 1e-6;   ///< Of roots, world units.
};

/// Moves the surface's positions and normals, which hold the patch, to the first root of
/// f_skin(s) + F(p + s n) - T going outwards from s = 0; inwards where F(p) < 0, down to s = -r_T W at most.
/// A vertex where F(p) = 0 is not touched. Fills displacement and counts in the report.
void swell(const ControlMesh& mesh, const FieldView& field, const SwellSettings& settings, Surface& surface);

}  // namespace sinew
