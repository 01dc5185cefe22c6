// core/rig/posed_rig.h: a rig on a character in one pose: its numbers, lines and muscles.
//
// A RigPoser is made once per edit, a PosedRig once per pose and read by everything that shows or measures a rig.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/rig/driver_input.h"
#include "core/rig/field.h"
#include "core/rig/line_pose.h"
#include "core/rig/rig_edit.h"
#include "sinew/character/character.h"

namespace sinew {

/// How much a muscle bends with the shift by a via point (PosedLine::aside). docs/muscles.md, Via point.
struct ViaBend {
  Placement placement;  ///< The muscle's; for a plain ellipsoid with y as the axis nearest to the line.
  float share = 0.0f;  ///< Fraction of the shift that bends, 0..1; the rest moves the muscle as a whole. 1 for a muscle
                       ///< along the line and as long as its belly.
};
/// @param boneInBind  of the placement's bone
[[nodiscard]] ViaBend viaBend(const LineRest& rest, const Placement& placement, const glm::mat4& boneInBind);

struct BentMuscle {
  glm::mat4 carrier{1.0f};
  Placement placement;
};
/// The middle of the muscle is where the carrier moves it. Continuous in the shift; without shift the muscle itself.
/// @param carrier  bone space in the bind pose -> world now, with the whole shift  @param shift  world
[[nodiscard]] BentMuscle bentMuscle(const ViaBend& bend, const glm::mat4& carrier, const glm::vec3& shift);

struct PosedMuscle {
  bool usable = false;      ///< False: its bone or those of its line are missing or flat; it is invisible.
  int line = -1;            ///< Index into Rig::lines, or -1.
  bool isBent = false;      ///< By its line's via point; then `body` differs from the placement moved by `carrier`.
  glm::mat4 carrier{0.0f};  ///< Bone space in the bind pose -> world now, with the whole shift by a via point.
  BentMuscle body;          ///< The muscle in the field.
};

struct PosedRig {
  RigNumbers numbers;
  std::vector<PosedLine> lines;      ///< [Rig::lines]
  std::vector<PosedMuscle> muscles;  ///< [Rig::primitives]
  std::vector<float> morphWeights;   ///< [Character::morphTargets] the pose's plus the rig's.

  // Memory that is reused from pose to pose.
  DriverScratch drivers;
  LineScratch posing;
  std::vector<std::optional<LineRest>> rests;
};

/// Poses one rig on one skeleton. Immutable, so that several threads may share it, each with its own PosedRig.
class RigPoser {
 public:
  RigPoser(const Rig& rig, const Character& character);  ///< @param character  its skeleton must outlive this

  void pose(const Pose& pose, PosedRig& out) const;  ///< Allocates nothing once `out` has grown.
  [[nodiscard]] PosedRig pose(const Pose& pose) const;

  [[nodiscard]] const RigNumbers& drawn() const { return drawn_; }  ///< The numbers without keys and drivers.
  /// Whether keys or drivers change numbers of primitives.
  [[nodiscard]] bool drivesMuscles() const { return drivesMuscles_; }
  [[nodiscard]] bool drivesLinks() const { return drivesLinks_; }  ///< The same of links.

 private:
  /// Bone and line of a primitive; -1: none.
  struct Ride {
    int bone = -1;
    int line = -1;
  };
  struct MorphShare {
    int target = 0;
    int morph = 0;  ///< Index into Rig::morphs.
    float share = 1.0f;
  };
  void poseLines(const Pose& pose, PosedRig& out) const;
  [[nodiscard]] PosedMuscle posedMuscle(const Ride& ride, const Placement& placement, const Pose& pose,
                                        const PosedRig& in) const;

  const Skeleton* skeleton_;
  RigNumbers drawn_;
  DrivenNumbers driven_;
  bool drivesMuscles_;
  bool drivesLines_;
  bool drivesLinks_;
  std::vector<std::optional<LineRest>> rests_;  ///< [Rig::lines]
  std::vector<Ride> rides_;                     ///< [Rig::primitives]
  std::vector<float> morphWeights_;             ///< [Character::morphTargets] as in the file.
  std::vector<MorphShare> morphShares_;
};

}  // namespace sinew
