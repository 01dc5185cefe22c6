// core/character/body_slots.h: which bone is which part of a body.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "sinew/character/skeleton.h"
#include "sinew/geometry/geometry.h"

namespace sinew {

/// A part on either side. Named as in VRM 1.0 and Unity, with additional parts for quadrupeds.
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
  kFrontUpper,  ///< Quadrupeds: humerus; radius; below the carpus.
  kFrontLower,
  kFrontFoot,
  kHindUpper,  ///< Femur; tibia; below the hock.
  kHindLower,
  kHindFoot,
};
inline constexpr int kSlotCount = 21;
inline constexpr Slot kFirstSidedSlot = Slot::kShoulder;

enum class BodySide { kLeft, kRight };

/// A part of the body; `side` is kLeft for center parts.
struct BodySlot {
  Slot slot = Slot::kHips;
  BodySide side = BodySide::kLeft;

  [[nodiscard]] bool isSided() const { return slot >= kFirstSidedSlot; }
  friend bool operator==(const BodySlot&, const BodySlot&) = default;
};

[[nodiscard]] const char* nameOf(Slot slot);  ///< "upperArm", as in VRM.
[[nodiscard]] std::optional<Slot> slotNamed(std::string_view name);

[[nodiscard]] const std::array<BodySlot, 35>& allBodySlots();  ///< All parts, the center ones first.
[[nodiscard]] std::size_t indexOf(BodySlot slot);              ///< Index into allBodySlots().
[[nodiscard]] const char* nameOf(BodySlot slot);               ///< "hips", "upperArm.L".
[[nodiscard]] std::optional<BodySlot> bodySlotNamed(std::string_view name);

enum class BodyKind { kUnknown, kHumanoid, kQuadruped };

/// How a bone was assigned to its slot.
enum class SlotConfidence {
  kMissing,
  kPlaced,  ///< By its place in the tree alone.
  kNamed,   ///< By its name alone.
  kSure,    ///< By both.
  kGiven,   ///< By the rig.
};

/// Arguments of findBodySlots() besides the skeleton.
struct SlotHints {
  std::vector<int> twinOf;                  ///< [bones] as MirrorPlan::twinOf (core/rig/mirror.h).
  glm::vec3 planeNormal{1.0f, 0.0f, 0.0f};  ///< The mirror plane's, unit, bind pose.
  std::vector<bool> carriesSkin;            ///< [bones] skin follows the bone; empty: all.
  float height = 0.0f;                      ///< H, character units; 0: the extent of the joints.
};

/// A bone, or a piece of it where one bone is two parts.
struct SlotBone {
  int bone = -1;
  SlotConfidence confidence = SlotConfidence::kMissing;
  float from = 0.0f;  ///< Fractions of the distance from its joint to the next part's.
  float to = 1.0f;

  friend bool operator==(const SlotBone&, const SlotBone&) = default;
};

struct BodySlots {
  BodyKind kind = BodyKind::kUnknown;
  std::array<SlotBone, 35> bones;  ///< In the order of allBodySlots().
  std::vector<int> trunk;          ///< From the first bone above the hips to the parent of the arms.
  std::vector<int> neck;           ///< Between trunk and head.
  glm::vec3 left{1.0f, 0.0f, 0.0f};
  glm::vec3 forward{0.0f, 0.0f, 1.0f};

  [[nodiscard]] const SlotBone& operator[](BodySlot slot) const { return bones[indexOf(slot)]; }
  [[nodiscard]] SlotBone& operator[](BodySlot slot) { return bones[indexOf(slot)]; }
  [[nodiscard]] int boneOf(Slot slot, BodySide side = BodySide::kLeft) const { return (*this)[{slot, side}].bone; }
};

/// Finds body parts by the names of bones and their places in the bind pose. Legs are the mirrored chains that end
/// lowest, the hips carry both, arms are the other pair, trunk and neck lie between and above. A quadruped has a level
/// trunk and front limbs that reach the ground too. Unclear parts stay missing. docs/muscles.md.
[[nodiscard]] BodySlots findBodySlots(const Skeleton& skeleton, const SlotHints& hints);

[[nodiscard]] const char* nameOf(SlotConfidence confidence);  ///< "sure", "named", "placed", "missing", "given"
[[nodiscard]] const char* nameOf(BodyKind kind);              ///< "humanoid", "quadruped", "unknown"

}  // namespace sinew
