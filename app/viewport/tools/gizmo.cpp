// app/viewport/tools/gizmo.cpp: names of handles, the gizmo's axes in a frame, shape edits, and its status line.

#include "app/viewport/tools/gizmo.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "app/viewport/tools/status_line.h"
#include "core/geometry/normals.h"

namespace sinew::app {
namespace {

struct NamedHandle {
  const char* name;
  HandleParts parts;
};

constexpr std::array<NamedHandle, kGizmoHandleCount> kHandles = {{
    {"", {}},
    {"move.x", {HandleKind::kMove, Way::kX}},
    {"move.y", {HandleKind::kMove, Way::kY}},
    {"move.z", {HandleKind::kMove, Way::kZ}},
    {"move.xy", {HandleKind::kMove, Way::kXY}},
    {"move.yz", {HandleKind::kMove, Way::kYZ}},
    {"move.zx", {HandleKind::kMove, Way::kZX}},
    {"move.center", {HandleKind::kMove, Way::kWhole}},
    {"rotate.x", {HandleKind::kRotate, Way::kX}},
    {"rotate.y", {HandleKind::kRotate, Way::kY}},
    {"rotate.z", {HandleKind::kRotate, Way::kZ}},
    {"rotate.screen", {HandleKind::kRotate, Way::kWhole}},
    {"scale.x", {HandleKind::kScale, Way::kX}},
    {"scale.y", {HandleKind::kScale, Way::kY}},
    {"scale.z", {HandleKind::kScale, Way::kZ}},
    {"scale.uniform", {HandleKind::kScale, Way::kWhole}},
    {"pole.+x", {HandleKind::kPole, Way::kX, 1.0f}},
    {"pole.-x", {HandleKind::kPole, Way::kX, -1.0f}},
    {"pole.+y", {HandleKind::kPole, Way::kY, 1.0f}},
    {"pole.-y", {HandleKind::kPole, Way::kY, -1.0f}},
    {"pole.+z", {HandleKind::kPole, Way::kZ, 1.0f}},
    {"pole.-z", {HandleKind::kPole, Way::kZ, -1.0f}},
    {"shape.belly", {HandleKind::kShape, Way::kY}},
    {"shape.bend", {HandleKind::kShape, Way::kWhole}},
}};  ///< By GizmoHandle.

std::string hoverText(GizmoHandle handle) {
  const HandleParts parts = partsOf(handle);
  const std::string way = nameOf(parts.way);
  const bool whole = parts.way == Way::kWhole;
  switch (parts.kind) {
    case HandleKind::kNone:
      return "";
    case HandleKind::kMove:
      if (whole) return statusLine("Move handle", {"Drag moves in the picture's plane"});
      return statusLine("Move handle " + way,
                        {std::string(isAxis(parts.way) ? "Drag moves along " : "Drag moves in ") + way});
    case HandleKind::kRotate:
      if (whole) return statusLine("Rotate ring", {"Drag rotates about the line of sight"});
      return statusLine("Rotate ring " + way, {"Drag rotates about " + way});
    case HandleKind::kScale:
      if (whole) return statusLine("Scale handle", {"Drag scales all three radii"});
      return statusLine("Scale handle " + way, {"Drag scales the radius along " + way});
    case HandleKind::kPole:
      return statusLine("Radius handle " + std::string(parts.sign > 0.0f ? "+" : "-") + way,
                        {"Drag moves this end alone", "Alt+drag moves both ends"});
    case HandleKind::kShape:
      if (isAxis(parts.way)) return statusLine("Belly handle", {"Drag moves the thickest place along the muscle"});
      return statusLine("Bend handle", {"Drag bends the muscle", "X/Z locks an axis"});
  }
  return "";
}

}  // namespace

const char* nameOf(GizmoHandle handle) { return kHandles[static_cast<std::size_t>(handle)].name; }

const char* nameOf(GizmoMode mode) {
  constexpr std::array<const char*, 4> names = {"poles", "move", "rotate", "scale"};
  return names[static_cast<std::size_t>(mode)];
}

const char* nameOf(GizmoAxes axes) {
  constexpr std::array<const char*, 3> names = {"world", "bone", "primitive"};
  return names[static_cast<std::size_t>(axes)];
}

HandleParts partsOf(GizmoHandle handle) { return kHandles[static_cast<std::size_t>(handle)].parts; }

GizmoHandle handleOf(const HandleParts& parts) {
  const auto found = std::ranges::find(kHandles, parts, &NamedHandle::parts);
  return found == kHandles.end() ? GizmoHandle::kNone : static_cast<GizmoHandle>(found - kHandles.begin());
}

Way wayOf(const GizmoDrag& drag) { return drag.lock == Way::kNone ? partsOf(drag.handle).way : drag.lock; }

const HandleShape* GizmoLayout::find(GizmoHandle handle) const {
  const auto found = std::ranges::find(handles, handle, &HandleShape::handle);
  return found == handles.end() ? nullptr : &*found;
}

std::map<std::string, glm::vec2> GizmoLayout::namedPixels() const {
  std::map<std::string, glm::vec2> pixels;
  for (const HandleShape& shape : handles) pixels[nameOf(shape.handle)] = shape.anchor;
  return pixels;
}

std::array<glm::vec3, 3> gizmoAxes(GizmoAxes axes, const Placement& inBone, const glm::mat4& boneInWorld) {
  const glm::mat3 bone(boneInWorld);
  std::array<glm::vec3, 3> directions;
  for (int i = 0; i < 3; ++i) {
    glm::vec3 unit(0.0f);
    unit[i] = 1.0f;
    glm::vec3 direction = unit;
    if (axes == GizmoAxes::kBone) direction = bone * unit;
    if (axes == GizmoAxes::kPrimitive) direction = bone * (inBone.rotation * unit);
    directions[static_cast<std::size_t>(i)] = normalizeOr(direction, unit);
  }
  return directions;
}

glm::vec3 poleInBone(const Placement& inBone, int axis, float sign) {
  glm::vec3 pole(0.0f);
  pole[axis] = sign;
  if (axis != 1) {
    const float y = thickestAt(inBone.shape);
    const glm::vec2 across = axisAt(inBone.shape, y);
    pole += glm::vec3(across.x, y, across.y);
  }
  return inBone.rotation * (pole * inBone.radii);
}

std::optional<GizmoBasis> gizmoBasis(GizmoAxes axes, const Placement& inBone, const GizmoContext& context) {
  if (!isFinite(context.boneInWorld)) return std::nullopt;
  GizmoBasis frame;
  frame.bone = glm::mat3(context.boneInWorld);
  const glm::dmat3 bone(frame.bone);
  if (isFlat(bone)) return std::nullopt;
  frame.boneInverse = glm::inverse(bone);
  frame.center = glm::vec3(context.boneInWorld * glm::vec4(inBone.center, 1.0f));
  frame.origin = context.pivotInWorld.value_or(frame.center);
  const glm::vec3 pixel = context.view.toPixel(frame.origin);
  if (!isFinite(pixel) || !(std::abs(pixel.z) <= 1.0f)) return std::nullopt;
  frame.axes = gizmoAxes(axes, inBone, context.boneInWorld);
  const glm::vec3 back = -context.view.forwardInWorld();
  frame.toEye = context.view.orthographic ? back : normalizeOr(context.view.eyeInWorld - frame.origin, back);
  frame.arm = kGizmoArmPixels * context.uiScale * context.view.unitsPerPixelAt(frame.origin);
  return frame;
}

std::optional<GizmoBasis> basisOfDrag(const GizmoState& state, GizmoHandle handle, const Placement& inBone,
                                      const GizmoContext& context) {
  const HandleKind kind = partsOf(handle).kind;
  const bool ofShape = kind == HandleKind::kPole || kind == HandleKind::kShape;
  const bool own = kind == HandleKind::kScale || ofShape;
  GizmoContext around = context;
  if (ofShape) around.pivotInWorld.reset();
  return gizmoBasis(own ? GizmoAxes::kPrimitive : state.axes, inBone, around);
}

std::optional<float> alongLine(const glm::vec3& origin, const glm::vec3& direction, const Ray& ray) {
  const glm::dvec3 line(direction);
  const glm::dvec3 sight(ray.direction);
  const glm::dvec3 between = glm::dvec3(ray.origin) - glm::dvec3(origin);
  const double cosine = glm::dot(line, sight);
  const double sineSquared = 1.0 - cosine * cosine;
  if (sineSquared < 0.0012) return std::nullopt;
  const double onLine = (glm::dot(between, line) - cosine * glm::dot(between, sight)) / sineSquared;
  const double onRay = cosine * onLine - glm::dot(between, sight);
  if (!(onRay > 0.0)) return std::nullopt;
  return static_cast<float>(onLine);
}

std::optional<glm::vec3> onPlane(const glm::vec3& origin, const glm::vec3& normal, const Ray& ray) {
  const double cosine = glm::dot(glm::dvec3(normal), glm::dvec3(ray.direction));
  if (std::abs(cosine) < 0.0175) return std::nullopt;
  const double distance = glm::dot(glm::dvec3(normal), glm::dvec3(origin) - glm::dvec3(ray.origin)) / cosine;
  if (!(distance > 0.0)) return std::nullopt;
  return glm::vec3(glm::dvec3(ray.origin) + distance * glm::dvec3(ray.direction));
}

glm::vec3 across(const glm::vec3& direction) {
  const glm::vec3 other = std::abs(direction.x) < 0.6f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
  return normalizeOr(glm::cross(direction, other), glm::vec3(0.0f, 0.0f, 1.0f));
}

glm::vec3 axisMiddleInBone(const Placement& inBone) {
  const glm::vec2 across = axisAt(inBone.shape, 0.0f);
  return inBone.rotation * (glm::vec3(across.x, 0.0f, across.y) * inBone.radii);
}

glm::vec3 thickestInBone(const Placement& inBone, const glm::vec3& toEye) {
  const float y = thickestAt(inBone.shape);
  const glm::vec2 axis = axisAt(inBone.shape, y);
  constexpr float kBetween = 0.70710678f;  // Half way between two poles of the section.
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
  // The thickest section is at y = belly without a straight part: the handle stays under the pointer.
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

std::string describe(const GizmoState& state) {
  if (!state.drag) return hoverText(state.hovered);
  // By HandleKind.
  constexpr std::array<const char*, 6> kSubjects{"", "Move ", "Rotate ", "Scale ", "Radius ", "Bend "};
  const HandleParts parts = partsOf(state.drag->handle);
  if (parts.kind == HandleKind::kNone) return "";
  const bool pole = parts.kind == HandleKind::kPole;
  const bool belly = parts.kind == HandleKind::kShape && isAxis(parts.way);
  const std::string text = belly ? "Belly " : kSubjects[static_cast<std::size_t>(parts.kind)];
  return statusLine(text + state.drag->value, {"Release keeps", "Ctrl snaps", "Shift refines",
                                               pole ? "Alt moves both ends" : "X/Y/Z locks an axis", "0-9 sets a value",
                                               "Enter keeps", "Esc cancels"});
}

}  // namespace sinew::app
