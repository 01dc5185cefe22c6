// app/bench/drawing.h: what drawing a frame takes, and what sending it to the driver.
#pragma once

#include "app/bench/scene.h"

namespace sinew::app {

/// Medians.
struct DrawCost {
  double drawSeconds = 0.0;
  double uploadSeconds = 0.0;
};

/// A clip that plays at 60 frames a second at kBenchDepth, drawn off screen at 1280x800 as `sinew render` draws, to the
/// end of every picture. Error: no context, as `sinew render` would say; or the rig is refused.
[[nodiscard]] Result<DrawCost> measureDrawing(const BenchScene& scene, int rounds);

}  // namespace sinew::app
