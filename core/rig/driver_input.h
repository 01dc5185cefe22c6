// core/rig/driver_input.h: what drivers read, found on a character and measured in its poses.
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

// How far a joint is bent, twisted and turned in a pose. docs/muscles.md.

/// Degrees between the directions of a bone and its parent, less that of the bind pose; of a root: from its direction
/// in the bind pose. Continuous in the pose. 0 where a bone is flattened.
[[nodiscard]] float bendOf(const Skeleton& skeleton, const Pose& pose, int bone);

/// The direction of a bone in its turn frame (skeleton/pose_override.h), unit.
[[nodiscard]] glm::vec3 boneDirection(const Bone& bone);

/// Degrees of a turn about an axis, the rest of the turn left out (swing and twist), -180..180. Continuous but for half
/// turns.
/// @param axis  unit
[[nodiscard]] float turnAbout(const glm::quat& turn, const glm::vec3& axis);

/// exp(-angle^2 / (2 width^2)) of the rotation between two turns: 1 where they agree. @param width  degrees
[[nodiscard]] float nearness(const glm::quat& turn, const glm::quat& wanted, float width);

/// An input whose bones, line and channel are found.
struct FoundInput {
  DriverInputKind kind = DriverInputKind::kBend;
  int bone = -1;
  glm::vec3 axis{1.0f, 0.0f, 0.0f};  ///< Axis of the turn frame and of a twist.
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
  float width = kDefaultPoseWidth;
  int line = -1;                 ///< Index into Rig::lines.
  std::vector<KeyTrack> tracks;  ///< Tracks of the channel.
  BonePoint from;
  BonePoint to;
  double distanceInBind = 1.0;
};

/// nullopt: the character lacks a bone of it, its line cannot be used, or its points meet in the bind pose.
[[nodiscard]] std::optional<FoundInput> foundInput(const DriverInput& input, const Rig& rig,
                                                   const Character& character);

/// Memory that is reused from pose to pose.
struct InputScratch {
  std::vector<std::optional<glm::quat>> turnOf;  ///< [bones] turns that were asked for in this pose.
};

/// @param lines  [Rig::lines] posed without drivers; only those that inputs read are looked at
/// @param scratch  turnOf as it was in this pose, or empty
[[nodiscard]] float valueOf(const FoundInput& input, const Skeleton& skeleton, const Pose& pose,
                            std::span<const PosedLine> lines, InputScratch& scratch);

/// One input in one pose: for those who show it. nullopt as foundInput.
[[nodiscard]] std::optional<float> inputNow(const DriverInput& input, const Rig& rig, const Character& character,
                                            const Pose& pose);

// The numbers of a rig that follow the pose. Made once per edit, applied once per pose.

/// Memory that is reused from pose to pose; carries nothing from one to the next.
struct DriverScratch {
  std::vector<PosedLine> lines;  ///< [Rig::lines] those that inputs read.
  LineScratch posing;
  InputScratch inputs;
};

/// Order: lines are measured as the rig has them, then every driver, none reading another's result. A driver whose
/// input this character lacks is left out.
class DrivenNumbers {
 public:
  DrivenNumbers() = default;
  DrivenNumbers(const Rig& rig, const Character& character);

  [[nodiscard]] bool isEmpty() const { return numbers_.empty(); }
  /// Whether some number belongs to an owner of this kind.
  [[nodiscard]] bool changes(ParameterOwner owner) const;
  /// @param numbers  as drawn (drawnNumbers); afterwards as they are in the pose
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
  std::vector<std::optional<LineRest>> rests_;  ///< [Rig::lines] those that inputs read; empty: none are.
};

}  // namespace sinew
