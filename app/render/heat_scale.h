#pragma once  // app/render/heat_scale.h: colours of the displacement heat map; panels draw their legend with them.

#include <array>

#include "core/base/geometry.h"

namespace sinew::app {

/// Stops of the scale, evenly spaced from -1 (pushed in by the range) over 0 (untouched) to +1 (lifted by it). sRGB
/// 0..1; interpolated linearly as they stand.
[[nodiscard]] const std::array<glm::vec3, 9>& heatStops();

/// sRGB colour at x; x is clamped to -1..1.
[[nodiscard]] glm::vec3 heatColor(float x);

}  // namespace sinew::app
