// app/viewport/tools/gizmo_basis.h: where a gizmo's axes stand in one frame; shared by its layout and its drags.
#pragma once

#include <array>
#include <optional>

#include "app/viewport/tools/gizmo.h"

namespace sinew::app {

/// What a handle does, taken apart. Shape: y pulls the belly, whole the bend.
enum class HandleKind { kNone, kMove, kRotate, kScale, kPole, kShape };

struct HandleParts {
  HandleKind kind = HandleKind::kNone;
  Way way = Way::kNone;  ///< Poles: their axis.
  float sign = 1.0f;     ///< Poles: which end.

  friend bool operator==(const HandleParts&, const HandleParts&) = default;
};

[[nodiscard]] HandleParts partsOf(GizmoHandle handle);
/// Inverse of partsOf; kNone if no handle has those parts.
[[nodiscard]] GizmoHandle handleOf(const HandleParts& parts);

/// Where a drag goes: what is locked, or else as its handle goes.
[[nodiscard]] Way wayOf(const GizmoDrag& drag);

/// A gizmo in one frame's pose.
struct GizmoBasis {
  glm::mat3 bone{1.0f};               ///< B.
  glm::dmat3 boneInverse{1.0};        ///< In double: a bone in meters under a scale of 0.01 loses digits otherwise.
  glm::vec3 origin{0.0f};             ///< Where the handles stand: the pivot, or the ellipsoid's center; world.
  glm::vec3 center{0.0f};             ///< The ellipsoid's, world.
  std::array<glm::vec3, 3> axes;      ///< Unit, world.
  glm::vec3 toEye{0.0f, 0.0f, 1.0f};  ///< Unit, from the origin.
  float arm = 1.0f;                   ///< World length of kGizmoArmPixels at the origin.

  [[nodiscard]] const glm::vec3& along(Way axis) const { return axes[static_cast<std::size_t>(axisOf(axis))]; }
  /// What a ring turns about: an axis, or the line of sight.
  [[nodiscard]] const glm::vec3& ringNormal(Way way) const { return isAxis(way) ? along(way) : toEye; }
};

inline constexpr float kGizmoArmPixels = 95.0f;

/// Nothing if the bone is flattened or not finite, or the origin is not in front of the eye.
[[nodiscard]] std::optional<GizmoBasis> gizmoBasis(GizmoAxes axes, const Placement& inBone,
                                                   const GizmoContext& context);

/// The basis that a drag of a handle goes by: scale and poles along the primitive's own axes; poles about its center,
/// also where the handles stand on a pivot.
[[nodiscard]] std::optional<GizmoBasis> basisOfDrag(const GizmoState& state, GizmoHandle handle,
                                                    const Placement& inBone, const GizmoContext& context);

/// Scale is always along the primitive's own axes.
[[nodiscard]] inline GizmoAxes effectiveAxes(GizmoMode mode, GizmoAxes axes) {
  return mode == GizmoMode::kScale || mode == GizmoMode::kPoles ? GizmoAxes::kPrimitive : axes;
}

/// Parameter, in units of the unit direction, of the line's point nearest to the ray; nothing if they are parallel
/// (within 2 degrees), or that point lies behind the eye.
[[nodiscard]] std::optional<float> alongLine(const glm::vec3& origin, const glm::vec3& direction, const Ray& ray);

/// Where the ray meets a plane; nothing if it grazes it (within 1 degree) or the point lies behind the eye.
[[nodiscard]] std::optional<glm::vec3> onPlane(const glm::vec3& origin, const glm::vec3& normal, const Ray& ray);

/// A pole from the center, bone space: where the visible body is widest along one of its axes.
[[nodiscard]] glm::vec3 poleInBone(const Placement& inBone, int axis, float sign);

/// Any unit vector across a unit vector.
[[nodiscard]] glm::vec3 across(const glm::vec3& direction);

}  // namespace sinew::app
