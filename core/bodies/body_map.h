// core/bodies/body_map.h: the place in another body that a place in a body corresponds to, in both bind poses.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>

#include "core/bodies/body_frame.h"
#include "core/character/body_slots.h"
#include "core/rig/mirror.h"
#include "sinew/character/character.h"
#include "sinew/rig/rig.h"

namespace sinew {

// How thick a character's flesh is round the axes of its parts, in the bind pose.

/// Where a ray leaves the skin of a part.
struct SkinExit {
  float distance = 0.0f;   ///< Along the ray.
  glm::vec3 normal{0.0f};  ///< Of the triangle, unit, outwards.
  int triangle = -1;
  glm::vec3 barycentric{0.0f};
};

/// A place on the skin as a mark finds it. World.
struct FleshPoint {
  glm::vec3 axis{0.0f};    ///< The point of the axis.
  glm::vec3 radial{0.0f};  ///< Unit, from there to the skin.
  float thickness = 0.0f;  ///< From axis to skin, the local flesh t.
  float size = 0.0f;       ///< The same within 0.6 to 1.5 of the part's median: what sizes are measured by.
  glm::vec3 normal{0.0f};  ///< Of the skin round about, unit.
  float edge = 0.0f;       ///< Mean length of the mesh's edges there.

  [[nodiscard]] glm::vec3 at(float depth) const { return axis + (1.0f - depth) * thickness * radial; }
};

/// The skin of a character, to measure a frame's parts in.
class Flesh {
 public:
  /// Moves the frame's trunk half way between front and back.
  Flesh(const Character& character, BodyFrame& frame);

  /// nullopt: the part is missing or has no skin there.
  /// @param onSkin  false: for a place inside, where the part's median does as well
  [[nodiscard]] std::optional<FleshPoint> measure(const Mark& mark, bool onSkin = true) const;
  /// The last exit of a ray from the skin of these zones: cloth is over skin.
  /// @param usual  what comes out farther away than this belongs to another limb, unless it is the first exit
  [[nodiscard]] std::optional<SkinExit> leave(const glm::vec3& from, const glm::vec3& direction,
                                              const std::vector<Zone>& zones,
                                              float usual = std::numeric_limits<float>::max()) const;
  /// The skin goes round the point: between the parts of a body that is made of parts it does not.
  [[nodiscard]] bool isInside(const glm::vec3& point) const;

 private:
  [[nodiscard]] std::optional<float> thicknessAt(const PartAxis& axis, float u, float angle,
                                                 const std::vector<Zone>& zones, float usual) const;
  /// Of the neighbours' skin: nothing beyond what is usual.
  [[nodiscard]] std::optional<SkinExit> usualExit(const FleshPoint& place, const std::vector<Zone>& zones,
                                                  float usual) const;
  void centerTrunk(PartAxis& trunk) const;
  void measureMedians();

  /// A triangle with its corners beside each other in memory: rays and solid angles look at very many.
  struct Piece {
    std::array<glm::vec3, 3> corners;
    int triangle = -1;
  };

  const Character& character_;
  BodyFrame& frame_;
  std::vector<Piece> skin_;
  std::vector<std::vector<Piece>> skinOfZone_;  ///< [zones]
  std::array<float, kSlotCount> medians_{};     ///< By Slot; 0: not known.
};

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
