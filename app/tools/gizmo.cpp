// app/tools/gizmo.cpp: names of handles, the gizmo's frame, and what it says of itself.

#include "app/tools/gizmo.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "app/tools/gizmo_basis.h"

namespace sinew::app {
namespace {

constexpr std::array<const char*, kGizmoHandleCount> kNames = {
    "",         "move.x",   "move.y",   "move.z",        "move.xy", "move.yz", "move.zx", "move.center",
    "rotate.x", "rotate.y", "rotate.z", "rotate.screen", "scale.x", "scale.y", "scale.z", "scale.uniform",
    "pole.+x",  "pole.-x",  "pole.+y",  "pole.-y",       "pole.+z", "pole.-z"};

constexpr std::array<const char*, 7> kWays = {"X", "Y", "Z", "XY", "YZ", "ZX", "screen"};

GizmoHandle offset(GizmoHandle first, int by) { return static_cast<GizmoHandle>(static_cast<int>(first) + by); }

std::string hoverText(GizmoHandle handle) {
  const HandleParts parts = partsOf(handle);
  const std::string way = parts.way >= 0 ? kWays[static_cast<std::size_t>(parts.way)] : "";
  switch (parts.kind) {
    case HandleKind::kNone:
      return "";
    case HandleKind::kMove:
      return parts.way == 6 ? "Drag to move in the picture's plane"
                            : "Drag to move " + std::string(parts.way < 3 ? "along " : "in ") + way;
    case HandleKind::kRotate:
      return "Drag to rotate about " + (parts.way == 6 ? "the line of sight" : way);
    case HandleKind::kScale:
      return "Drag to scale " + (parts.way == 6 ? "all three radii" : "the radius along " + way);
    case HandleKind::kPole:
      return "Drag to pull the " + std::string(parts.sign > 0.0f ? "+" : "-") + way +
             " end; the other end stays (Alt: the centre stays)";
  }
  return "";
}

}  // namespace

const char* nameOf(GizmoHandle handle) { return kNames[static_cast<std::size_t>(handle)]; }

const char* nameOf(GizmoMode mode) {
  constexpr std::array<const char*, 4> names = {"poles", "move", "rotate", "scale"};
  return names[static_cast<std::size_t>(mode)];
}

const char* nameOf(GizmoAxes axes) {
  constexpr std::array<const char*, 3> names = {"world", "bone", "primitive"};
  return names[static_cast<std::size_t>(axes)];
}

HandleParts partsOf(GizmoHandle handle) {
  const int index = static_cast<int>(handle);
  const auto from = [&](GizmoHandle first) { return index - static_cast<int>(first); };
  if (handle == GizmoHandle::kNone) return {};
  if (handle <= GizmoHandle::kMoveCenter) return {HandleKind::kMove, from(GizmoHandle::kMoveX), 1.0f};
  if (handle == GizmoHandle::kRotateScreen) return {HandleKind::kRotate, 6, 1.0f};
  if (handle < GizmoHandle::kRotateScreen) return {HandleKind::kRotate, from(GizmoHandle::kRotateX), 1.0f};
  if (handle == GizmoHandle::kScaleUniform) return {HandleKind::kScale, 6, 1.0f};
  if (handle < GizmoHandle::kScaleUniform) return {HandleKind::kScale, from(GizmoHandle::kScaleX), 1.0f};
  const int pole = from(GizmoHandle::kPolePlusX);
  return {HandleKind::kPole, pole / 2, pole % 2 == 0 ? 1.0f : -1.0f};
}

GizmoHandle moveHandle(int way) { return offset(GizmoHandle::kMoveX, way); }
GizmoHandle rotateHandle(int way) { return way == 6 ? GizmoHandle::kRotateScreen : offset(GizmoHandle::kRotateX, way); }
GizmoHandle scaleHandle(int way) { return way == 6 ? GizmoHandle::kScaleUniform : offset(GizmoHandle::kScaleX, way); }
GizmoHandle poleHandle(int axis, float sign) {
  return offset(GizmoHandle::kPolePlusX, 2 * axis + (sign > 0.0f ? 0 : 1));
}

std::array<int, 2> planeAxes(int way) { return {way - 3, (way - 2) % 3}; }

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

std::optional<GizmoBasis> gizmoBasis(GizmoAxes axes, const Placement& inBone, const GizmoContext& context) {
  if (!isFinite(context.boneInWorld)) return std::nullopt;
  GizmoBasis frame;
  frame.bone = glm::mat3(context.boneInWorld);
  const glm::dmat3 bone(frame.bone);
  const double lengths = glm::length(bone[0]) * glm::length(bone[1]) * glm::length(bone[2]);
  if (!(std::abs(glm::determinant(bone)) > 1e-6 * lengths)) return std::nullopt;
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
  const double slope = glm::dot(glm::dvec3(normal), glm::dvec3(ray.direction));
  if (std::abs(slope) < 0.0175) return std::nullopt;
  const double distance = glm::dot(glm::dvec3(normal), glm::dvec3(origin) - glm::dvec3(ray.origin)) / slope;
  if (!(distance > 0.0)) return std::nullopt;
  return glm::vec3(glm::dvec3(ray.origin) + distance * glm::dvec3(ray.direction));
}

glm::vec3 across(const glm::vec3& direction) {
  const glm::vec3 other = std::abs(direction.x) < 0.6f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 1.0f, 0.0f);
  return normalizeOr(glm::cross(direction, other), glm::vec3(0.0f, 0.0f, 1.0f));
}

std::string describe(const GizmoState& state) {
  if (!state.drag) return hoverText(state.hovered);
  const HandleParts parts = partsOf(state.drag->handle);
  std::string text;
  std::string lock = "X/Y/Z lock, ";
  switch (parts.kind) {
    case HandleKind::kNone:
      return "";
    case HandleKind::kMove:
      text = "Move ";
      break;
    case HandleKind::kRotate:
      text = "Rotate ";
      break;
    case HandleKind::kScale:
      text = "Scale ";
      break;
    case HandleKind::kPole:
      text = "Radius ";
      lock = "Alt both ends, ";
      break;
  }
  return text + state.drag->value + ": " + lock +
         "Ctrl snaps, Shift is precise, type a number, Enter or release keeps, Esc cancels";
}

}  // namespace sinew::app
