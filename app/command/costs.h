// app/command/costs.h: cost of muscles, its growth with vertices and muscles, and the cost of drawing.
#pragma once

#include "app/command/measuring.h"
#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

/// `muscles` balls spread evenly over the bound skin, each half below it, with a radius such that kEvenOverlap of them
/// reach any point of the skin: rigs with different numbers differ in the search for those only. Each ball is attached
/// to the bone that its skin follows most; one group, no territories. The character has a triangle with an area.
[[nodiscard]] Rig evenRig(const Character& character, int muscles);

inline constexpr float kEvenOverlap = 5.0f;

/// At kBenchDepth, for a clip played at 60 frames per second. Medians over frames of the same moment and round.
struct MuscleCost {
  double withOverWithout = 0.0;       ///< A frame over the floor: a frame of the same rig without muscles.
  double nsPerProjectedVertex = 0.0;  ///< Time above the floor per vertex with a root search.
  double nsPerVertexFloor = 0.0;      ///< The floor per refined vertex.
  double frameSeconds = 0.0;          ///< Median of the frames with muscles.
};

[[nodiscard]] Result<MuscleCost> measureMuscleCost(const BenchScene& scene, int rounds);  ///< Error: rig refused.

/// p of seconds = c vertices^p for frames at depths 2..4, and 5..12 up to 200,000 vertices. Error: the rig is refused.
[[nodiscard]] Result<double> exponentOfVertices(const BenchScene& scene, int rounds);

/// p of seconds above the floor per projected vertex = c muscles^p for 41, 400 and 4,000 muscles (evenRig) in the
/// scene's mode, at kBenchDepth. Error: the character has no skin for muscles.
[[nodiscard]] Result<double> exponentOfPrimitives(const BenchScene& scene, int rounds);

/// Medians.
struct DrawCost {
  double drawSeconds = 0.0;
  double uploadSeconds = 0.0;
};

/// A clip played at 60 frames per second at kBenchDepth, drawn off screen at 1280x800 as by `sinew render`, each
/// picture finished. Error: no context, or the rig is refused.
[[nodiscard]] Result<DrawCost> measureDrawing(const BenchScene& scene, int rounds);

}  // namespace sinew::app
