// app/tools/add_muscle.cpp: an ellipsoid grows where the skin is pressed.

#include "app/tools/add_muscle.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "app/tools/gizmo_frame.h"
#include "core/rig/rig_edit.h"
#include "core/rig/twins.h"

namespace sinew::app {
namespace {

constexpr float kTremor = 4.0f;        ///< Design pixels a click may move.
constexpr float kClickLength = 0.05f;  ///< Semi-axes, of H.
constexpr float kClickWidth = 0.032f;
constexpr float kClickThickness = 0.026f;
constexpr float kWidth = 0.6f;       ///< Of the half length of a drag: full enough to show under the skin at once.
constexpr float kThickness = 0.55f;
constexpr float kShortestDrag = 0.01f;  ///< Of H.
constexpr float kLongestDrag = 1.5f;
constexpr float kSunk = 0.3f;  ///< Of the thickness: how deep the centre lies under the skin.

bool isFlat(const glm::mat4& boneInWorld) {
  const glm::dmat3 bone{glm::mat3(boneInWorld)};
  const double lengths = glm::length(bone[0]) * glm::length(bone[1]) * glm::length(bone[2]);
  return !isFinite(boneInWorld) || !(std::abs(glm::determinant(bone)) > 1e-6 * lengths);
}

/// What the designer draws on the tangent plane: the ellipsoid before it meets the bone. World.
struct Stroke {
  glm::vec3 center{0.0f};
  glm::vec3 along{1.0f, 0.0f, 0.0f};  ///< Unit, in the tangent plane.
  glm::vec3 normal{0.0f, 0.0f, 1.0f};
  glm::vec3 semiAxes{1.0f};  ///< Along, across, out.
};

/// From the start to where the pointer is on the tangent plane. A ray that misses it: its point nearest to the start.
glm::vec3 dragOnSkin(const SkinPoint& start, const Ray& pointer, float characterHeight) {
  const float towards = std::max(glm::dot(start.point - pointer.origin, pointer.direction), 0.0f);
  const glm::vec3 nearest = pointer.origin + towards * pointer.direction;
  glm::vec3 drag = onPlane(start.point, start.normal, pointer).value_or(nearest) - start.point;
  drag -= glm::dot(drag, start.normal) * start.normal;
  const float length = glm::length(drag);
  const float longest = kLongestDrag * characterHeight;
  return length > longest ? drag * (longest / length) : drag;
}

Stroke strokeOf(const SkinPoint& start, const std::optional<Ray>& pointer, const glm::vec3& boneAxisInWorld,
                float height) {
  const glm::vec3 drag = pointer ? dragOnSkin(start, *pointer, height) : glm::vec3(0.0f);
  const float length = glm::length(drag);
  Stroke stroke;
  stroke.normal = start.normal;
  if (length < kShortestDrag * height) {
    // Along the bone, unless the bone stands on the skin.
    const glm::vec3 bone = normalizeOr(boneAxisInWorld, start.normal);
    const glm::vec3 flat = bone - glm::dot(bone, start.normal) * start.normal;
    stroke.along = glm::dot(flat, flat) > 1e-4f ? glm::normalize(flat) : across(start.normal);
    stroke.semiAxes = height * glm::vec3(kClickLength, kClickWidth, kClickThickness);
    stroke.center = start.point;
  } else {
    stroke.along = drag / length;
    const float half = std::max(0.5f * length, 0.015f * height);
    stroke.semiAxes = {half, std::clamp(kWidth * half, 0.02f * height, 0.2f * height),
                       std::clamp(kThickness * half, 0.02f * height, 0.15f * height)};
    stroke.center = start.point + 0.5f * drag;
  }
  stroke.center -= kSunk * stroke.semiAxes.z * stroke.normal;
  return stroke;
}

/// The bone-space ellipsoid whose world image has the stroke's long axis, tangent plane and extents. Directions go
/// through inverse(B), planes through transpose(B): the two stay at right angles to each other, so they are axes as
/// they are.
Placement placementOf(const Stroke& stroke, const glm::mat4& boneInWorld) {
  const glm::dmat3 bone{glm::mat3(boneInWorld)};
  const glm::dmat3 inverse = glm::inverse(bone);
  const glm::dvec3 along = glm::normalize(inverse * glm::dvec3(stroke.along));
  const glm::dvec3 out = glm::normalize(glm::transpose(bone) * glm::dvec3(stroke.normal));
  const glm::dvec3 side = glm::cross(out, along);
  const glm::dvec3 size(stroke.semiAxes);
  Placement placement;
  placement.center = glm::vec3(inverse * (glm::dvec3(stroke.center) - glm::dvec3(boneInWorld[3])));
  placement.rotation = glm::normalize(glm::quat_cast(glm::mat3(glm::vec3(along), glm::vec3(side), glm::vec3(out))));
  placement.radii = glm::vec3(size.x / glm::length(bone * along), size.y / glm::length(bone * side),
                              size.z / glm::dot(glm::dvec3(stroke.normal), bone * out));
  return placement;
}

Primitive newMuscle(const Skeleton& skeleton, int bone, const Placement& placement) {
  Primitive primitive;
  primitive.name = skeleton.bones[static_cast<std::size_t>(bone)].name + " muscle";
  primitive.bone = skeleton.fileName(bone);
  primitive.placement = placement;
  return primitive;
}

constexpr float kNearPlane = 0.01f;  ///< Of H: a muscle added this near to the middle is laid into it.

/// The muscle, and with symmetry its twin; one in the middle stays alone.
Result<Rig> withMuscle(const Document& document, const Rig& rig, Primitive muscle) {
  const MirrorPlan* const plan = document.mirror.get();
  if (!document.symmetry || !plan || !twinBone(*plan, muscle.bone)) return addPrimitive(rig, std::move(muscle));
  if (const std::optional<Placement> snapped = snappedToPlane(*plan, muscle, kNearPlane)) {
    muscle.placement = *snapped;
    return addPrimitive(rig, std::move(muscle));
  }
  return addPair(rig, std::move(muscle), *plan);
}

Placement placementNow(const AddMuscleDrag& drag, const ViewportContext& context, const std::optional<Ray>& pointer) {
  const Character& character = *context.document.character;
  const auto bone = static_cast<std::size_t>(drag.bone);
  const glm::mat4& boneInWorld = context.pose.boneInWorld[bone];
  const glm::vec3 axis = glm::mat3(boneInWorld) * character.skeleton.bones[bone].tip;
  const SkinPoint start = skinPointAt(character, context.pose, drag.anchor);
  return placementOnSkin(start, pointer, boneInWorld, axis, character.height);
}

/// Shows the muscle as one state of the gesture.
Result<void> show(const AddMuscleDrag& drag, const ViewportContext& context, const Placement& placement) {
  Document& document = context.document;
  Result<Rig> rig =
      withMuscle(document, *drag.rigBefore, newMuscle(document.character->skeleton, drag.bone, placement));
  if (!rig) return rig.error();
  const std::string name = rig->primitives[drag.rigBefore->primitives.size()].name;
  document.commands.updateGesture(std::move(rig).value());
  document.selection.set(name);
  return {};
}

/// Mean distance from the bone's line of the skin that mostly follows it, in the bind pose; 0 if there is none.
float skinDistance(const Character& character, int bone, const glm::vec3& origin, const glm::vec3& axis) {
  float sum = 0.0f;
  int count = 0;
  for (std::size_t v = 0; v < character.mesh.positions.size(); ++v) {
    float weight = 0.0f;
    for (const Influence& influence : character.mesh.influencesOf(static_cast<int>(v))) {
      const Binding& binding = character.skeleton.bindings[static_cast<std::size_t>(influence.binding)];
      if (binding.bone == bone) weight += influence.weight;
    }
    if (weight < 0.5f) continue;
    const glm::vec3 offset = character.mesh.positions[v] - origin;
    sum += glm::length(offset - glm::dot(offset, axis) * axis);
    ++count;
  }
  return count > 0 ? sum / static_cast<float>(count) : 0.0f;
}

}  // namespace

Placement placementOnSkin(const SkinPoint& start, const std::optional<Ray>& pointer, const glm::mat4& boneInWorld,
                          const glm::vec3& boneAxisInWorld, float characterHeight) {
  assert(!isFlat(boneInWorld));
  return placementOf(strokeOf(start, pointer, boneAxisInWorld, characterHeight), boneInWorld);
}

Result<void> beginAddMuscle(AddMuscleState& state, const ViewportContext& context, const ViewportHover& hover,
                            const glm::vec2& pixel) {
  if (!hover.skin) return errorAt("", "a muscle is added by pressing on the skin");
  Document& document = context.document;
  AddMuscleDrag drag;
  drag.anchor = *hover.skin;
  drag.bone = boneAt(*document.character, drag.anchor);
  drag.pressPixel = pixel;
  drag.selectionBefore = document.selection;
  drag.rigBefore = document.commands.sharedRig();
  if (isFlat(context.pose.boneInWorld[static_cast<std::size_t>(drag.bone)])) {
    return errorAt(document.character->skeleton.fileName(drag.bone), "this bone is scaled to nothing in this pose");
  }
  document.commands.beginGesture("Add muscle");
  if (const Result<void> shown = show(drag, context, placementNow(drag, context, std::nullopt)); !shown) {
    document.commands.cancelGesture();
    return shown.error();
  }
  state.drag = std::move(drag);
  return {};
}

void updateAddMuscle(AddMuscleState& state, const FrameInput& input, const ViewportContext& context, const View& view) {
  assert(state.drag);
  AddMuscleDrag& drag = *state.drag;
  if (input.keyPressed(Key::kEscape) || input.button(MouseButton::kRight).pressed) {
    cancelAddMuscle(state, context.document);
    return;
  }
  drag.dragged = drag.dragged || glm::length(input.mouse - drag.pressPixel) > kTremor * context.uiScale;
  if (!isFlat(context.pose.boneInWorld[static_cast<std::size_t>(drag.bone)])) {
    const std::optional<Ray> pointer = drag.dragged ? std::optional(view.rayThrough(input.mouse)) : std::nullopt;
    // A refused state is not shown: the one before stands.
    static_cast<void>(show(drag, context, placementNow(drag, context, pointer)));
  }
  if (!input.button(MouseButton::kLeft).released) return;
  context.document.commands.endGesture();
  state.drag.reset();
}

void cancelAddMuscle(AddMuscleState& state, Document& document) {
  if (!state.drag) return;
  document.commands.cancelGesture();
  document.selection = state.drag->selectionBefore;
  state.drag.reset();
}

Result<std::string> addMuscleOnBone(Document& document, int bone) {
  const Character& character = *document.character;
  const Bone& onBone = character.skeleton.bones[static_cast<std::size_t>(bone)];
  if (isFlat(onBone.bindInWorld)) {
    return errorAt(character.skeleton.fileName(bone), "this bone is scaled to nothing in the bind pose");
  }
  const glm::mat3 toWorld(onBone.bindInWorld);
  const float height = character.height;
  const glm::vec3 segment = toWorld * onBone.tip;
  const glm::vec3 origin(onBone.bindInWorld[3]);
  Stroke stroke;
  stroke.along = normalizeOr(segment, glm::vec3(0.0f, 1.0f, 0.0f));
  stroke.normal = across(stroke.along);
  stroke.center = origin + 0.5f * segment;
  const float half = std::clamp(0.45f * glm::length(segment), 0.03f * height, 0.3f * height);
  const float skin = skinDistance(character, bone, origin, stroke.along);
  const float thickness = std::clamp(skin > 0.0f ? 1.15f * skin : 0.4f * half, 0.012f * height, 0.2f * height);
  stroke.semiAxes = {half, thickness, thickness};
  const Placement placement = placementOf(stroke, onBone.bindInWorld);
  Result<Rig> rig = withMuscle(document, document.rig(), newMuscle(character.skeleton, bone, placement));
  if (!rig) return rig.error();
  const std::string name = rig->primitives[document.rig().primitives.size()].name;
  document.commands.apply("Add muscle", std::move(rig).value());
  document.selection.set(name);
  return name;
}

}  // namespace sinew::app
