// core/rig/posed_rig.h: a rig on a character in one pose: numbers, lines, and where every muscle is.
//
// Made once per pose and read by all that shows or measures a rig: the surface, shells, gizmo, picking, inspector,
// state log and exports. What is made once per edit is the RigPoser.
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

// A via point bends the muscles on its line. docs/muscles.md, Via point.

/// How a muscle takes what its via point adds to the line's shift (PosedLine::aside).
struct ViaBend {
  Placement placement;  ///< The muscle's, its y axis along the line where a plain ellipsoid's other axis was.
  float share = 0.0f;   ///< Part of the shift that is a bend; the rest moves the muscle as a whole. 0..1: 1 for a
                        ///< muscle along the line and as long as its belly.
};
/// @param boneInBind  of the bone in whose space the placement is
[[nodiscard]] ViaBend viaBend(const LineRest& rest, const Placement& placement, const glm::mat4& boneInBind);

/// What places a bent muscle in a pose.
struct BentMuscle {
  glm::mat4 carrier{1.0f};
  Placement placement;
};
/// Its middle is where the carrier that shifts it whole has it. Continuous in the shift; without one, the muscle
/// itself.
/// @param carrier  bone space in the bind pose -> world now, with the whole shift  @param shift  world
[[nodiscard]] BentMuscle bentMuscle(const ViaBend& bend, const glm::mat4& carrier, const glm::vec3& shift);

/// One muscle in a pose.
struct PosedMuscle {
  bool usable = false;      ///< False: its bone or its line's are missing or flattened; nothing of it is to be seen.
  int line = -1;            ///< Index into Rig::lines; -1: it rides its bone.
  bool isBent = false;      ///< By its line's via point: body differs from what carrier makes of the placement.
  glm::mat4 carrier{0.0f};  ///< Its bone's space in the bind pose -> world now, moved whole by the line's via point.
  BentMuscle body;          ///< As the field has it.
};

struct PosedRig {
  RigNumbers numbers;
  std::vector<PosedLine> lines;      ///< [Rig::lines]
  std::vector<PosedMuscle> muscles;  ///< [Rig::primitives]
  std::vector<float> morphWeights;   ///< [Character::morphTargets] the pose's with what the rig adds.

  // Memory kept from pose to pose; not to be read.
  DriverScratch drivers;
  LineScratch posing;
  std::vector<std::optional<LineRest>> rests;
};

/// Poses one rig on one skeleton. Immutable: several threads may share it, each with a PosedRig of its own. The same
/// pose gives the same PosedRig, whatever it held before.
class RigPoser {
 public:
  /// @param character  its skeleton must outlive this
  RigPoser(const Rig& rig, const Character& character);

  /// Allocates nothing once `out` has grown.
  void pose(const Pose& pose, PosedRig& out) const;
  [[nodiscard]] PosedRig pose(const Pose& pose) const;

  /// Without keys and drivers.
  [[nodiscard]] const RigNumbers& drawn() const { return drawn_; }
  /// Whether keys or drivers change numbers of primitives.
  [[nodiscard]] bool drivesMuscles() const { return drivesMuscles_; }

 private:
  /// What carries a primitive; -1: it is not there.
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
  std::vector<std::optional<LineRest>> rests_;  ///< [Rig::lines]
  std::vector<Ride> rides_;                     ///< [Rig::primitives]
  std::vector<float> morphWeights_;             ///< [Character::morphTargets] as in the file.
  std::vector<MorphShare> morphShares_;         ///< What numbers of the rig add to which targets.
};

}  // namespace sinew
