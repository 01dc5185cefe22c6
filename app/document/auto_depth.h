// app/document/auto_depth.h: the refinement depth, or the tolerance, that a character's size on screen asks for
// (paper 5).
#pragma once

#include "sinew/geometry/control_mesh.h"

namespace sinew {

/// Deepest that is chosen without being asked: beyond it the paper (5) saw, and we see, no gain.
inline constexpr int kMaxAutoDepth = 8;

/// Pixels that an edge of the refined mesh should have on screen.
inline constexpr float kAutoEdgePixels = 8.0f;

/// Mean length of the control mesh's edges in the bind pose as a fraction of its height. Once a character.
[[nodiscard]] float meanEdgeFraction(const ControlMesh& mesh, float height);

/// Depth at which a mean edge has about kAutoEdgePixels on screen: 1..kMaxAutoDepth. `current` stands until the ideal
/// depth is more than 3/4 of a step away from it, so that a camera at rest on a border, or breathing about it, does not
/// flicker.
/// @param heightPixels the character's height H as seen, pixels.  @param current depth now in use, or 0 for none.
[[nodiscard]] int autoDepth(float meanEdgeFraction, float heightPixels, int current);

/// Pixels by which a flat triangle of adaptive detail may lie off the surface.
inline constexpr float kAutoErrorPixels = 0.5f;

/// The tolerance of adaptive detail at which that holds: a power of the square root of 2 within kLeastTolerance ..
/// kMostTolerance, so that few different meshes are made while a camera moves; `current` stands as above.
/// @param current  tolerance now in use, or 0 for none.
[[nodiscard]] float autoTolerance(float heightPixels, float current);

}  // namespace sinew
