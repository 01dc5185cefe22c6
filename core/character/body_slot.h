// core/character/body_slot.h: the parts of a body that presets speak of, and their names in files.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace sinew {

/// A part, whichever side it is on. After the names of VRM 1.0, which are those of Unity; quadrupeds have their own.
enum class Slot {
  kHips,
  kSpine,
  kChest,
  kUpperChest,
  kNeck,
  kHead,
  kTail,
  kShoulder,  ///< Clavicle or scapula.
  kUpperArm,
  kLowerArm,
  kHand,
  kUpperLeg,
  kLowerLeg,
  kFoot,
  kToes,
  kFrontUpper,  ///< Of quadrupeds: humerus; radius; what lies below the carpus.
  kFrontLower,
  kFrontFoot,
  kHindUpper,  ///< Femur; tibia; what lies below the hock.
  kHindLower,
  kHindFoot,
};
inline constexpr int kSlotCount = 21;
inline constexpr Slot kFirstSidedSlot = Slot::kShoulder;

enum class BodySide { kLeft, kRight };

/// A part of the body. Center parts have no side: theirs is kLeft.
struct BodySlot {
  Slot slot = Slot::kHips;
  BodySide side = BodySide::kLeft;

  [[nodiscard]] bool isSided() const { return slot >= kFirstSidedSlot; }
  friend bool operator==(const BodySlot&, const BodySlot&) = default;
};

/// "upperArm", as VRM calls it.
[[nodiscard]] const char* nameOf(Slot slot);
[[nodiscard]] std::optional<Slot> slotNamed(std::string_view name);

/// All parts, the center ones first.
[[nodiscard]] const std::array<BodySlot, 35>& allBodySlots();
/// Index into allBodySlots().
[[nodiscard]] std::size_t indexOf(BodySlot slot);
/// "hips", "upperArm.L".
[[nodiscard]] const char* nameOf(BodySlot slot);
[[nodiscard]] std::optional<BodySlot> bodySlotNamed(std::string_view name);

}  // namespace sinew
