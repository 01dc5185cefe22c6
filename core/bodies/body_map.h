// core/bodies/body_map.h: the place in another body that a place in a body corresponds to, in both bind poses.
#pragma once

#include <optional>
#include <span>

#include <glm/mat3x3.hpp>

#include "core/bodies/body_frame.h"
#include "core/bodies/flesh.h"
#include "core/character/body_slots.h"
#include "core/rig/mirror.h"
#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew {

// The parts of a character's body, with what a rig says of them.

/// @param plan  of the character
/// @param corrections  of the rig: a bone that the character lacks leaves its part as it was found
[[nodiscard]] BodySlots bodySlots(const Character& character, const MirrorPlan& plan,
                                  std::span<const SlotCorrection> corrections = {});

/// A character with what is known of its body. The flesh refers to the frame: it stays where it is made.
struct MeasuredBody {
  /// @param corrections  as bodySlots()
  MeasuredBody(const Character& character, const MirrorPlan& plan, const std::vector<SlotCorrection>& corrections);
  MeasuredBody(const MeasuredBody&) = delete;
  MeasuredBody& operator=(const MeasuredBody&) = delete;

  const Character& character;
  const MirrorPlan& plan;
  BodyFrame frame;
  Flesh flesh;
};

/// Where something comes to lie, and how it is turned and stretched there. World of the bind poses.
struct BodyMove {
  glm::vec3 point{0.0f};
  glm::vec3 axis{0.0f};     ///< Where the part's axis is nearest to it.
  glm::mat3 from{1.0f};     ///< Unit axes round the place it comes from: out of the flesh, round it, along the part.
  glm::mat3 to{1.0f};       ///< The same where it comes to.
  glm::vec3 stretch{1.0f};  ///< Along these.
  bool isPulled = false;    ///< By moveInto(): it lies nearer to the axis than it would.

  [[nodiscard]] glm::mat3 turn() const { return to * glm::transpose(from); }
  /// How much longer something is that points this way. @param way  unit, where it comes from
  [[nodiscard]] float stretchAlong(const glm::vec3& way) const;
};

/// From one body to another, by the parts that both have: the same way along the part, the same angle round it, as far
/// in the local flesh. A limb goes to the limb of the same side and kind, never to another. There and back is the same
/// place where both bodies have the part.
class BodyMap {
 public:
  BodyMap(const MeasuredBody& from, const MeasuredBody& to) : from_(from), to_(to) {}

  /// The bone that is the same part, or is called the same and belongs to the same part; what belongs to no part goes
  /// by path and name alone. -1: this body has no such bone.
  [[nodiscard]] int bone(int bone) const;
  /// Of something on a bone that has a counterpart.
  [[nodiscard]] BodyMove move(int bone, const glm::vec3& inBind) const;
  /// The same for what must lie in the flesh: where that is thinner there, or ends, it lies nearer to the part's axis.
  /// What lies outside of its own body goes where move() has it. nullopt: this body has no flesh there.
  [[nodiscard]] std::optional<BodyMove> moveInto(int bone, const glm::vec3& inBind) const;

 private:
  [[nodiscard]] bool hasPart(BodySlot slot) const;
  [[nodiscard]] int byName(int bone, std::optional<Zone> zone) const;
  [[nodiscard]] int inChain(int bone, const std::vector<int>& ours, const std::vector<int>& theirs, Slot slot) const;
  [[nodiscard]] BodyMove alongPart(Slot slot, const glm::vec3& point) const;
  [[nodiscard]] BodyMove besideBone(int bone, const glm::vec3& point) const;
  /// Both bodies have the part as an axis.
  [[nodiscard]] bool isMeasured(Zone zone) const;
  [[nodiscard]] bool isOnRight(Zone zone, const glm::vec3& inBind) const;
  [[nodiscard]] std::optional<BodyMove> moved(int bone, const glm::vec3& inBind, bool into) const;
  [[nodiscard]] bool pullIn(BodyMove& move, const glm::vec3& point, bool onBothSides) const;

  const MeasuredBody& from_;
  const MeasuredBody& to_;
};

}  // namespace sinew
