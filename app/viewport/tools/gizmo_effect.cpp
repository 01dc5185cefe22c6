// app/viewport/tools/gizmo_effect.cpp: what a drag does in the world, applied to a placement on a bone.
#include "app/viewport/tools/gizmo_effect.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "core/geometry/normals.h"

namespace sinew::app {

Placement moved(const GizmoEffect& effect, const Placement& start, const glm::dmat3& boneInverse) {
  Placement placement = start;
  placement.center = glm::vec3(glm::dvec3(start.center) + boneInverse * glm::dvec3(effect.moved));
  return placement;
}

Placement turned(const GizmoEffect& effect, const Placement& start, const glm::dmat3& boneInverse,
                 const glm::vec3* center) {
  if (effect.angle == 0.0f) return start;
  const glm::vec3 axisInBone = normalizeOr(glm::vec3(boneInverse * glm::dvec3(effect.turnAxis)), effect.turnAxis);
  const float inBone = glm::determinant(boneInverse) < 0.0 ? -effect.angle : effect.angle;
  Placement placement = start;
  placement.rotation = glm::normalize(glm::angleAxis(inBone, axisInBone) * start.rotation);
  if (center) {
    const glm::dvec3 arm = glm::dvec3(*center) - glm::dvec3(effect.pivot);
    const glm::dvec3 swung = glm::angleAxis(static_cast<double>(effect.angle), glm::dvec3(effect.turnAxis)) * arm;
    placement.center = glm::vec3(glm::dvec3(start.center) + boneInverse * (swung - arm));
  }
  return placement;
}

float worldPerUnit(const glm::mat3& bone, const Placement& start, int axis) {
  glm::vec3 unit(0.0f);
  unit[axis] = 1.0f;
  return glm::length(bone * (start.rotation * unit));
}

Placement scaled(const GizmoEffect& effect, const Placement& start, const glm::mat3& bone, float characterHeight) {
  Placement placement = start;
  for (int axis = 0; axis < 3; ++axis) {
    if (effect.factors[axis] == 1.0f) continue;
    const float least = kLeastRadius * characterHeight / worldPerUnit(bone, start, axis);
    placement.radii[axis] = std::max(start.radii[axis] * effect.factors[axis], std::min(least, start.radii[axis]));
  }
  return placement;
}

Placement draggedAlong(const GizmoEffect& effect, const Placement& start, const glm::mat4& boneInWorld,
                       float characterHeight) {
  const glm::dmat3 bone{glm::mat3(boneInWorld)};
  if (!isFinite(boneInWorld) || isFlat(bone)) return start;
  const glm::dmat3 inverse = glm::inverse(bone);
  const glm::vec3 center(boneInWorld * glm::vec4(start.center, 1.0f));
  Placement placement = turned(effect, start, inverse, &center);
  placement.center += moved(effect, start, inverse).center - start.center;
  placement.radii = scaled(effect, start, glm::mat3(boneInWorld), characterHeight).radii;
  return placement;
}

}  // namespace sinew::app
