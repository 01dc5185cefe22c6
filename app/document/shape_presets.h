// app/document/shape_presets.h: shapes with a name, to begin with.
#pragma once

#include "sinew/geometry/ellipsoid.h"

namespace sinew::app {

enum class ShapePreset { kEllipsoid, kCapsule, kCylinder, kEgg, kCone, kSpindle };

/// "capsule": what a muscle of it is called.
[[nodiscard]] const char* nameOf(ShapePreset preset);
/// The placement with that shape along its longest axis, which becomes y; an ellipsoid stays as it is.
[[nodiscard]] Placement shaped(ShapePreset preset, const Placement& placement, float reach);

}  // namespace sinew::app
