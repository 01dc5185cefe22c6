// app/document/shape_presets.h: named shapes of new muscles.
#pragma once

#include "sinew/geometry/ellipsoid.h"

namespace sinew::app {

enum class ShapePreset { kEllipsoid, kCapsule, kCylinder, kEgg, kCone, kSpindle };

/// "capsule": name of a muscle with that shape.
[[nodiscard]] const char* nameOf(ShapePreset preset);
/// The placement with that shape along its longest axis, which becomes y. An ellipsoid stays unchanged.
[[nodiscard]] Placement shaped(ShapePreset preset, const Placement& placement, float reach);

}  // namespace sinew::app
