// app/viewport/tools/camera.cpp: the orbit camera.
#include "app/viewport/tools/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/geometry/potential.h"

namespace sinew::app {

namespace {

/// Sides of maximal free rectangles lie on edges of covered parts.
std::vector<float> sidesOf(std::span<const glm::vec4> covered, int axis) {
  std::vector<float> sides{0.0f, 1.0f};
  for (const glm::vec4& part : covered) {
    for (const float side : {part[axis], part[axis + 2]}) {
      if (side > 0.0f && side < 1.0f) sides.push_back(side);
    }
  }
  std::ranges::sort(sides);
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  return sides;
}

float areaOf(const glm::vec4& part) { return (part.z - part.x) * (part.w - part.y); }

bool overlap(const glm::vec4& a, const glm::vec4& b) { return a.x < b.z && b.x < a.z && a.y < b.w && b.y < a.w; }

}  // namespace

std::vector<glm::vec4> freeParts(std::span<const glm::vec4> covered) {
  const std::vector<float> across = sidesOf(covered, 0);
  const std::vector<float> down = sidesOf(covered, 1);
  std::vector<glm::vec4> parts;
  for (std::size_t left = 0; left < across.size(); ++left) {
    for (std::size_t right = left + 1; right < across.size(); ++right) {
      if (across[right] - across[left] < kLeastPart) continue;
      for (std::size_t top = 0; top < down.size(); ++top) {
        for (std::size_t bottom = top + 1; bottom < down.size(); ++bottom) {
          if (down[bottom] - down[top] < kLeastPart) continue;
          const glm::vec4 part(across[left], down[top], across[right], down[bottom]);
          if (std::ranges::none_of(covered, [&](const glm::vec4& over) { return overlap(part, over); })) {
            parts.push_back(part);
          }
        }
      }
    }
  }
  if (!parts.empty()) return parts;
  // Large panels are temporary, bars are not.
  std::vector<glm::vec4> fewer(covered.begin(), covered.end());
  fewer.erase(std::ranges::max_element(fewer, {}, areaOf));
  return freeParts(fewer);
}

namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kZoomPerStep = 0.88f;
constexpr float kFrameMargin = 1.12f;

float limitedDistance(const Camera& camera, float distance) {
  return std::clamp(distance, kNearestView * camera.characterHeight, kFarthestView * camera.characterHeight);
}

const float kHalfHeightRatio = std::tan(0.5f * kFieldOfView);  ///< Half the picture's height over the distance.

float unitsPerPixel(const Camera& camera, const glm::ivec2& size) {
  return 2.0f * camera.stand.distance * kHalfHeightRatio / static_cast<float>(std::max(size.y, 1));
}

/// Angle within (-pi, pi].
float wrapped(float angle) { return std::remainder(angle, 2.0f * kPi); }

void moveTo(Camera& camera, const CameraStand& goal, bool animated) {
  camera.transition.reset();
  if (animated) camera.transition = CameraTransition{camera.stand, goal, 0.0f};
  else camera.stand = goal;
}

/// Least distance that shows a box in a central part of the picture. @param part  fractions of width and height
float distanceToShow(const Camera& camera, const glm::vec3& halfExtent, const glm::ivec2& size, const glm::vec2& part) {
  const glm::mat3 axes = cameraAxes(camera.stand.yaw, camera.stand.pitch);
  const float aspect = static_cast<float>(std::max(size.x, 1)) / static_cast<float>(std::max(size.y, 1));
  const float tanY = kHalfHeightRatio * part.y;
  const float tanX = kHalfHeightRatio * aspect * part.x;
  float distance = 0.0f;
  for (const glm::vec3& sign : cornersOf({glm::vec3(-1.0f), glm::vec3(1.0f)})) {
    const glm::vec3 offset = sign * halfExtent;
    const float across =
        std::max(std::abs(glm::dot(offset, axes[0])) / tanX, std::abs(glm::dot(offset, axes[1])) / tanY);
    const float towards = camera.orthographic ? 0.0f : glm::dot(offset, axes[2]);
    distance = std::max(distance, across * kFrameMargin + towards);
  }
  return distance;
}

}  // namespace

void setScene(Camera& camera, const Bounds& boundsInWorld, float characterHeight) {
  camera.scene = boundsInWorld;
  camera.characterHeight = characterHeight;
}

void orbit(Camera& camera, const glm::vec2& drag, const glm::ivec2& size) {
  camera.transition.reset();
  const float radiansPerPixel = kPi / static_cast<float>(std::max(size.y, 1));
  camera.stand.yaw = wrapped(camera.stand.yaw - drag.x * radiansPerPixel);
  camera.stand.pitch = std::clamp(camera.stand.pitch + drag.y * radiansPerPixel, -0.5f * kPi, 0.5f * kPi);
}

void pan(Camera& camera, const glm::vec2& drag, const glm::ivec2& size) {
  camera.transition.reset();
  const glm::mat3 axes = cameraAxes(camera.stand.yaw, camera.stand.pitch);  // Right, up, backward.
  camera.stand.target += unitsPerPixel(camera, size) * (axes[1] * drag.y - axes[0] * drag.x);
}

void zoomToward(Camera& camera, float steps, const glm::vec2& pixel, const glm::ivec2& size,
                const std::optional<glm::vec3>& pointInWorld) {
  camera.transition.reset();
  const glm::mat3 axes = cameraAxes(camera.stand.yaw, camera.stand.pitch);  // Right, up, backward.
  const glm::vec2 middle = 0.5f * glm::vec2(size) * (1.0f + glm::vec2(1.0f, -1.0f) * camera.stand.aim);
  const glm::vec2 fromTarget = (pixel - middle) * unitsPerPixel(camera, size);
  const glm::vec3 inTargetPlane = camera.stand.target + axes[0] * fromTarget.x - axes[1] * fromTarget.y;
  const glm::vec3 fixed = pointInWorld.value_or(inTargetPlane);
  const float distance = limitedDistance(camera, camera.stand.distance * std::pow(kZoomPerStep, steps));
  // Scaling eye and target about a point keeps its pixel.
  const float factor = distance / camera.stand.distance;
  camera.stand.target = fixed + factor * (camera.stand.target - fixed);
  camera.stand.distance = distance;
}

void frameBounds(Camera& camera, const Bounds& boundsInWorld, const glm::ivec2& size, bool animated,
                 std::span<const glm::vec4> covered) {
  if (boundsInWorld.isEmpty() || !isFinite(boundsInWorld.low) || !isFinite(boundsInWorld.high)) return;
  CameraStand goal = camera.transition ? camera.transition->to : camera.stand;
  goal.target = boundsInWorld.center();
  // Single joints have no extent: show their surroundings.
  const glm::vec3 half = glm::max(0.5f * boundsInWorld.extent(), glm::vec3(0.03f * camera.characterHeight));
  Camera towards = camera;
  towards.stand = goal;
  const std::vector<glm::vec4> parts = freeParts(covered);
  const auto extentOf = [](const glm::vec4& part) { return glm::vec2(part.z - part.x, part.w - part.y); };
  const auto distanceIn = [&](const glm::vec4& part) { return distanceToShow(towards, half, size, extentOf(part)); };
  const float nearest = distanceIn(std::ranges::min(parts, {}, distanceIn));
  // The largest part among those that show it nearly as large.
  const auto roomIn = [&](const glm::vec4& part) {
    const glm::vec2 extent = extentOf(part);
    return distanceIn(part) <= nearest * kAlmostAsLarge ? extent.x * extent.y : 0.0f;
  };
  const glm::vec4 part = std::ranges::max(parts, {}, roomIn);
  goal.aim = {part.x + part.z - 1.0f, 1.0f - part.y - part.w};
  goal.distance = limitedDistance(camera, distanceIn(part));
  moveTo(camera, goal, animated);
}

void showStandardView(Camera& camera, StandardView view) {
  CameraStand goal = camera.transition ? camera.transition->to : camera.stand;
  // Yaw and pitch by StandardView.
  constexpr std::array<glm::vec2, 6> kAngles{glm::vec2(0.0f, 0.0f),       glm::vec2(kPi, 0.0f),
                                             glm::vec2(0.5f * kPi, 0.0f), glm::vec2(-0.5f * kPi, 0.0f),
                                             glm::vec2(0.0f, 0.5f * kPi), glm::vec2(0.0f, -0.5f * kPi)};
  const glm::vec2 angles = kAngles[static_cast<std::size_t>(view)];
  goal.yaw = angles.x;
  goal.pitch = angles.y;
  moveTo(camera, goal, true);
}

bool advance(Camera& camera, float deltaSeconds) {
  if (!camera.transition) return false;
  CameraTransition& move = *camera.transition;
  move.elapsed += std::max(deltaSeconds, 0.0f);
  if (move.elapsed >= kCameraTransitionSeconds) {
    camera.stand = move.to;
    camera.transition.reset();
    return false;
  }
  const float t = smoothstep(0.0f, kCameraTransitionSeconds, move.elapsed);
  camera.stand.target = glm::mix(move.from.target, move.to.target, t);
  camera.stand.distance = move.from.distance * std::pow(move.to.distance / move.from.distance, t);
  camera.stand.yaw = wrapped(move.from.yaw + t * wrapped(move.to.yaw - move.from.yaw));
  camera.stand.pitch = move.from.pitch + t * (move.to.pitch - move.from.pitch);
  camera.stand.aim = glm::mix(move.from.aim, move.to.aim, t);
  return true;
}

View viewOf(const Camera& camera, const glm::ivec2& size) {
  const CameraStand& stand = camera.stand;
  const Bounds box = camera.scene.isEmpty() ? Bounds{stand.target, stand.target} : camera.scene;
  const float sceneRadius = 0.5f * glm::length(box.extent()) + camera.characterHeight;
  const float reach = glm::length(box.center() - stand.target) + sceneRadius;
  View view = orbitView(stand.target, stand.yaw, stand.pitch, stand.distance, glm::max(size, glm::ivec2(1)),
                        camera.orthographic, reach);
  // Shifts the picture without rotating the eye, which still orbits the target.
  view.clipFromView = glm::translate(glm::mat4(1.0f), glm::vec3(stand.aim, 0.0f)) * view.clipFromView;
  return view;
}

}  // namespace sinew::app
