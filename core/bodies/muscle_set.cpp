// core/bodies/muscle_set.cpp: a set of muscles added to a rig.
#include "core/bodies/muscle_set.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "core/bodies/fit_preset.h"
#include "core/bodies/mend.h"
#include "core/character/bone_names.h"
#include "core/geometry/at.h"
#include "core/rig/twins.h"
#include "sinew/rig/rig_edit.h"

namespace sinew {

// Marks moved along their part and round it.

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

Result<FittedPreset> addMuscleSetQuickly(Rig rig, const Preset& preset, const PresetTuning& tuning,
                                         const Motions& motions, const MirrorPlan& plan) {
  if (rig.primitives.empty()) rig.surface.skinBlend = preset.skinBlend;
  return fitPreset(std::move(rig), preset, tuning, motions.character(), plan);
}

namespace {

/// Muscles that nothing keeps in the flesh, with their twins; then groups that nothing is in any more.
void leaveOutFound(AddedSet& added, std::size_t first, std::size_t firstGroup, const Motions& motions) {
  Rig& rig = added.fitted.rig;
  std::vector<int> gone;
  const auto go = [&](int index) {
    if (index >= 0 && std::ranges::find(gone, index) == gone.end()) gone.push_back(index);
  };
  for (const Finding& finding : findingsFrom(rig, first, motions)) {
    if (std::ranges::find(gone, finding.primitive) != gone.end()) continue;
    const int twin = twinOf(rig, finding.primitive);
    const std::string& name = at(rig.primitives, twin < 0 ? finding.primitive : std::min(finding.primitive, twin)).name;
    const std::string own = withoutSide(name);
    added.fitted.leftOut.push_back({own, "it " + textOf(finding) + " in " + finding.clip});
    std::erase(added.fitted.muscles, own);
    std::erase_if(added.mended, [&](const std::string& line) { return line.starts_with(name + ":"); });
    go(finding.primitive);
    go(twin);
  }
  rig = removePrimitives(std::move(rig), gone);
  for (std::size_t i = rig.groups.size(); i-- > firstGroup;) {
    const auto isIn = [&](const Primitive& primitive) { return primitive.group == rig.groups[i].name; };
    if (std::ranges::none_of(rig.primitives, isIn))
      rig.groups.erase(rig.groups.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace

Result<AddedSet> addMuscleSet(Rig rig, const Preset& preset, const PresetTuning& tuning, const Motions& motions,
                              const MirrorPlan& plan) {
  const std::size_t first = rig.primitives.size();
  const std::size_t firstGroup = rig.groups.size();
  Result<FittedPreset> fitted = addMuscleSetQuickly(std::move(rig), preset, tuning, motions, plan);
  if (!fitted) return fitted.error();
  Result<MendedRig> mended = withMendedRig(std::move(fitted.value().rig), first, motions, &plan);
  if (!mended) return mended.error();
  fitted.value().rig = std::move(mended.value().rig);
  AddedSet added{std::move(fitted).value(), std::move(mended.value().said)};
  leaveOutFound(added, first, firstGroup, motions);
  return added;
}

}  // namespace sinew
