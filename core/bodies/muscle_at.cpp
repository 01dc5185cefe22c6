// core/bodies/muscle_at.cpp: marks moved along their part and round it.
#include "core/bodies/muscle_at.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "core/bodies/part_place.h"
#include "core/geometry/at.h"

namespace sinew {
namespace {

constexpr float kOwnPlace = 0.05f;  ///< Of H: nearer than this to its own place is there.

Slot partOf(Slot slot) { return isTrunk(slot) ? Slot::kSpine : slot; }

/// Half the length between the ends of a line less its tendons, of its part: a belly needs its own without the line.
float halfLengthOf(const PresetMuscle& muscle) {
  if (muscle.halfLength > 0.0f || !muscle.origin) return muscle.halfLength;
  const Mark& from = *muscle.origin;
  const Mark& to = *muscle.insertion;
  const float way = from.slot == to.slot ? std::abs(to.u - from.u) : std::max(1.0f - from.u, 0.0f) + std::abs(to.u);
  const float belly = 1.0f - muscle.line.tendons.x - muscle.line.tendons.y;
  return std::clamp(0.5f * belly * way, kLeastHalfLength, kMostHalfLength);
}

const PartAxis* axisOf(const MeasuredBody& body, Slot slot) {
  const auto& axis = at(body.frame.axes, static_cast<int>(partOf(slot)));
  return axis ? &*axis : nullptr;
}

float turnedBy(float angle, float by) { return std::remainder(angle + by, 360.0f); }

}  // namespace

std::optional<MarkOnSkin> markOnSkin(const MeasuredBody& body, int bone, const glm::vec3& inBind) {
  const Zone zone = at(body.frame.zoneOfBone, bone);
  if (zone < 0) return std::nullopt;
  const BodySlot slot = at(allBodySlots(), zone);
  const PartAxis* axis = axisOf(body, slot.slot);
  if (axis == nullptr) return std::nullopt;
  const glm::vec3 image(reflected(body.plan.plane, glm::dvec3(inBind)));
  MarkOnSkin found;
  if (slot.isSided()) found.side = slot.side;
  else if (glm::dot(inBind - image, body.frame.slots.left) < 0.0f) found.side = BodySide::kRight;
  const PartPlace place = placeAt(*axis, found.side == BodySide::kLeft ? inBind : image, kOnAxis * body.frame.height);
  found.mark = {partOf(slot.slot), std::clamp(place.u, -kMostU, kMostU), place.angle, 0.0f};
  return found;
}

bool isOwnPlace(const PresetMuscle& muscle, const Mark& mark, const MeasuredBody& body) {
  if (partOf(mark.slot) != partOf(muscle.belly.slot)) return false;
  const auto own = body.flesh.measure(muscle.belly);
  const auto other = body.flesh.measure(mark, false);
  return own && other && glm::distance(own->at(0.0f), other->at(0.0f)) < kOwnPlace * body.frame.height;
}

PresetMuscle muscleAt(const PresetMuscle& muscle, const Mark& mark, const MeasuredBody& body) {
  if (isOwnPlace(muscle, mark, body)) return muscle;
  PresetMuscle moved = muscle;
  moved.single = false;
  moved.midline = false;
  moved.belly = {mark.slot, mark.u, mark.angle, muscle.belly.depth};
  if (partOf(mark.slot) == partOf(muscle.belly.slot)) {
    if (!moved.origin) return moved;
    const float by = mark.angle - muscle.belly.angle;
    moved.origin->angle = turnedBy(moved.origin->angle, by);
    moved.insertion->angle = turnedBy(moved.insertion->angle, by);
    return moved;
  }
  const PartAxis* ours = axisOf(body, muscle.belly.slot);
  const PartAxis* theirs = axisOf(body, mark.slot);
  moved.halfLength = halfLengthOf(muscle);
  if (ours != nullptr && theirs != nullptr)
    moved.halfLength = std::clamp(moved.halfLength * ours->length / theirs->length, kLeastHalfLength, kMostHalfLength);
  moved.origin.reset();
  moved.insertion.reset();
  moved.turn = 0.0f;
  return moved;
}

}  // namespace sinew
