// core/bodies/body_frame.h: the parts of a character as axes with a front and a side, in the bind pose.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/bodies/preset.h"
#include "core/character/body_slots.h"
#include "sinew/character/character.h"

namespace sinew {

/// The axis of a part: straight pieces from bone to bone. World.
struct PartAxis {
  std::vector<glm::vec3> points;  ///< At least two.
  std::vector<int> bones;         ///< [points - 1] whose piece it is.
  glm::vec3 front{0.0f, 0.0f, 1.0f};
  bool middle = false;  ///< Trunk or neck: they go from below to above, limbs from the trunk outwards.
  float length = 0.0f;

  [[nodiscard]] glm::vec3 point(float u) const;
  [[nodiscard]] glm::vec3 direction(float u) const;
  /// Away from the axis, unit.  @param angle  degrees
  [[nodiscard]] glm::vec3 radial(float u, float angle) const;
  [[nodiscard]] int bone(float u) const;

 private:
  struct Piece {
    std::size_t index = 0;
    float share = 0.0f;
  };
  [[nodiscard]] Piece pieceAt(float u) const;
};

/// Hips, spine and chest: their axis is one.
[[nodiscard]] constexpr bool isTrunk(Slot slot) { return slot <= Slot::kUpperChest; }

/// What belongs together in a body: the trunk as one, each part of a limb with all that hangs on it and is no part.
/// Numbers are those of allBodySlots(), kSpine for the trunk; -1: nothing.
using Zone = int;

/// Axes and zones of a character's left side and middle.
struct BodyFrame {
  BodySlots slots;
  std::array<std::optional<PartAxis>, kSlotCount> axes;  ///< By Slot: of the left side.
  std::vector<Zone> zoneOfBone;                          ///< [bones]
  float height = 1.0f;

  /// The part that a mark is measured on: an end of a limb is the end of the part before it.
  [[nodiscard]] const PartAxis* axisOf(const Mark& mark, float& u) const;
  /// The bone that a mark rides, or -1.
  [[nodiscard]] int boneOf(const Mark& mark) const;
};

[[nodiscard]] BodyFrame makeBodyFrame(const Character& character, const BodySlots& slots);

[[nodiscard]] Zone zoneOf(Slot slot, BodySide side = BodySide::kLeft);
/// The part before it, towards the trunk; itself for the trunk.
[[nodiscard]] Slot partBefore(Slot slot);
/// Zones whose skin belongs to what is measured on a part: itself and its neighbours.
[[nodiscard]] std::vector<Zone> zonesAround(Slot slot);

}  // namespace sinew
