// core/bodies/body_frame.h: the parts of a character as axes with a front and a side, in the bind pose.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/bodies/preset.h"
#include "core/character/body_slots.h"
#include "sinew/character/character.h"

namespace sinew {

/// The axis of a body part: straight pieces from bone to bone. World.
struct PartAxis {
  std::vector<glm::vec3> points;  ///< At least two.
  std::vector<int> bones;         ///< [points - 1] bone of each piece.
  glm::vec3 front{0.0f, 0.0f, 1.0f};
  bool middle = false;  ///< Trunk or neck, which run upwards; limbs run outwards from the trunk.
  float length = 0.0f;

  [[nodiscard]] glm::vec3 point(float u) const;
  [[nodiscard]] glm::vec3 direction(float u) const;
  [[nodiscard]] glm::vec3 radial(float u, float angle) const;  ///< Away from the axis, unit.  @param angle  degrees
  [[nodiscard]] int bone(float u) const;

 private:
  struct Piece {
    std::size_t index = 0;
    float share = 0.0f;
  };
  [[nodiscard]] Piece pieceAt(float u) const;
};

/// Hips, spine and chest share one axis.
[[nodiscard]] constexpr bool isTrunk(Slot slot) { return slot <= Slot::kUpperChest; }

/// A region of the body: the whole trunk, or a part of a limb with all bones below it that are no part themselves.
/// Numbered as allBodySlots(), kSpine for the trunk; -1: none.
using Zone = int;

/// Axes and zones of a character's left side and middle.
struct BodyFrame {
  BodySlots slots;
  std::array<std::optional<PartAxis>, kSlotCount> axes;  ///< By Slot: of the left side.
  std::vector<Zone> zoneOfBone;                          ///< [bones]
  float height = 1.0f;

  /// The axis on which a mark is measured: the start of a hand or foot is the end of the part before it. @param u  out
  [[nodiscard]] const PartAxis* axisOf(const Mark& mark, float& u) const;
  [[nodiscard]] int boneOf(const Mark& mark) const;  ///< The bone that a mark rides, or -1.
};

[[nodiscard]] BodyFrame makeBodyFrame(const Character& character, const BodySlots& slots);

[[nodiscard]] Zone zoneOf(Slot slot, BodySide side = BodySide::kLeft);
[[nodiscard]] Slot partBefore(Slot slot);  ///< The next part towards the trunk; kSpine for the trunk.
/// Zones whose skin counts when flesh is measured on a part: its own and those of its neighbours.
[[nodiscard]] std::vector<Zone> zonesAround(Slot slot);

}  // namespace sinew
