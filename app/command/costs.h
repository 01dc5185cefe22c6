// app/command/costs.h: what muscles add to a frame, how that grows with vertices and with muscles, and what drawing
// takes.
#pragma once

#include "app/command/scene.h"
#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

// Any number of muscles over the whole body, always as many at a place.

/// `muscles` balls spread evenly over the bound skin, each half under it and of such a radius that kEvenOverlap of them
/// reach a place of the skin whatever their number: what is left to compare is the search for those. Each rides the
/// bone that its skin follows most; one group, no territories of its own. The character has a triangle with an area.
[[nodiscard]] Rig evenRig(const Character& character, int muscles);

inline constexpr float kEvenOverlap = 5.0f;

/// At kBenchDepth, of a clip that plays at 60 frames a second. Medians of frames of the same moment in the same round.
struct MuscleCost {
  double withOverWithout = 0.0;       ///< A frame over the frame of the same rig without any muscle: the floor.
  double nsPerProjectedVertex = 0.0;  ///< What a frame takes over the floor, by vertices a root is sought for.
  double nsPerVertexFloor = 0.0;      ///< The floor by refined vertices.
  double frameSeconds = 0.0;          ///< Median of the frames with muscles.
};

/// Error: the rig is refused.
[[nodiscard]] Result<MuscleCost> measureMuscleCost(const BenchScene& scene, int rounds);

/// p of seconds = c vertices^p, of whole frames at depths 2 to 12, or as far as there are at most 400,000 vertices, but
/// 4 at least. Error: the rig is refused.
[[nodiscard]] Result<double> exponentOfVertices(const BenchScene& scene, int rounds);

/// p of seconds over the floor for each projected vertex = c muscles^p, of 41, 400 and 4,000 muscles (even_rig.h) in
/// the scene's mode, at kBenchDepth. Error: the character has no skin to lay muscles in.
[[nodiscard]] Result<double> exponentOfPrimitives(const BenchScene& scene, int rounds);

/// Medians.
struct DrawCost {
  double drawSeconds = 0.0;
  double uploadSeconds = 0.0;
};

/// A clip that plays at 60 frames a second at kBenchDepth, drawn off screen at 1280x800 as `sinew render` draws, to the
/// end of every picture. Error: no context, as `sinew render` would say; or the rig is refused.
[[nodiscard]] Result<DrawCost> measureDrawing(const BenchScene& scene, int rounds);

}  // namespace sinew::app
