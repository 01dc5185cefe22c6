// app/viewport/tools/gizmo_tools.h: several selected muscles on one gizmo.
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

/// Another muscle dragged along with the active one.
struct GizmoCompanion {
  PrimitiveId primitive;
  Placement start;
};

/// The other selected muscles that a drag of `active` (a rig index) moves: attached, neither hidden nor locked, in the
/// order of selection. Only the active or first selected one of linked twins, since the other follows.
[[nodiscard]] std::vector<GizmoCompanion> companionsOf(const Document& document, int active);

/// Mean of the centers of the active muscle and its companions in a pose; nullopt without companions.
[[nodiscard]] std::optional<glm::vec3> centroidOf(const Document& document, const Pose& pose, int activeIndex,
                                                  const Placement& active,
                                                  const std::vector<GizmoCompanion>& companions);

/// The rig after a drag of the active muscle and its companions. Error: a placement is refused.
[[nodiscard]] Result<Rig> dragged(const Document& document, const Pose& pose, int active, const DragResult& drag,
                                  const std::vector<GizmoCompanion>& companions);

}  // namespace sinew::app
