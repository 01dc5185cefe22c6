// app/viewport/tools/gizmo_shape.cpp: places on a shape, and what pulling at them makes of it.
#include "app/viewport/tools/gizmo_shape.h"

#include <algorithm>
#include <array>
#include <limits>

namespace sinew::app {
namespace {

constexpr float kBetween = 0.70710678f;  // Poles of the section lie on its axes; this is half way between two.

}  // namespace

glm::vec3 axisMiddleInBone(const Placement& inBone) {
  const glm::vec2 across = axisAt(inBone.shape, 0.0f);
  return inBone.rotation * (glm::vec3(across.x, 0.0f, across.y) * inBone.radii);
}

glm::vec3 thickestInBone(const Placement& inBone, const glm::vec3& toEye) {
  const float y = thickestAt(inBone.shape);
  const glm::vec2 axis = axisAt(inBone.shape, y);
  constexpr std::array<glm::vec2, 4> kCorners{glm::vec2(1, 1), glm::vec2(1, -1), glm::vec2(-1, 1), glm::vec2(-1, -1)};
  glm::vec3 best(0.0f);
  float nearest = -std::numeric_limits<float>::infinity();
  for (const glm::vec2& corner : kCorners) {
    const glm::vec2 section = axis + kBetween * corner;
    const glm::vec3 point = inBone.rotation * (glm::vec3(section.x, y, section.y) * inBone.radii);
    const float towards = glm::dot(point, toEye);
    if (towards <= nearest) continue;
    nearest = towards;
    best = point;
  }
  return best;
}

Placement withBelly(const Placement& start, float traveled, float reach, std::optional<float> typed) {
  Placement placement = start;
  // Without a straight part the thickest section is at y = belly: the handle stays under the pointer.
  placement.shape.belly = typed.value_or(start.shape.belly + traveled);
  placement.shape = legalShape(placement.shape, reach);
  return placement;
}

Placement withBend(const Placement& start, Way way, const glm::vec3& traveled, float reach,
                   std::optional<float> typed) {
  Placement placement = start;
  glm::vec2& bend = placement.shape.bend;
  const bool alongX = way != Way::kZ;
  const bool alongZ = way != Way::kX;
  if (typed) {
    (alongX ? bend.x : bend.y) = *typed;
  } else {
    if (alongX) bend.x += traveled.x;
    if (alongZ) bend.y += traveled.z;
  }
  placement.shape = legalShape(placement.shape, reach);
  return placement;
}

}  // namespace sinew::app
