// app/tools/gizmo/gizmo_group.cpp: several selected muscles on one gizmo.

#include "app/tools/gizmo/gizmo_group.h"

#include <algorithm>
#include <utility>

#include "core/drivers/driven_numbers.h"
#include "core/lines/carriers.h"
#include "core/rig/rig_edit.h"

namespace sinew::app {
namespace {

/// What muscles ride in a pose.
class Carried {
 public:
  Carried(const Document& document, const Pose& pose)
      : character_(*document.character), pose_(pose), rig_(inPose(document.rig(), character_, pose, memory_)) {}

  /// nullopt if it is not attached to the character.
  [[nodiscard]] std::optional<glm::mat4> matrixOf(int index) const {
    return carrierOf(rig_, rig_.primitives[static_cast<std::size_t>(index)], character_, pose_);
  }

 private:
  Rig memory_;
  const Character& character_;
  const Pose& pose_;
  const Rig& rig_;
};

}  // namespace

const char* nameOf(GizmoPivot pivot) { return pivot == GizmoPivot::kActive ? "active" : "centroid"; }

std::vector<GizmoCompanion> companionsOf(const Document& document, int active) {
  const Rig& rig = document.rig();
  const Skeleton& skeleton = document.character->skeleton;
  std::vector<GizmoCompanion> companions;
  const std::string& leader = rig.primitives[static_cast<std::size_t>(active)].name;
  for (const PrimitiveId id : document.selection.primitives) {
    const int index = findPrimitive(rig, id);
    if (index < 0 || index == active || !isPickable(document.visibility, rig, skeleton, index)) continue;
    const Primitive& primitive = rig.primitives[static_cast<std::size_t>(index)];
    const auto isTwin = [&](const GizmoCompanion& other) {
      return primitive.mirror == rig.primitives[static_cast<std::size_t>(findPrimitive(rig, other.primitive))].name;
    };
    const bool twinMoves = primitive.mirror == leader || std::ranges::any_of(companions, isTwin);
    if (twinMoves || !skeleton.findBone(primitive.bone)) continue;
    companions.push_back({id, primitive.placement});
  }
  return companions;
}

std::optional<glm::vec3> centroidOf(const Document& document, const Pose& pose, int activeIndex,
                                    const Placement& active, const std::vector<GizmoCompanion>& companions) {
  if (companions.empty()) return std::nullopt;
  const Carried carried(document, pose);
  glm::vec3 sum(0.0f);
  int count = 0;
  const auto add = [&](int index, const Placement& placement) {
    const std::optional<glm::mat4> matrix = carried.matrixOf(index);
    if (!matrix) return;
    sum += glm::vec3(*matrix * glm::vec4(placement.center, 1.0f));
    ++count;
  };
  add(activeIndex, active);
  for (const GizmoCompanion& companion : companions) {
    const int index = findPrimitive(document.rig(), companion.primitive);
    if (index >= 0) add(index, companion.start);
  }
  if (count < 2) return std::nullopt;
  return sum / static_cast<float>(count);
}

Result<Rig> dragged(const Document& document, const Pose& pose, int active, const DragResult& drag,
                    const std::vector<GizmoCompanion>& companions) {
  Result<Rig> rig = setPlacement(document.rig(), active, drag.placement);
  if (companions.empty()) return rig;
  const Carried carried(document, pose);
  for (const GizmoCompanion& companion : companions) {
    const int index = findPrimitive(document.rig(), companion.primitive);
    if (!rig || index < 0) continue;
    const std::optional<glm::mat4> matrix = carried.matrixOf(index);
    if (!matrix) continue;
    const Placement placement = draggedAlong(drag.effect, companion.start, *matrix, document.character->height);
    rig = setPlacement(std::move(rig).value(), index, placement);
  }
  return rig;
}

}  // namespace sinew::app
