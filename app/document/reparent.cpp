// app/document/reparent.cpp: a placement in another bone's space.

#include "app/document/reparent.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sinew::app {
namespace {

/// Orthonormal, right-handed axes that follow the given ones, the longest first; `axes` are the ellipsoid's, with
/// lengths.
glm::mat3 rotationAlong(const glm::mat3& axes) {
  std::array<int, 3> order{0, 1, 2};
  std::ranges::sort(order, [&](int a, int b) { return glm::length(axes[a]) > glm::length(axes[b]); });
  glm::mat3 result(1.0f);
  const glm::vec3 first = normalizeOr(axes[order[0]], {1.0f, 0.0f, 0.0f});
  const glm::vec3 fallback = std::abs(first.x) < 0.9f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
  const glm::vec3 other = axes[order[1]] - first * glm::dot(first, axes[order[1]]);
  const glm::vec3 second = normalizeOr(other, normalizeOr(glm::cross(first, fallback), {0.0f, 1.0f, 0.0f}));
  // An ellipsoid does not know an axis from its opposite, so the third may be flipped to make this a rotation.
  const bool even = (order[1] - order[0] + 3) % 3 == 1;
  result[order[0]] = first;
  result[order[1]] = second;
  result[order[2]] = even ? glm::cross(first, second) : glm::cross(second, first);
  return result;
}

}  // namespace

Placement carriedToBone(const Placement& inFrom, const glm::mat4& fromInWorld, const glm::mat4& toInWorld) {
  const glm::mat4 toFromFrom = glm::inverse(toInWorld) * fromInWorld;
  if (!isFinite(toFromFrom)) return inFrom;
  const glm::mat3 linear(toFromFrom);
  glm::mat3 axes = linear * glm::mat3_cast(inFrom.rotation);
  for (int i = 0; i < 3; ++i) axes[i] *= inFrom.radii[i];
  Placement placement;
  placement.center = glm::vec3(toFromFrom * glm::vec4(inFrom.center, 1.0f));
  placement.rotation = glm::normalize(glm::quat_cast(rotationAlong(axes)));
  for (int i = 0; i < 3; ++i) placement.radii[i] = glm::length(axes[i]);
  const bool usable =
      isFinite(placement.center) && std::min({placement.radii.x, placement.radii.y, placement.radii.z}) > 0.0f;
  return usable ? placement : inFrom;
}

}  // namespace sinew::app
