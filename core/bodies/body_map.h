// core/bodies/body_map.h: measures bodies and maps places of one body to another, in the bind poses.
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

/// Where a ray leaves the skin of a part.
struct SkinExit {
  float distance = 0.0f;   ///< Along the ray.
  glm::vec3 normal{0.0f};  ///< The triangle's, unit, outwards.
  int triangle = -1;
  glm::vec3 barycentric{0.0f};
};

/// A place on the skin that a mark refers to. World.
struct FleshPoint {
  glm::vec3 axis{0.0f};    ///< Point on the axis.
  glm::vec3 radial{0.0f};  ///< Unit, from there to the skin.
  float thickness = 0.0f;  ///< From axis to skin, the local flesh t.
  float size = 0.0f;       ///< Thickness limited to 0.6..1.5 of the part's median, to which sizes are relative.
  glm::vec3 normal{0.0f};  ///< Mean normal of the skin around it, unit.
  float edge = 0.0f;       ///< Mean length of the mesh's edges there.

  [[nodiscard]] glm::vec3 at(float depth) const { return axis + (1.0f - depth) * thickness * radial; }
};

/// Thickness of a character's flesh around the axes of its parts, in the bind pose.
class Flesh {
 public:
  /// Moves the axis of the frame's trunk half way between front and back.
  Flesh(const Character& character, BodyFrame& frame);

  /// nullopt: no part, or no skin there. @param onSkin  false: without skin, the part's median thickness is good enough
  [[nodiscard]] std::optional<FleshPoint> measure(const Mark& mark, bool onSkin = true) const;
  /// The last exit of a ray from the skin of these zones, since cloth lies over skin.
  /// @param usual  farther exits belong to another limb and count only if there is no nearer one
  [[nodiscard]] std::optional<SkinExit> leave(const glm::vec3& from, const glm::vec3& direction,
                                              const std::vector<Zone>& zones,
                                              float usual = std::numeric_limits<float>::max()) const;
  [[nodiscard]] bool isInside(const glm::vec3& point) const;  ///< The skin encloses the point.

 private:
  [[nodiscard]] std::optional<float> thicknessAt(const PartAxis& axis, float u, float angle,
                                                 const std::vector<Zone>& zones, float usual) const;
  /// An exit from the skin of neighbours, within the usual distance.
  [[nodiscard]] std::optional<SkinExit> usualExit(const FleshPoint& place, const std::vector<Zone>& zones,
                                                  float usual) const;
  void centerTrunk(PartAxis& trunk) const;
  void measureMedians();

  /// A triangle with its corners contiguous in memory, for speed.
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

/// The body parts of a character: as found, replaced by those in its file, then by the rig's corrections.
/// @param corrections  of the rig; those with a bone that the character lacks are ignored
[[nodiscard]] BodySlots bodySlots(const Character& character, const MirrorPlan& plan,
                                  std::span<const SlotCorrection> corrections = {});

/// A character with the measures of its body. Neither copied nor moved, since `flesh` refers to `frame`.
struct MeasuredBody {
  MeasuredBody(const Character& character, const MirrorPlan& plan, const std::vector<SlotCorrection>& corrections);
  MeasuredBody(const MeasuredBody&) = delete;
  MeasuredBody& operator=(const MeasuredBody&) = delete;

  const Character& character;
  const MirrorPlan& plan;
  BodyFrame frame;
  Flesh flesh;
};

/// The new place of something, and its rotation and stretch there. World of the bind poses.
struct BodyMove {
  glm::vec3 point{0.0f};
  glm::vec3 axis{0.0f};     ///< Nearest point of the part's axis.
  glm::mat3 from{1.0f};     ///< Unit axes at the old place: out of the flesh, around the part, along it.
  glm::mat3 to{1.0f};       ///< The same at the new place.
  glm::vec3 stretch{1.0f};  ///< Along these axes.
  bool isPulled = false;    ///< moveInto() has moved it towards the axis.

  [[nodiscard]] glm::mat3 turn() const { return to * glm::transpose(from); }
  /// Factor on lengths in a direction. @param way  unit, at the old place
  [[nodiscard]] float stretchAlong(const glm::vec3& way) const;
};

/// Maps one body to another by the parts that both have: the same fraction along the part, the same angle around it and
/// the same fraction of the local flesh. A limb maps only to the limb of the same side and kind. Mapping there and back
/// gives the same place where both bodies have the part.
class BodyMap {
 public:
  BodyMap(const MeasuredBody& from, const MeasuredBody& to) : from_(from), to_(to) {}

  /// The bone that is the same part, or has the same name and belongs to the same part; bones of no part are found by
  /// path and name alone. -1: the other body has no such bone.
  [[nodiscard]] int bone(int bone) const;
  [[nodiscard]] BodyMove move(int bone, const glm::vec3& inBind) const;  ///< @param bone  has a counterpart
  /// move() for what must lie in the flesh: pulled towards the part's axis until it does, unless it lies outside its
  /// own body already. nullopt: the other body has no flesh there.
  [[nodiscard]] std::optional<BodyMove> moveInto(int bone, const glm::vec3& inBind) const;

 private:
  [[nodiscard]] bool hasPart(BodySlot slot) const;
  [[nodiscard]] int byName(int bone, std::optional<Zone> zone) const;
  [[nodiscard]] int inChain(int bone, const std::vector<int>& ours, const std::vector<int>& theirs, Slot slot) const;
  [[nodiscard]] BodyMove alongPart(Slot slot, const glm::vec3& point) const;
  [[nodiscard]] BodyMove besideBone(int bone, const glm::vec3& point) const;
  [[nodiscard]] bool isMeasured(Zone zone) const;  ///< Both bodies have an axis for the part.
  [[nodiscard]] bool isOnRight(Zone zone, const glm::vec3& inBind) const;
  [[nodiscard]] std::optional<BodyMove> moved(int bone, const glm::vec3& inBind, bool into) const;
  [[nodiscard]] bool pullIn(BodyMove& move, const glm::vec3& point, bool onBothSides) const;

  const MeasuredBody& from_;
  const MeasuredBody& to_;
};

}  // namespace sinew
