// app/viewport/tools/gizmo_group.h: several selected muscles on one gizmo.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/document/document.h"
#include "app/viewport/tools/gizmo.h"
#include "sinew/character/pose.h"

namespace sinew::app {

enum class GizmoPivot { kActive, kCentroid };

[[nodiscard]] const char* nameOf(GizmoPivot pivot);  ///< "active", "centroid"

/// A muscle that is dragged along with the active one.
struct GizmoCompanion {
  PrimitiveId primitive;
  Placement start;
};

/// The other selected muscles that a drag of `active` (a rig index) moves: attached, neither hidden nor locked, in
/// order of picking. Of linked twins only one is among them, for the other follows: that on the active one's side of
/// its own pair is the active itself, of other pairs the one that was picked first.
[[nodiscard]] std::vector<GizmoCompanion> companionsOf(const Document& document, int active);

/// Mean of the centers of the active muscle and its companions, in a pose; nothing if there are none.
/// @param active  its bone and placement
[[nodiscard]] std::optional<glm::vec3> centroidOf(const Document& document, const Pose& pose, int activeIndex,
                                                  const Placement& active,
                                                  const std::vector<GizmoCompanion>& companions);

/// The rig with the active muscle placed, and its companions dragged along. Error: a placement is refused.
[[nodiscard]] Result<Rig> dragged(const Document& document, const Pose& pose, int active, const DragResult& drag,
                                  const std::vector<GizmoCompanion>& companions);

}  // namespace sinew::app
