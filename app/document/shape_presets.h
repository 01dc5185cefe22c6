// app/document/shape_presets.h: named shapes of new muscles.
#pragma once

#include "sinew/geometry/ellipsoid.h"

namespace sinew::app {

enum class ShapePreset { kEllipsoid, kCapsule, kCylinder, kEgg, kCone, kSpindle };

[[nodiscard]] const char* nameOf(ShapePreset preset);  ///< "capsule": name of a muscle with that shape.
/// The placement with that shape along its longest axis, which becomes y. An ellipsoid stays unchanged.
[[nodiscard]] Placement shaped(ShapePreset preset, const Placement& placement, float reach);

}  // namespace sinew::app
