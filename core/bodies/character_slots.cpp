// core/bodies/character_slots.cpp: the search, then what the file says, then what the designer knows better.
#include "core/bodies/character_slots.h"

#include <algorithm>

#include "core/character/skin_bones.h"

namespace sinew {
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

}  // namespace sinew
