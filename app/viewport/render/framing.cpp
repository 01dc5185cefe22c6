// app/viewport/render/framing.cpp: the nearest eye that sees everything.
#include "app/viewport/render/framing.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>

namespace sinew::app {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

glm::mat4 viewMatrix(const glm::mat3& axes, const glm::vec3& eye) {
  const glm::mat3 rotation = glm::transpose(axes);
  glm::mat4 view(rotation);
  view[3] = glm::vec4(-(rotation * eye), 1.0f);
  return view;
}

float aspectOf(const glm::ivec2& size) { return static_cast<float>(size.x) / static_cast<float>(std::max(size.y, 1)); }

std::array<glm::vec3, 8> cornersOf(const Bounds& box) {
  std::array<glm::vec3, 8> corners{};
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = {(i & 1U) != 0 ? box.high.x : box.low.x, (i & 2U) != 0 ? box.high.y : box.low.y,
                  (i & 4U) != 0 ? box.high.z : box.low.z};
  }
  return corners;
}

/// Sight along `axes`: for each side of the picture, how far the points press against it.
struct Fit {
  glm::vec2 center{0.0f};    ///< Right and up of the eye, along the axes.
  float eyeBackward = 0.0f;  ///< Place of a perspective eye, along the axes.
  glm::vec2 halfExtent{0.0f};
  float nearestBackward = 0.0f, furthestBackward = 0.0f;
};

/// The eye touches, on each axis, the two planes through its view angle that the points press hardest against.
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
  // A single point far from the origin still gets a picture that floats can tell apart.
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
  constexpr int kDirections = 96;  // Even over the sphere, by the golden angle.
  std::vector<glm::vec3> extremes;
  extremes.reserve(kDirections);
  for (int i = 0; i < kDirections; ++i) {
    const float y = 1.0f - (2.0f * static_cast<float>(i) + 1.0f) / kDirections;
    const float angle = 2.3999632f * static_cast<float>(i);
    const float ring = std::sqrt(1.0f - y * y);
    const glm::vec3 direction(ring * std::cos(angle), y, ring * std::sin(angle));
    extremes.push_back(
        *std::ranges::max_element(points, {}, [&](const glm::vec3& p) { return glm::dot(p, direction); }));
  }
  return extremes;
}

}  // namespace sinew::app
