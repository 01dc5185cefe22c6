// app/viewport/render/view.cpp: points to pixels and back; the nearest eye that sees everything.
#include "app/viewport/render/view.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>

namespace sinew::app {

glm::vec3 View::toPixel(const glm::vec3& pointInWorld) const {
  const glm::vec4 clip = clipFromWorld() * glm::vec4(pointInWorld, 1.0f);
  const glm::vec2 half = 0.5f * glm::vec2(size);
  if (clip.w <= 0.0f) {
    // Behind the eye: not mirrored, beyond the depth range.
    const float w = std::max(-clip.w, 1e-6f);
    return {half.x * (1.0f + clip.x / w), half.y * (1.0f - clip.y / w), 2.0f};
  }
  const glm::vec3 device = glm::vec3(clip) / clip.w;
  return {half.x * (1.0f + device.x), half.y * (1.0f - device.y), device.z};
}

Ray View::rayThrough(const glm::vec2& pixel) const {
  const glm::vec2 device(2.0f * pixel.x / static_cast<float>(size.x) - 1.0f,
                         1.0f - 2.0f * pixel.y / static_cast<float>(size.y));
  // From the projection's terms rather than its inverse, which is inexact for far planes.
  const glm::mat4& p = clipFromView;
  const glm::mat3 worldFromView = glm::transpose(glm::mat3(viewFromWorld));
  const glm::vec3 viewOrigin = -(worldFromView * glm::vec3(viewFromWorld[3]));
  if (orthographic) {
    const glm::vec3 near((device.x - p[3][0]) / p[0][0], (device.y - p[3][1]) / p[1][1], (-1.0f - p[3][2]) / p[2][2]);
    return {viewOrigin + worldFromView * near, -worldFromView[2]};
  }
  const glm::vec3 direction((device.x + p[2][0]) / p[0][0], (device.y + p[2][1]) / p[1][1], -1.0f);
  return {viewOrigin, glm::normalize(worldFromView * direction)};
}

float View::unitsPerPixelAt(const glm::vec3& pointInWorld) const {
  const float w = (clipFromWorld() * glm::vec4(pointInWorld, 1.0f)).w;
  return 2.0f * std::max(w, 1e-6f) / (clipFromView[1][1] * static_cast<float>(size.y));
}

glm::vec3 View::forwardInWorld() const { return -glm::vec3(glm::transpose(glm::mat3(viewFromWorld))[2]); }

glm::vec3 View::facingPoint() const {
  return orthographic ? eyeInWorld - forwardInWorld() * (1e7f / clipFromView[1][1]) : eyeInWorld;
}

// The nearest eye that sees everything.

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

glm::mat4 viewMatrix(const glm::mat3& axes, const glm::vec3& eye) {
  const glm::mat3 rotation = glm::transpose(axes);
  glm::mat4 view(rotation);
  view[3] = glm::vec4(-(rotation * eye), 1.0f);
  return view;
}

float aspectOf(const glm::ivec2& size) { return static_cast<float>(size.x) / static_cast<float>(std::max(size.y, 1)); }

/// Bounds of points along camera axes.
struct Fit {
  glm::vec2 center{0.0f};    ///< Right and up of the eye, along the axes.
  float eyeBackward = 0.0f;  ///< Position of a perspective eye.
  glm::vec2 halfExtent{0.0f};
  float nearestBackward = 0.0f, furthestBackward = 0.0f;
};

/// On each axis, the eye lies on the two planes through its view angle that are tangent to the points.
Fit fitPoints(std::span<const glm::vec3> points, const glm::mat3& axes, const glm::vec2& tangents) {
  glm::vec2 high(-kInfinity), low(kInfinity), cone(-kInfinity), coneLow(-kInfinity);
  float nearest = -kInfinity, furthest = kInfinity;
  for (const glm::vec3& point : points) {
    const glm::vec3 p = point * axes;  // Coordinates along right, up, backward.
    const glm::vec2 side(p);
    high = glm::max(high, side);
    low = glm::min(low, side);
    cone = glm::max(cone, side + tangents * p.z);
    coneLow = glm::max(coneLow, -side + tangents * p.z);
    nearest = std::max(nearest, p.z);
    furthest = std::min(furthest, p.z);
  }
  Fit fit;
  fit.center = 0.5f * (cone - coneLow);
  const glm::vec2 back = (cone + coneLow) / (2.0f * tangents);
  fit.eyeBackward = std::max(back.x, back.y);
  fit.halfExtent = 0.5f * (high - low);
  fit.nearestBackward = nearest;
  fit.furthestBackward = furthest;
  return fit;
}

glm::vec2 middle(std::span<const glm::vec3> points, const glm::mat3& axes) {
  glm::vec2 high(-kInfinity), low(kInfinity);
  for (const glm::vec3& point : points) {
    const glm::vec2 side(point * axes);
    high = glm::max(high, side);
    low = glm::min(low, side);
  }
  return 0.5f * (high + low);
}

}  // namespace

std::array<glm::vec3, 8> cornersOf(const Bounds& box) {
  std::array<glm::vec3, 8> corners{};
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = {(i & 1U) != 0 ? box.high.x : box.low.x, (i & 2U) != 0 ? box.high.y : box.low.y,
                  (i & 4U) != 0 ? box.high.z : box.low.z};
  }
  return corners;
}

std::vector<glm::vec3> evenDirections(int count) {
  std::vector<glm::vec3> directions;
  for (int i = 0; i < count; ++i) {
    const float y = 1.0f - (2.0f * static_cast<float>(i) + 1.0f) / static_cast<float>(count);
    const float angle = 2.3999632f * static_cast<float>(i);  // The golden angle.
    const float ring = std::sqrt(1.0f - y * y);
    directions.emplace_back(ring * std::cos(angle), y, ring * std::sin(angle));
  }
  return directions;
}

glm::mat3 cameraAxes(float yaw, float pitch) {
  const glm::vec3 backward(std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch));
  const glm::vec3 right(std::cos(yaw), 0.0f, -std::sin(yaw));
  return {right, glm::cross(backward, right), backward};
}

View framedView(std::span<const glm::vec3> points, float yaw, float pitch, const glm::ivec2& size, bool orthographic,
                float margin) {
  assert(margin >= 0.0f && margin <= 0.45f);
  if (points.empty()) return framedView(Bounds{}, yaw, pitch, size, orthographic, margin);
  const glm::mat3 axes = cameraAxes(yaw, pitch);
  const float aspect = aspectOf(size);
  const float room = 1.0f - 2.0f * margin;
  const glm::vec2 tangents = std::tan(0.5f * kFieldOfView) * glm::vec2(aspect, 1.0f);
  const Fit fit = fitPoints(points, axes, tangents * room);
  // A single point far from the origin still needs an extent that floats can resolve.
  const float finest = std::max(1e-3f * glm::length(points.front()), 1e-6f);
  const float span =
      std::max({fit.nearestBackward - fit.furthestBackward, 2.0f * fit.halfExtent.x, 2.0f * fit.halfExtent.y, finest});
  View view;
  view.size = size;
  view.orthographic = orthographic;
  if (orthographic) {
    const float halfHeight = std::max({fit.halfExtent.y, fit.halfExtent.x / aspect, 0.5f * finest}) / room;
    view.eyeInWorld = axes * glm::vec3(middle(points, axes), fit.nearestBackward + 8.0f * span);
    view.clipFromView =
        glm::ortho(-halfHeight * aspect, halfHeight * aspect, -halfHeight, halfHeight, 0.0f, 17.0f * span);
  } else {
    const float back = std::max(fit.eyeBackward, fit.nearestBackward + 0.05f * span);
    view.eyeInWorld = axes * glm::vec3(fit.center, back);
    const float nearPlane = std::max(0.5f * (back - fit.nearestBackward), 0.005f * span);
    view.clipFromView = glm::perspective(kFieldOfView, aspect, nearPlane, back - fit.furthestBackward + 60.0f * span);
  }
  view.viewFromWorld = viewMatrix(axes, view.eyeInWorld);
  return view;
}

View framedView(const Bounds& bounds, float yaw, float pitch, const glm::ivec2& size, bool orthographic, float margin) {
  const Bounds box = bounds.isEmpty() ? Bounds{glm::vec3(-0.5f), glm::vec3(0.5f)} : bounds;
  return framedView(cornersOf(box), yaw, pitch, size, orthographic, margin);
}

View orbitView(const glm::vec3& target, float yaw, float pitch, float distance, const glm::ivec2& size,
               bool orthographic, float reach) {
  const glm::mat3 axes = cameraAxes(yaw, pitch);
  const float aspect = aspectOf(size);
  View view;
  view.size = size;
  view.orthographic = orthographic;
  if (orthographic) {
    const float halfHeight = distance * std::tan(0.5f * kFieldOfView);
    const float behind = 10.0f * std::max(reach, distance);
    view.eyeInWorld = target + axes[2] * behind;
    view.clipFromView =
        glm::ortho(-halfHeight * aspect, halfHeight * aspect, -halfHeight, halfHeight, 0.0f, 2.0f * behind);
  } else {
    view.eyeInWorld = target + axes[2] * distance;
    const float nearPlane = std::max(0.02f * distance, 1e-4f * reach);
    view.clipFromView = glm::perspective(kFieldOfView, aspect, nearPlane, distance + 60.0f * reach);
  }
  view.viewFromWorld = viewMatrix(axes, view.eyeInWorld);
  return view;
}

std::vector<glm::vec3> extremePoints(std::span<const glm::vec3> points) {
  if (points.empty()) return {};
  std::vector<glm::vec3> extremes;
  for (const glm::vec3& direction : evenDirections(96)) {
    extremes.push_back(
        *std::ranges::max_element(points, {}, [&](const glm::vec3& p) { return glm::dot(p, direction); }));
  }
  return extremes;
}

}  // namespace sinew::app
