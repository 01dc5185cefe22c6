// core/rig/driver_input.h: inputs of drivers, resolved on a character and measured in its poses.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/rig/line_pose.h"
#include "core/rig/rig_edit.h"
#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// Degrees between the directions of a bone and its parent, minus the same in the bind pose; for a root from its
/// direction in the bind pose. Continuous in the pose. 0 for a flat bone. docs/muscles.md.
[[nodiscard]] float bendOf(const Skeleton& skeleton, const Pose& pose, int bone);

/// The direction of a bone in its turn frame (core/character/pose_override.h), unit.
[[nodiscard]] glm::vec3 boneDirection(const Bone& bone);

/// Degrees of a turn's twist about an axis (swing and twist), -180..180. Jumps only at half turns. @param axis  unit
[[nodiscard]] float turnAbout(const glm::quat& turn, const glm::vec3& axis);

/// exp(-angle^2 / (2 width^2)) of the rotation between two turns; 1 if they are equal. @param width  degrees
[[nodiscard]] float nearness(const glm::quat& turn, const glm::quat& wanted, float width);

/// A resolved input.
struct FoundInput {
  DriverInputKind kind = DriverInputKind::kBend;
  int bone = -1;
  glm::vec3 axis{1.0f, 0.0f, 0.0f};  ///< In the turn frame.
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
  float width = kDefaultPoseWidth;
  int line = -1;                 ///< Index into Rig::lines.
  std::vector<KeyTrack> tracks;  ///< The channel's.
  BonePoint from;
  BonePoint to;
  double distanceInBind = 1.0;
};

/// nullopt: the character lacks one of its bones, its line is unusable, or its points coincide in the bind pose.
[[nodiscard]] std::optional<FoundInput> foundInput(const DriverInput& input, const Rig& rig,
                                                   const Character& character);

/// Memory that is reused from pose to pose.
struct InputScratch {
  std::vector<std::optional<glm::quat>> turnOf;  ///< [bones] cache for one pose.
};

/// @param lines  [Rig::lines] without drivers; only the input's is read  @param scratch  turnOf of this pose, or empty
[[nodiscard]] float valueOf(const FoundInput& input, const Skeleton& skeleton, const Pose& pose,
                            std::span<const PosedLine> lines, InputScratch& scratch);

/// One input in one pose, for display. nullopt: see foundInput().
[[nodiscard]] std::optional<float> inputNow(const DriverInput& input, const Rig& rig, const Character& character,
                                            const Pose& pose);

/// Memory that is reused from pose to pose.
struct DriverScratch {
  std::vector<PosedLine> lines;  ///< [Rig::lines] that inputs read.
  LineScratch posing;
  InputScratch inputs;
};

/// The numbers of a rig with keys and drivers. Made once per edit, applied once per pose. Lines are measured without
/// drivers, and no driver reads the result of another. Drivers whose input the character lacks are left out.
class DrivenNumbers {
 public:
  DrivenNumbers() = default;
  DrivenNumbers(const Rig& rig, const Character& character);

  [[nodiscard]] bool isEmpty() const { return numbers_.empty(); }
  [[nodiscard]] bool changes(ParameterOwner owner) const;  ///< Whether any number belongs to an owner of this kind.
  /// @param numbers  in: as drawn (drawnNumbers); out: in the pose
  void apply(const Pose& pose, const Skeleton& skeleton, DriverScratch& scratch, RigNumbers& numbers) const;

 private:
  struct Join {
    FoundInput input;
    Curve curve;
    DriverMode mode = DriverMode::kAdd;
  };
  struct Number {
    NumberRef ref;
    std::vector<KeyTrack> keys;
    std::vector<Join> drivers;
  };
  void add(const std::vector<AnimatedNumber>& animated, int owner, const Rig& rig, const Character& character);
  [[nodiscard]] float valueOf(const Number& number, float drawn, const Pose& pose, const Skeleton& skeleton,
                              DriverScratch& scratch) const;

  std::vector<Number> numbers_;
  std::vector<std::optional<LineRest>> rests_;  ///< [Rig::lines] that inputs read; empty: none.
};

}  // namespace sinew
