// core/bodies/body_map.cpp: cylinder coordinates round the axis of a part, measured by the flesh of either body.
#include "core/bodies/body_map.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/bodies/fit_preset.h"
#include "core/character/bindings.h"
#include "core/geometry/at.h"

namespace sinew {

// The search, then what the file says, then what the designer knows better.

namespace {

/// A limb that the designer names says what body it is of.
BodyKind kindOf(Slot slot) {
  if (slot >= Slot::kFrontUpper) return BodyKind::kQuadruped;
  return slot >= Slot::kUpperArm ? BodyKind::kHumanoid : BodyKind::kUnknown;
}

}  // namespace

BodySlots bodySlots(const Character& character, const MirrorPlan& plan, std::span<const SlotCorrection> corrections) {
  SlotHints hints;
  hints.twinOf = plan.twinOf;
  hints.planeNormal = glm::vec3(plan.plane.normal);
  hints.carriesSkin = bonesWithSkin(character);
  hints.height = character.height;
  BodySlots slots = findBodySlots(character.skeleton, hints);
  // The file knows its own bones: what the search made of them, and an animal's limbs, go.
  for (SlotBone& found : slots.bones) {
    const bool named = std::ranges::count(character.bodyParts, found.bone, &BodyPart::bone) > 0;
    if (found.bone >= 0 && named) found = {};
  }
  for (const BodySlot slot : allBodySlots()) {
    if (!character.bodyParts.empty() && slot.slot >= Slot::kFrontUpper) slots[slot] = {};
  }
  for (const BodyPart& part : character.bodyParts) {
    slots[bodySlotNamed(part.slot).value()] = {part.bone, SlotConfidence::kSure};
    slots.kind = BodyKind::kHumanoid;
  }
  for (const auto& [name, boneName] : corrections) {
    const std::optional<BodySlot> slot = bodySlotNamed(name);
    if (!slot) continue;
    if (boneName.empty()) {
      slots[*slot] = {-1, SlotConfidence::kGiven};
    } else if (const std::optional<int> bone = character.skeleton.findBone(boneName)) {
      slots[*slot] = {*bone, SlotConfidence::kGiven};
      if (kindOf(slot->slot) != BodyKind::kUnknown) slots.kind = kindOf(slot->slot);
    }
  }
  return slots;
}

namespace {

constexpr float kBeyond = 0.1f;      ///< Flesh is measured so far beyond the ends of a part.
constexpr int kPulls = 16;           ///< Steps to the axis.
constexpr float kUnderSkin = 0.85f;  ///< Of the way from the axis to where the flesh ends.
constexpr float kRounder = 2.0f;     ///< On a part so much shorter muscles get no rounder: they would be balls.

BodySlots slotsOf(const Character& character, const MirrorPlan& plan, const std::vector<SlotCorrection>& corrections) {
  return bodySlots(character, plan, corrections);
}

BodySlot slotOf(Zone zone) { return at(allBodySlots(), zone); }

glm::vec3 joint(const Character& character, int bone) {
  return glm::vec3(at(character.skeleton.bones, bone).bindInWorld[3]);
}

/// Across the mirror plane.
glm::vec3 mirrored(const MirrorPlan& plan, const glm::vec3& point) {
  return glm::vec3(reflected(plan.plane, glm::dvec3(point)));
}
glm::mat3 mirrored(const MirrorPlan& plan, const glm::mat3& axes) {
  const glm::vec3 normal(plan.plane.normal);
  glm::mat3 image;
  for (glm::length_t i = 0; i < 3; ++i) image[i] = axes[i] - 2.0f * glm::dot(axes[i], normal) * normal;
  return image;
}

}  // namespace

MeasuredBody::MeasuredBody(const Character& body, const MirrorPlan& mirror,
                           const std::vector<SlotCorrection>& corrections)
    : character(body),
      plan(mirror),
      frame(makeBodyFrame(body, slotsOf(body, mirror, corrections))),
      flesh(body, frame) {}

float BodyMove::stretchAlong(const glm::vec3& way) const {
  // The geometric mean, weighted: there and back it cancels, whichever way the axis points.
  float sum = 0.0f;
  for (glm::length_t i = 0; i < 3; ++i) {
    const float share = glm::dot(way, from[i]);
    sum += share * share * std::log(stretch[i]);
  }
  return std::exp(sum);
}

bool BodyMap::hasPart(BodySlot slot) const {
  // A collar bone is no shoulder blade: between kinds only what lies in the middle is the same.
  const bool sameKind = from_.frame.slots.kind == to_.frame.slots.kind;
  if (slot.isSided() && !sameKind) return false;
  return to_.frame.slots[slot].bone >= 0;
}

int BodyMap::byName(int bone, std::optional<Zone> zone) const {
  const Bone& own = at(from_.character.skeleton.bones, bone);
  for (const std::string* name : {&own.path, &own.name}) {
    const std::optional<int> found = to_.character.skeleton.findBone(*name);
    if (found && (!zone || at(to_.frame.zoneOfBone, *found) == *zone)) return *found;
  }
  return -1;
}

/// Of two chains with as many bones the same in order, else the one that lies at the same level of the part.
int BodyMap::inChain(int bone, const std::vector<int>& ours, const std::vector<int>& theirs, Slot slot) const {
  const auto found = std::ranges::find(ours, bone);
  if (found == ours.end() || theirs.empty()) return -1;
  if (ours.size() == theirs.size()) return theirs[static_cast<std::size_t>(found - ours.begin())];
  const auto& axis = at(from_.frame.axes, static_cast<int>(slot));
  const auto& other = at(to_.frame.axes, static_cast<int>(slot));
  if (!axis || !other) return theirs.front();
  const Bone& own = at(from_.character.skeleton.bones, bone);
  const glm::vec3 middle(own.bindInWorld * glm::vec4(0.5f * own.tip, 1.0f));
  const float u = placeAt(*axis, middle, 0.0f).u;
  const auto level = [&](int each) { return placeAt(*other, joint(to_.character, each), 0.0f).u; };
  int best = theirs.front();
  for (const int each : theirs) {
    if (level(each) <= u) best = each;
  }
  return best;
}

int BodyMap::bone(int bone) const {
  const Zone zone = at(from_.frame.zoneOfBone, bone);
  if (zone < 0) return byName(bone, std::nullopt);
  const BodySlots& ours = from_.frame.slots;
  const BodySlots& theirs = to_.frame.slots;
  const BodySlot slot = slotOf(zone);
  if (slot.slot == Slot::kSpine) {
    if (theirs.boneOf(Slot::kHips) < 0) return byName(bone, std::nullopt);
    if (bone == ours.boneOf(Slot::kHips)) return theirs.boneOf(Slot::kHips);
    if (const int same = inChain(bone, ours.trunk, theirs.trunk, Slot::kSpine); same >= 0) return same;
    if (const int same = byName(bone, zone); same >= 0) return same;
    const int parent = at(from_.character.skeleton.bones, bone).parent;
    return parent >= 0 && at(from_.frame.zoneOfBone, parent) == zone ? this->bone(parent) : theirs.boneOf(Slot::kHips);
  }
  if (!hasPart(slot)) return -1;
  if (bone == ours[slot].bone) return theirs[slot].bone;
  if (slot.slot == Slot::kNeck) {
    if (const int same = inChain(bone, ours.neck, theirs.neck, Slot::kNeck); same >= 0) return same;
  }
  const int same = byName(bone, zone);
  return same >= 0 ? same : theirs[slot].bone;
}

/// Of the left side.
BodyMove BodyMap::alongPart(Slot slot, const glm::vec3& point) const {
  const PartAxis& ours = *at(from_.frame.axes, static_cast<int>(slot));
  const PartAxis& theirs = *at(to_.frame.axes, static_cast<int>(slot));
  const auto [u, angle, away, beside] = placeAt(ours, point, kOnAxis * from_.frame.height);
  const Mark mark{slot, std::clamp(u, -kBeyond, 1.0f + kBeyond), angle, 0.0f};
  const auto flesh = from_.flesh.measure(mark, false);
  const auto other = to_.flesh.measure(mark, false);
  const float along = theirs.length / ours.length;
  float deep = to_.frame.height / from_.frame.height;
  float across = deep;
  if (flesh && other) {
    deep = other->thickness / flesh->thickness;
    across = std::min(other->size / flesh->size, kRounder * along);
  }
  BodyMove move;
  move.from = axesAt(ours, u, angle);
  move.to = axesAt(theirs, u, angle);
  move.stretch = {across, across, along};
  move.axis = theirs.point(u);
  move.point = theirs.point(u) + deep * away * move.to[0] + along * beside * move.to[2];
  return move;
}

/// Where a part has no axis: as the bone points, and by the bodies' sizes.
BodyMove BodyMap::besideBone(int bone, const glm::vec3& point) const {
  const int counterpart = this->bone(bone);
  const auto basisOf = [](const MeasuredBody& body, int which) {
    const Bone& own = at(body.character.skeleton.bones, which);
    const glm::vec3 along = normalizeOr(glm::mat3(own.bindInWorld) * own.tip, {0.0f, 1.0f, 0.0f});
    const glm::vec3& front = body.frame.slots.forward;
    glm::vec3 ahead = front - glm::dot(front, along) * along;
    if (glm::length(ahead) < 0.3f) ahead = glm::vec3(0, 1, 0) - along.y * along;
    ahead = glm::normalize(ahead);
    return glm::mat3(ahead, glm::cross(along, ahead), along);
  };
  BodyMove move;
  move.from = basisOf(from_, bone);
  move.to = basisOf(to_, counterpart);
  const float size = to_.frame.height / from_.frame.height;
  move.stretch = glm::vec3(size);
  move.axis = joint(to_.character, counterpart);
  move.point = move.axis + size * (move.turn() * (point - joint(from_.character, bone)));
  return move;
}

bool BodyMap::isMeasured(Zone zone) const {
  if (zone < 0) return false;
  const auto index = static_cast<int>(slotOf(zone).slot);
  return at(from_.frame.axes, index) && at(to_.frame.axes, index);
}

bool BodyMap::isOnRight(Zone zone, const glm::vec3& inBind) const {
  const BodySlot slot = slotOf(zone);
  if (slot.isSided()) return slot.side == BodySide::kRight;
  return glm::dot(inBind - mirrored(from_.plan, inBind), from_.frame.slots.left) < 0.0f;
}

/// Towards the axis until the skin goes round it, and where twins lie round its image: no mesh is quite symmetric.
bool BodyMap::pullIn(BodyMove& move, const glm::vec3& point, bool onBothSides) const {
  const auto isInside = [&](const glm::vec3& place) {
    return to_.flesh.isInside(place) && (!onBothSides || to_.flesh.isInside(mirrored(to_.plan, place)));
  };
  if (isInside(move.point) || !from_.flesh.isInside(point)) return true;
  const auto towardsAxis = [&](float share) { return glm::mix(move.axis, move.point, share); };
  for (int step = kPulls - 1; step >= 0; --step) {
    const float share = static_cast<float>(step) / kPulls;
    if (!isInside(towardsAxis(share))) continue;
    const bool deeper = isInside(towardsAxis(kUnderSkin * share));
    move.point = towardsAxis(deeper ? kUnderSkin * share : share);
    move.isPulled = true;
    return true;
  }
  return false;
}

std::optional<BodyMove> BodyMap::moved(int bone, const glm::vec3& inBind, bool into) const {
  const Zone zone = at(from_.frame.zoneOfBone, bone);
  const bool measured = isMeasured(zone);
  // Twins stay twins where the flesh is not the same on both sides: all is measured on the left.
  const bool onRight = measured && isOnRight(zone, inBind);
  const glm::vec3 point = onRight ? mirrored(from_.plan, inBind) : inBind;
  BodyMove move = measured ? alongPart(slotOf(zone).slot, point) : besideBone(bone, point);
  if (into && !pullIn(move, point, measured)) return std::nullopt;
  if (!onRight) return move;
  move.point = mirrored(to_.plan, move.point);
  move.axis = mirrored(to_.plan, move.axis);
  move.from = mirrored(from_.plan, move.from);
  move.to = mirrored(to_.plan, move.to);
  return move;
}

BodyMove BodyMap::move(int bone, const glm::vec3& inBind) const { return *moved(bone, inBind, false); }

std::optional<BodyMove> BodyMap::moveInto(int bone, const glm::vec3& inBind) const { return moved(bone, inBind, true); }

}  // namespace sinew
