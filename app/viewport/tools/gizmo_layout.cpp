// app/viewport/tools/gizmo_layout.cpp: places the handles on the screen and finds the one under a pixel.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "app/viewport/render/picking.h"
#include "app/viewport/tools/gizmo.h"

namespace sinew::app {
namespace {

// Design pixels, or fractions of the arm.
constexpr float kLineReach = 7.0f;
constexpr float kRingReach = 6.0f;
constexpr float kPoleReach = 8.0f;
constexpr float kCenterReach = 10.0f;
constexpr float kShortestArm = 20.0f;    ///< Shorter axes, which point at the eye, are left out.
constexpr float kPoleClearance = 20.0f;  ///< Nearer poles would hide the center and are left out.
constexpr float kArmBase = 0.2f;
constexpr float kPlaneNear = 0.32f;
constexpr float kPlaneFar = 0.56f;
constexpr float kFlattestPlane = 0.15f;  ///< Fraction of a plane handle's full area below which it is edge-on.
constexpr float kScreenRing = 1.18f;
constexpr int kRingPoints = 64;
constexpr float kMiss = std::numeric_limits<float>::infinity();

bool inPicture(const glm::vec3& pixel) { return isFinite(pixel) && std::abs(pixel.z) <= 1.0f; }

float cross2(const glm::vec2& a, const glm::vec2& b) { return a.x * b.y - a.y * b.x; }

float distanceToSegment(const glm::vec2& p, const glm::vec2& a, const glm::vec2& b) {
  return segmentDistance(p, a, b).first;
}

bool insideConvex(const glm::vec2& p, const std::vector<glm::vec2>& corners) {
  bool below = false;
  bool above = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const float side = cross2(corners[(i + 1) % corners.size()] - corners[i], p - corners[i]);
    below = below || side < 0.0f;
    above = above || side > 0.0f;
  }
  return !(below && above);
}

float distanceToFront(const glm::vec2& p, const HandleShape& ring) {
  float nearest = kMiss;
  for (std::size_t i = 0; i < ring.outline.size(); ++i) {
    const std::size_t next = (i + 1) % ring.outline.size();
    if (!ring.inFront[i] || !ring.inFront[next]) continue;
    nearest = std::min(nearest, distanceToSegment(p, ring.outline[i], ring.outline[next]));
  }
  return nearest;
}

/// The smaller rank wins, then the smaller distance.
struct Hit {
  int rank = 0;
  float distance = kMiss;  ///< Pixels; kMiss: out of reach.
};

Hit hitOf(const HandleShape& shape, const glm::vec2& pixel, float uiScale) {
  const auto within = [](int rank, float distance, float reach) {
    return Hit{rank, distance <= reach ? distance : kMiss};
  };
  const HandleParts parts = partsOf(shape.handle);
  if (parts.kind == HandleKind::kPole || parts.kind == HandleKind::kShape) {
    return within(0, glm::length(pixel - shape.outline[0]), kPoleReach * uiScale);
  }
  if (parts.kind == HandleKind::kRotate) return within(2, distanceToFront(pixel, shape), kRingReach * uiScale);
  if (parts.way == Way::kWhole) return within(1, glm::length(pixel - shape.outline[0]), kCenterReach * uiScale);
  if (isAxis(parts.way)) {
    return within(2, distanceToSegment(pixel, shape.outline[0], shape.outline[1]), kLineReach * uiScale);
  }
  return Hit{3, insideConvex(pixel, shape.outline) ? 0.0f : kMiss};
}

// Stage 1: shapes -------------------------------------------------------------------------------------------------

struct Builder {
  const GizmoState& state;
  const Placement& inBone;
  const GizmoContext& context;
  const GizmoBasis& frame;
  std::vector<HandleShape> shapes;

  [[nodiscard]] glm::vec3 pixelOf(const glm::vec3& world) const { return context.view.toPixel(world); }
  [[nodiscard]] glm::vec2 originPixel() const { return glm::vec2(pixelOf(frame.origin)); }
};

void addArm(Builder& b, HandleKind kind, Way axis) {
  const GizmoHandle handle = handleOf({kind, axis});
  float length = b.frame.arm;
  if (b.state.drag && b.state.drag->handle == handle) length *= b.state.drag->factor;
  const glm::vec3 tip = b.pixelOf(b.frame.origin + length * b.frame.along(axis));
  const glm::vec3 base = b.pixelOf(b.frame.origin + kArmBase * length * b.frame.along(axis));
  if (!inPicture(tip) || !inPicture(base)) return;
  if (glm::length(glm::vec2(tip) - b.originPixel()) < kShortestArm * b.context.uiScale) return;
  b.shapes.push_back({.handle = handle, .outline = {glm::vec2(base), glm::vec2(tip)}, .inFront = {}});
}

void addPlane(Builder& b, Way plane) {
  const std::array<int, 2> pair = planeAxes(plane);
  const glm::vec3 u = b.frame.arm * b.frame.axes[static_cast<std::size_t>(pair[0])];
  const glm::vec3 v = b.frame.arm * b.frame.axes[static_cast<std::size_t>(pair[1])];
  constexpr std::array<std::array<float, 2>, 4> corners = {
      {{kPlaneNear, kPlaneNear}, {kPlaneFar, kPlaneNear}, {kPlaneFar, kPlaneFar}, {kPlaneNear, kPlaneFar}}};
  HandleShape shape{.handle = handleOf({HandleKind::kMove, plane}), .outline = {}, .inFront = {}};
  for (const auto& corner : corners) {
    const glm::vec3 pixel = b.pixelOf(b.frame.origin + corner[0] * u + corner[1] * v);
    if (!inPicture(pixel)) return;
    shape.outline.emplace_back(pixel);
  }
  const float side = (kPlaneFar - kPlaneNear) * kGizmoArmPixels * b.context.uiScale;
  const float area = std::abs(cross2(shape.outline[1] - shape.outline[0], shape.outline[3] - shape.outline[0]));
  if (area >= kFlattestPlane * side * side) b.shapes.push_back(std::move(shape));
}

void addRing(Builder& b, Way axis) {
  const glm::vec3 normal = b.frame.along(axis);
  const glm::vec3 u = across(normal);
  const glm::vec3 v = glm::cross(normal, u);
  HandleShape shape{.handle = handleOf({HandleKind::kRotate, axis}), .outline = {}, .inFront = {}};
  for (int i = 0; i < kRingPoints; ++i) {
    const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / kRingPoints;
    const glm::vec3 spoke = std::cos(angle) * u + std::sin(angle) * v;
    const glm::vec3 pixel = b.pixelOf(b.frame.origin + b.frame.arm * spoke);
    if (!inPicture(pixel)) return;
    shape.outline.emplace_back(pixel);
    // A little past the silhouette, so that a ring facing the eye is closed.
    shape.inFront.push_back(glm::dot(spoke, b.frame.toEye) >= -0.05f);
  }
  b.shapes.push_back(std::move(shape));
}

void addScreenRing(Builder& b) {
  const float radius = kScreenRing * kGizmoArmPixels * b.context.uiScale;
  HandleShape shape{.handle = GizmoHandle::kRotateScreen, .outline = {}, .inFront = {}};
  for (int i = 0; i < kRingPoints; ++i) {
    const float angle = 2.0f * std::numbers::pi_v<float> * (static_cast<float>(i) + 0.5f) / kRingPoints;
    shape.outline.push_back(b.originPixel() + radius * glm::vec2(std::cos(angle), std::sin(angle)));
    shape.inFront.push_back(true);
  }
  b.shapes.push_back(std::move(shape));
}

void addPoles(Builder& b) {
  const glm::mat3 normals = normalMatrix(b.frame.bone);
  for (const Way way : kAxisWays) {
    const int axis = axisOf(way);
    for (const float sign : {1.0f, -1.0f}) {
      glm::vec3 unit(0.0f);
      unit[axis] = sign;
      const glm::vec3 direction = b.inBone.rotation * unit;
      const glm::vec3 world = b.frame.center + b.frame.bone * poleInBone(b.inBone, axis, sign);
      const glm::vec3 pixel = b.pixelOf(world);
      if (!inPicture(pixel)) continue;
      if (glm::length(glm::vec2(pixel) - b.originPixel()) < kPoleClearance * b.context.uiScale) continue;
      const glm::vec3 toEye = b.context.view.orthographic ? b.frame.toEye : b.context.view.eyeInWorld - world;
      b.shapes.push_back({.handle = handleOf({HandleKind::kPole, way, sign}),
                          .outline = {glm::vec2(pixel)},
                          .inFront = {},
                          .depth = pixel.z,
                          .facesEye = glm::dot(normals * direction, toEye) >= 0.0f});
    }
  }
}

void addShapeHandle(Builder& b, GizmoHandle handle, const glm::vec3& fromCenter) {
  const glm::vec3 pixel = b.pixelOf(b.frame.center + b.frame.bone * fromCenter);
  if (!inPicture(pixel)) return;
  // Above the poles, so that handles inside the muscle can be grabbed.
  b.shapes.push_back({.handle = handle, .outline = {glm::vec2(pixel)}, .inFront = {}, .depth = -1.0f});
}

void addShapeHandles(Builder& b) {
  if (!b.context.shapeHandles || b.inBone.shape.isPlain()) return;
  const glm::vec3 toEye = glm::transpose(b.frame.bone) * b.frame.toEye;
  addShapeHandle(b, GizmoHandle::kBend, axisMiddleInBone(b.inBone));
  addShapeHandle(b, GizmoHandle::kBelly, thickestInBone(b.inBone, toEye));
}

void addShapes(Builder& b) {
  switch (b.state.mode) {
    case GizmoMode::kPoles:
      addShapeHandles(b);
      break;
    case GizmoMode::kMove:
      for (const Way axis : kAxisWays) addArm(b, HandleKind::kMove, axis);
      for (const Way plane : kPlaneWays) addPlane(b, plane);
      b.shapes.push_back({.handle = GizmoHandle::kMoveCenter, .outline = {b.originPixel()}, .inFront = {}});
      break;
    case GizmoMode::kRotate:
      for (const Way axis : kAxisWays) addRing(b, axis);
      addScreenRing(b);
      break;
    case GizmoMode::kScale:
      for (const Way axis : kAxisWays) addArm(b, HandleKind::kScale, axis);
      b.shapes.push_back({.handle = GizmoHandle::kScaleUniform, .outline = {b.originPixel()}, .inFront = {}});
      break;
  }
  addPoles(b);
}

// Stage 2: for each handle a pixel that hits only it --------------------------------------------------

/// Pixels of a handle, the best first except for rings.
std::vector<glm::vec2> anchorCandidates(const HandleShape& shape) {
  const HandleParts parts = partsOf(shape.handle);
  std::vector<glm::vec2> candidates;
  if (parts.kind == HandleKind::kRotate) {
    for (std::size_t i = 0; i < shape.outline.size(); i += 2) {
      if (shape.inFront[i]) candidates.push_back(shape.outline[i]);
    }
  } else if (shape.outline.size() == 2) {
    for (const float t : {1.0f, 0.9f, 0.8f, 0.7f, 0.6f, 0.5f, 0.4f, 0.3f, 0.2f, 0.1f, 0.0f}) {
      candidates.push_back(glm::mix(shape.outline[0], shape.outline[1], t));
    }
  } else if (shape.outline.size() == 4) {
    const auto inQuad = [&](float u, float v) {
      const glm::vec2 low = glm::mix(shape.outline[0], shape.outline[1], u);
      return glm::mix(low, glm::mix(shape.outline[3], shape.outline[2], u), v);
    };
    for (const float v : {0.5f, 0.75f, 0.25f}) {
      for (const float u : {0.5f, 0.75f, 0.25f}) candidates.push_back(inQuad(u, v));
    }
  } else {
    candidates.push_back(shape.outline[0]);
  }
  for (glm::vec2& candidate : candidates) candidate = glm::round(candidate);
  return candidates;
}

/// Distance of a ring's pixel from other handles; crossings are hard to grab.
float clearance(const GizmoLayout& layout, GizmoHandle ring, const glm::vec2& pixel) {
  float nearest = kMiss;
  for (const HandleShape& other : layout.handles) {
    if (other.handle == ring) continue;
    const bool isRing = partsOf(other.handle).kind == HandleKind::kRotate;
    nearest = std::min(nearest, isRing ? distanceToFront(pixel, other) : glm::length(pixel - other.outline[0]));
  }
  return nearest;
}

bool chooseAnchor(const GizmoLayout& layout, const glm::ivec2& size, HandleShape& shape) {
  const bool isRing = partsOf(shape.handle).kind == HandleKind::kRotate;
  float best = -1.0f;
  for (const glm::vec2& candidate : anchorCandidates(shape)) {
    const bool outside = candidate.x < 0.0f || candidate.y < 0.0f || candidate.x >= static_cast<float>(size.x) ||
                         candidate.y >= static_cast<float>(size.y);
    if (outside || hitTest(layout, candidate) != shape.handle) continue;
    const float free = isRing ? clearance(layout, shape.handle, candidate) : 0.0f;
    if (free <= best) continue;
    best = free;
    shape.anchor = candidate;
    if (!isRing) break;
  }
  return best >= 0.0f;
}

}  // namespace

GizmoLayout layoutGizmo(const GizmoState& state, const Placement& inBone, const GizmoContext& context) {
  GizmoLayout layout;
  const std::optional<GizmoBasis> frame = gizmoBasis(effectiveAxes(state.mode, state.axes), inBone, context);
  if (!frame) return layout;
  Builder builder{state, inBone, context, *frame, {}};
  addShapes(builder);
  layout.visible = true;
  layout.origin = builder.originPixel();
  layout.axesInWorld = frame->axes;
  layout.uiScale = context.uiScale;
  layout.handles = builder.shapes;
  // Anchors are chosen among all shapes; removing some afterwards does not affect the others.
  for (HandleShape& shape : builder.shapes) {
    if (!chooseAnchor(layout, context.view.size, shape)) shape.handle = GizmoHandle::kNone;
  }
  std::erase_if(builder.shapes, [](const HandleShape& shape) { return shape.handle == GizmoHandle::kNone; });
  layout.handles = std::move(builder.shapes);
  return layout;
}

GizmoHandle hitTest(const GizmoLayout& layout, const glm::vec2& pixel) {
  const HandleShape* best = nullptr;
  Hit bestHit{std::numeric_limits<int>::max(), kMiss};
  for (const HandleShape& shape : layout.handles) {
    const Hit hit = hitOf(shape, pixel, layout.uiScale);
    if (hit.distance == kMiss || hit.rank > bestHit.rank) continue;
    const bool tie = best && hit.rank == bestHit.rank && std::abs(hit.distance - bestHit.distance) < 0.5f;
    const bool better = hit.rank < bestHit.rank || (tie ? shape.depth < best->depth : hit.distance < bestHit.distance);
    if (best && !better) continue;
    best = &shape;
    bestHit = hit;
  }
  return best ? best->handle : GizmoHandle::kNone;
}

}  // namespace sinew::app
