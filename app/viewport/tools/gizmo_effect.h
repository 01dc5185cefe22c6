// app/viewport/tools/gizmo_effect.h: what a drag does in the world, applied to a placement on a bone.
#pragma once

#include "app/viewport/tools/gizmo.h"

namespace sinew::app {

inline constexpr float kLeastRadius = 0.002f;  ///< Fraction of H, in the world.

[[nodiscard]] Placement moved(const GizmoEffect& effect, const Placement& start, const glm::dmat3& boneInverse);
/// @param center  world, if it goes round the pivot; null: it is the pivot.
[[nodiscard]] Placement turned(const GizmoEffect& effect, const Placement& start, const glm::dmat3& boneInverse,
                               const glm::vec3* center);
[[nodiscard]] Placement scaled(const GizmoEffect& effect, const Placement& start, const glm::mat3& bone,
                               float characterHeight);

/// World length of one bone unit along the primitive's axis.
[[nodiscard]] float worldPerUnit(const glm::mat3& bone, const Placement& start, int axis);

}  // namespace sinew::app
