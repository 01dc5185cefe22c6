// core/character/body_slot.cpp: the names of body slots.
#include "core/character/body_slot.h"

#include <algorithm>
#include <string>

namespace sinew {
namespace {

constexpr std::array<const char*, kSlotCount> kNames{
    "hips",     "spine",      "chest",      "upperChest", "neck",      "head",      "tail",
    "shoulder", "upperArm",   "lowerArm",   "hand",       "upperLeg",  "lowerLeg",  "foot",
    "toes",     "frontUpper", "frontLower", "frontFoot",  "hindUpper", "hindLower", "hindFoot"};
constexpr int kCenterSlots = static_cast<int>(kFirstSidedSlot);
constexpr std::size_t kBodySlots = kCenterSlots + 2 * (kSlotCount - kCenterSlots);

std::array<std::string, kBodySlots> makeNames() {
  std::array<std::string, kBodySlots> names;
  for (std::size_t i = 0; i < kBodySlots; ++i) {
    const BodySlot slot = allBodySlots()[i];
    names[i] = nameOf(slot.slot);
    if (slot.isSided()) names[i] += slot.side == BodySide::kLeft ? ".L" : ".R";
  }
  return names;
}

}  // namespace

const char* nameOf(Slot slot) { return kNames[static_cast<std::size_t>(slot)]; }

std::optional<Slot> slotNamed(std::string_view name) {
  const auto found = std::ranges::find(kNames, name, [](const char* text) { return std::string_view(text); });
  if (found == kNames.end()) return std::nullopt;
  return static_cast<Slot>(found - kNames.begin());
}

const std::array<BodySlot, kBodySlots>& allBodySlots() {
  static const std::array<BodySlot, kBodySlots> slots = [] {
    std::array<BodySlot, kBodySlots> all;
    for (int i = 0; i < kSlotCount; ++i) {
      const auto slot = static_cast<Slot>(i);
      const BodySlot left{slot, BodySide::kLeft};
      all[indexOf(left)] = left;
      if (left.isSided()) all[indexOf({slot, BodySide::kRight})] = {slot, BodySide::kRight};
    }
    return all;
  }();
  return slots;
}

std::size_t indexOf(BodySlot slot) {
  const int number = static_cast<int>(slot.slot);
  if (!slot.isSided()) return static_cast<std::size_t>(number);
  const int right = slot.side == BodySide::kRight ? 1 : 0;
  return static_cast<std::size_t>(kCenterSlots + 2 * (number - kCenterSlots) + right);
}

const char* nameOf(BodySlot slot) {
  static const std::array<std::string, kBodySlots> names = makeNames();
  return names[indexOf(slot)].c_str();
}

std::optional<BodySlot> bodySlotNamed(std::string_view name) {
  for (const BodySlot& slot : allBodySlots()) {
    if (nameOf(slot) == name) return slot;
  }
  return std::nullopt;
}

}  // namespace sinew
