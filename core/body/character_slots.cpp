// core/body/character_slots.cpp: the search, then what the designer knows better.
#include "core/body/character_slots.h"

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
