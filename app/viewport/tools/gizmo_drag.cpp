// app/viewport/tools/gizmo_drag.cpp: from motions of the pointer to a new placement.

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "app/viewport/tools/gizmo.h"
#include "core/geometry/normals.h"

namespace sinew::app {
namespace {

constexpr float kGizmoPi = std::numbers::pi_v<float>;
constexpr float kPrecise = 0.1f;
constexpr float kMoveStep = 0.01f;  ///< Fraction of H.
constexpr float kAngleStep = kGizmoPi / 12.0f;
constexpr float kFactorStep = 0.1f;
constexpr float kFarthestMove = 50.0f;  ///< Heights; beyond, the pointer is near a vanishing point.
constexpr float kPlanarRing = 0.2f;     ///< |cosine| of ring normal and sight below which a ring is edge-on.

glm::mat3 axesMatrix(const GizmoBasis& frame) { return {frame.axes[0], frame.axes[1], frame.axes[2]}; }

std::string number(float value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", static_cast<double>(std::abs(value) < 1e-9f ? 0.0f : value));
  return text.data();
}

std::string lengthText(float length, float characterHeight) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), " (%.1f %% of H)", static_cast<double>(100.0f * length / characterHeight));
  return number(length) + text.data();
}

float snapped(float value, float step) { return std::round(value / step) * step; }

// An effect on a placement ----------------------------------------------------------------------------------------

constexpr float kLeastRadius = 0.002f;  ///< Fraction of H, in the world.

Placement moved(const GizmoEffect& effect, const Placement& start, const glm::dmat3& boneInverse) {
  Placement placement = start;
  placement.center = glm::vec3(glm::dvec3(start.center) + boneInverse * glm::dvec3(effect.moved));
  return placement;
}

/// @param center  world, if it rotates about the pivot; null: it is the pivot
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

/// World length of one bone unit along the primitive's axis.
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

// Pointer -> tracks -----------------------------------------------------------------------------------------------

/// World point under a pixel for a move along one way, relative to the origin.
std::optional<glm::vec3> movePoint(Way way, const glm::vec2& pixel, const GizmoBasis& frame, const View& view) {
  const Ray ray = view.rayThrough(pixel);
  if (isAxis(way)) {
    const glm::vec3 direction = frame.along(way);
    const std::optional<float> along = alongLine(frame.origin, direction, ray);
    if (!along) return std::nullopt;
    return *along * direction;
  }
  glm::vec3 normal = view.forwardInWorld();
  if (isPlane(way)) {
    const std::array<int, 2> pair = planeAxes(way);
    normal = normalizeOr(
        glm::cross(frame.axes[static_cast<std::size_t>(pair[0])], frame.axes[static_cast<std::size_t>(pair[1])]),
        normal);
  }
  const std::optional<glm::vec3> hit = onPlane(frame.origin, normal, ray);
  if (!hit) return std::nullopt;
  return *hit - frame.origin;
}

/// Adds the motion from the track's last pixel, unless it is undefined near a vanishing point.
void advanceMove(GizmoTrack& track, Way way, const glm::vec2& pixel, float speed, const GizmoBasis& frame,
                 const GizmoContext& context) {
  const std::optional<glm::vec3> now = movePoint(way, pixel, frame, context.view);
  if (!now || glm::length(*now) > kFarthestMove * context.characterHeight) return;
  const std::optional<glm::vec3> before = movePoint(way, track.lastPixel, frame, context.view);
  track.lastPixel = pixel;
  if (!before) return;
  const glm::vec3 delta = *now - *before;
  // Solves for coordinates, since axes of sheared bones are not orthogonal.
  glm::vec3 coordinates(0.0f);
  if (isAxis(way)) coordinates[axisOf(way)] = glm::dot(delta, frame.along(way));
  else coordinates = glm::inverse(axesMatrix(frame)) * delta;
  if (isPlane(way)) coordinates[normalAxisOf(way)] = 0.0f;
  track.traveled += speed * coordinates;
}

void advanceRotation(GizmoTrack& track, Way way, const glm::vec2& pixel, float speed, const GizmoBasis& frame,
                     const GizmoContext& context) {
  const glm::vec3 normal = frame.ringNormal(way);
  const glm::vec2 before = track.lastPixel;
  track.lastPixel = pixel;
  if (std::abs(glm::dot(normal, frame.toEye)) > kPlanarRing) {
    const std::optional<glm::vec3> from = onPlane(frame.origin, normal, context.view.rayThrough(before));
    const std::optional<glm::vec3> to = onPlane(frame.origin, normal, context.view.rayThrough(pixel));
    if (!from || !to) return;
    const glm::vec3 a = *from - frame.origin;
    const glm::vec3 b = *to - frame.origin;
    const float tooNear = 0.03f * frame.arm;
    if (glm::length(a) < tooNear || glm::length(b) < tooNear) return;
    track.traveled.x += speed * std::atan2(glm::dot(normal, glm::cross(a, b)), glm::dot(a, b));
    return;
  }
  // Edge-on, the ring is a line in the picture: a motion of an arm's length along it is one radian.
  const glm::vec3 tangent = normalizeOr(glm::cross(normal, frame.toEye), across(normal));
  const glm::vec2 onScreen = glm::vec2(context.view.toPixel(frame.origin + frame.arm * tangent)) -
                             glm::vec2(context.view.toPixel(frame.origin));
  const float lengthSquared = glm::dot(onScreen, onScreen);
  if (lengthSquared > 1.0f) track.traveled.x += speed * glm::dot(pixel - before, onScreen) / lengthSquared;
}

void advanceTracks(GizmoDrag& drag, const glm::vec2& pixel, float speed, const GizmoBasis& frame,
                   const GizmoContext& context) {
  const HandleParts parts = partsOf(drag.handle);
  for (const Way way : kAllWays) {
    GizmoTrack& track = drag.tracks[trackOf(way)];
    if (track.lastPixel == pixel) continue;
    if (parts.kind == HandleKind::kRotate) {
      if (!isPlane(way)) advanceRotation(track, way, pixel, speed, frame, context);
    } else if (parts.kind == HandleKind::kScale && way == Way::kWhole) {
      track.traveled.x += speed * ((pixel.x - track.lastPixel.x) - (pixel.y - track.lastPixel.y));
      track.lastPixel = pixel;
    } else {
      advanceMove(track, way, pixel, speed, frame, context);
    }
  }
  drag.pointer = pixel;
}

// Keys ------------------------------------------------------------------------------------------------------------

void readKeys(GizmoDrag& drag, const ViewportInput& input) {
  const bool oneWay = partsOf(drag.handle).kind == HandleKind::kPole || drag.handle == GizmoHandle::kBelly;
  if (!oneWay) {
    constexpr std::array<std::pair<Key, Way>, 3> axisKeys = {
        {{Key::kX, Way::kX}, {Key::kY, Way::kY}, {Key::kZ, Way::kZ}}};
    for (const auto& [key, axis] : axisKeys) {
      if (drag.handle == GizmoHandle::kBend && axis == Way::kY) continue;
      if (input.keyPressed(key)) drag.lock = drag.lock == axis ? Way::kNone : axis;
    }
  }
  if (input.keyPressed(Key::kBackspace) && !drag.typed.empty()) drag.typed.pop_back();
  for (const char typed : input.typed) {
    const char c = typed == ',' ? '.' : typed;
    if (c == '-') {
      if (drag.typed.starts_with('-')) drag.typed.erase(0, 1);
      else drag.typed.insert(0, 1, '-');
      continue;
    }
    const bool digit = c >= '0' && c <= '9' && drag.typed.size() < 12;
    if (digit || (c == '.' && drag.typed.find('.') == std::string::npos)) {
      drag.typed.push_back(c);
    }
  }
}

/// nullopt if it is not a number yet ("-", ".").
std::optional<float> typedValue(const std::string& typed) {
  float value = 0.0f;
  const char* end = typed.data() + typed.size();
  const auto parsed = std::from_chars(typed.data(), end, value);
  if (typed.empty() || parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
  return value;
}

// Tracks -> placement ---------------------------------------------------------------------------------------------

struct Evaluation {
  GizmoDrag& drag;
  const ViewportInput& input;
  const GizmoContext& context;
  const GizmoBasis& frame;
  Way way;  ///< After the lock.
  float sign;
  std::optional<float> typed;

  [[nodiscard]] const glm::vec3& traveled() const { return drag.tracks[trackOf(way)].traveled; }
  [[nodiscard]] float step(float coarse) const { return input.shift ? kPrecise * coarse : coarse; }
  [[nodiscard]] bool snaps() const { return input.ctrl && !typed; }
};

void setValue(const Evaluation& e, const std::string& value) {
  const std::string label = nameOf(e.way);
  e.drag.value = label + (label.empty() ? "" : " ") + value + (e.drag.typed.empty() ? "" : " [" + e.drag.typed + "]");
}

/// Axis of a typed length before any motion.
int firstAxisOf(Way way) {
  if (isAxis(way)) return axisOf(way);
  return isPlane(way) ? planeAxes(way)[0] : axisOf(Way::kX);
}

Placement evaluateMove(const Evaluation& e) {
  glm::vec3 coordinates = e.traveled();
  const glm::mat3 axes = axesMatrix(e.frame);
  if (e.snaps()) {
    for (int i = 0; i < 3; ++i) coordinates[i] = snapped(coordinates[i], e.step(kMoveStep * e.context.characterHeight));
  }
  if (e.typed) {
    glm::vec3 first(0.0f);
    first[firstAxisOf(e.way)] = 1.0f;
    const float length = glm::length(axes * coordinates);
    const bool moved = !isAxis(e.way) && length > 1e-6f * e.context.characterHeight;
    coordinates = *e.typed * (moved ? coordinates / length : first);
  }
  const glm::vec3 inWorld = axes * coordinates;
  const float length = isAxis(e.way) ? coordinates[axisOf(e.way)] : glm::length(inWorld);
  setValue(e, lengthText(length, e.context.characterHeight));
  e.drag.effect.moved = inWorld;
  return moved(e.drag.effect, e.drag.start, e.frame.boneInverse);
}

Placement evaluateRotation(const Evaluation& e) {
  float angle = e.traveled().x;
  if (e.snaps()) angle = snapped(angle, e.step(kAngleStep));
  if (e.typed) angle = *e.typed * kGizmoPi / 180.0f;
  e.drag.angle = angle;
  setValue(e, number(angle * 180.0f / kGizmoPi) + " deg");
  e.drag.effect.turnAxis = e.frame.ringNormal(e.way);
  e.drag.effect.angle = angle;
  e.drag.effect.pivot = e.frame.origin;
  return turned(e.drag.effect, e.drag.start, e.frame.boneInverse, e.context.pivotInWorld ? &e.frame.center : nullptr);
}

Placement evaluateScale(const Evaluation& e) {
  // A lock on the uniform handle changes which radii scale, not how far.
  const bool uniform = partsOf(e.drag.handle).way == Way::kWhole;
  const glm::vec3& traveled = e.drag.tracks[trackOf(uniform ? Way::kWhole : e.way)].traveled;
  float factor = uniform ? std::exp2(traveled.x / (kGizmoArmPixels * e.context.uiScale))
                         : 1.0f + traveled[axisOf(e.way)] / e.drag.grabbedLength;
  if (e.snaps()) factor = std::max(snapped(factor, e.step(kFactorStep)), e.step(kFactorStep));
  factor = std::clamp(e.typed.value_or(factor), 0.01f, 1000.0f);
  e.drag.factor = factor;
  setValue(e, "x " + number(factor));
  e.drag.effect.factors = glm::vec3(1.0f);
  for (const Way axis : kAxisWays) {
    if (e.way == Way::kWhole || e.way == axis) e.drag.effect.factors[axisOf(axis)] = factor;
  }
  return scaled(e.drag.effect, e.drag.start, e.frame.bone, e.context.characterHeight);
}

/// Offset of both poles of an axis along it, in radii.
float bendAtPole(const Shape& shape, int axis) { return axis == 1 ? 0.0f : axisAt(shape, thickestAt(shape))[axis / 2]; }

Placement evaluatePole(const Evaluation& e) {
  const int axis = axisOf(e.way);
  const float perUnit = worldPerUnit(e.frame.bone, e.drag.start, axis);
  const float before = perUnit * e.drag.start.radii[axis];
  const float pulled = e.sign * e.traveled()[axis];
  const bool bothEnds = e.input.alt;
  float length = before + (bothEnds ? pulled : 0.5f * pulled);
  if (e.snaps()) length = snapped(length, e.step(kMoveStep * e.context.characterHeight));
  length = e.typed.value_or(length);
  length = std::max(length, std::min(before, kLeastRadius * e.context.characterHeight));
  setValue(e, lengthText(length, e.context.characterHeight));
  Placement placement = e.drag.start;
  if (length == before) return placement;
  placement.radii[axis] = length / perUnit;
  if (!bothEnds) {
    glm::vec3 unit(0.0f);
    unit[axis] = e.sign - bendAtPole(placement.shape, axis);
    placement.center += (placement.radii[axis] - e.drag.start.radii[axis]) * (e.drag.start.rotation * unit);
  }
  return placement;
}

Placement evaluateShape(const Evaluation& e) {
  const Placement& start = e.drag.start;
  glm::vec3 traveled(0.0f);
  for (int axis = 0; axis < 3; ++axis) {
    traveled[axis] = e.traveled()[axis] / (worldPerUnit(e.frame.bone, start, axis) * start.radii[axis]);
    if (e.snaps()) traveled[axis] = snapped(traveled[axis], e.step(kFactorStep));
  }
  const bool belly = e.drag.handle == GizmoHandle::kBelly;
  const Placement placement = belly ? withBelly(start, traveled.y, e.context.reach, e.typed)
                                    : withBend(start, e.way, traveled, e.context.reach, e.typed);
  const Shape& shape = placement.shape;
  setValue(e, belly ? number(shape.belly) : number(shape.bend.x) + ", " + number(shape.bend.y));
  return placement;
}

Placement evaluate(GizmoDrag& drag, const ViewportInput& input, const GizmoContext& context, const GizmoBasis& frame) {
  const HandleParts parts = partsOf(drag.handle);
  const Evaluation e{drag, input, context, frame, wayOf(drag), parts.sign, typedValue(drag.typed)};
  switch (parts.kind) {
    case HandleKind::kNone:
      break;
    case HandleKind::kMove:
      return evaluateMove(e);
    case HandleKind::kRotate:
      return evaluateRotation(e);
    case HandleKind::kScale:
      return evaluateScale(e);
    case HandleKind::kPole:
      return evaluatePole(e);
    case HandleKind::kShape:
      return evaluateShape(e);
  }
  return drag.start;
}

}  // namespace

void beginDrag(GizmoState& state, GizmoHandle handle, const Placement& inBone, const glm::vec2& pixel,
               const GizmoContext& context) {
  assert(handle != GizmoHandle::kNone);
  GizmoDrag drag;
  drag.handle = handle;
  drag.start = inBone;
  drag.current = inBone;
  drag.pressPixel = pixel;
  drag.pointer = pixel;
  for (GizmoTrack& track : drag.tracks) track.lastPixel = pixel;
  const std::optional<GizmoBasis> frame = basisOfDrag(state, handle, inBone, context);
  const HandleParts parts = partsOf(handle);
  if (frame) {
    drag.grabbedLength = frame->arm;
    if (parts.kind == HandleKind::kScale && isAxis(parts.way)) {
      const std::optional<glm::vec3> grabbed = movePoint(parts.way, pixel, *frame, context.view);
      const float length = grabbed ? glm::dot(*grabbed, frame->along(parts.way)) : 0.0f;
      if (length > 0.1f * frame->arm) drag.grabbedLength = length;
    }
  }
  state.drag = drag;
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

DragResult updateDrag(GizmoState& state, const ViewportInput& input, const GizmoContext& context) {
  assert(state.drag);
  GizmoDrag& drag = *state.drag;
  if (input.keyPressed(Key::kEscape) || input.button(MouseButton::kRight).pressed) {
    const DragResult canceled{drag.start, DragOutcome::kCanceled, {}};
    state.drag.reset();
    return canceled;
  }
  readKeys(drag, input);
  // Applies the whole drag to the placement at the start on the bone of this frame.
  if (const std::optional<GizmoBasis> frame = basisOfDrag(state, drag.handle, drag.start, context)) {
    advanceTracks(drag, input.mouse, input.shift ? kPrecise : 1.0f, *frame, context);
    drag.current = evaluate(drag, input, context, *frame);
  }
  const bool committed =
      input.keyPressed(Key::kEnter) || input.keyPressed(Key::kKeypadEnter) || input.button(MouseButton::kLeft).released;
  const DragResult result{drag.current, committed ? DragOutcome::kCommitted : DragOutcome::kDragging, drag.effect};
  if (committed) state.drag.reset();
  return result;
}

}  // namespace sinew::app
