// app/viewport/tools/skin_stroke.h: from the pixels of a drag to a path on the skin.
#pragma once

#include <memory>
#include <vector>

#include "app/viewport/tools/select.h"

namespace sinew::app {

/// The skin at the moment of a press. A muscle that is being drawn lifts the skin: on the surface of each new frame the
/// same pixels would give another path, and the muscle would grow by itself.
struct SkinSnapshot {
  std::shared_ptr<const Refinement> refinement;
  std::vector<glm::vec3> positions;  ///< [V'] world.
  std::vector<glm::vec3> normals;    ///< [V'] world, unit, outward.
};

/// A path on the skin from the press towards the pointer, world space. The start is always there; it alone: a click.
struct SkinStroke {
  std::vector<SkinPoint> points;
};

/// @param surface  refined.
[[nodiscard]] SkinSnapshot snapshotOf(const Surface& surface);

/// The skin under the straight screen line from `start` to `pixel`: the cut of the skin with the plane through the eye
/// and that line, followed from triangle to triangle. It stays on one continuous piece of skin and ends under `pixel`
/// or before, where the skin ends or turns away from the eye; a fold that hides less than 2 % of H is crossed. What
/// stands in front of the skin does not end it.
/// @param start  on the snapshot's skin, in front of the eye.
[[nodiscard]] SkinStroke strokeOnSkin(const SkinSnapshot& skin, const SkinPoint& start, const View& view,
                                      const glm::vec2& pixel, float characterHeight);

}  // namespace sinew::app
