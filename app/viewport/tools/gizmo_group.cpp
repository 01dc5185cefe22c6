// app/viewport/tools/gizmo_group.cpp: several selected muscles on one gizmo.

#include "app/viewport/tools/gizmo_group.h"

#include <algorithm>
#include <utility>

#include "core/geometry/at.h"
#include "sinew/rig/rig_edit.h"

namespace sinew::app {
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
  const PosedRig& posed = document.posedRig(pose);
  glm::vec3 sum(0.0f);
  int count = 0;
  const auto add = [&](int index, const Placement& placement) {
    const PosedMuscle& muscle = at(posed.muscles, index);
    if (!muscle.usable) return;
    sum += glm::vec3(muscle.carrier * glm::vec4(placement.center, 1.0f));
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
  const PosedRig& posed = document.posedRig(pose);
  for (const GizmoCompanion& companion : companions) {
    const int index = findPrimitive(document.rig(), companion.primitive);
    if (!rig || index < 0) continue;
    const PosedMuscle& muscle = at(posed.muscles, index);
    if (!muscle.usable) continue;
    const Placement placement = draggedAlong(drag.effect, companion.start, muscle.carrier, document.character->height);
    rig = setPlacement(std::move(rig).value(), index, placement);
  }
  return rig;
}

}  // namespace sinew::app
