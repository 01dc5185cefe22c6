// core/bodies/motions.h: what a character does: poses of all its clips, and spots of its skin in each.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/bodies/skin_track.h"
#include "core/character/range_of_motion.h"
#include "sinew/character/character.h"
#include "sinew/character/pose.h"

namespace sinew {

/// All clips of a character and its range of motion, fifteen poses a second, each with its clip and time.
class Motions {
 public:
  explicit Motions(std::shared_ptr<const Character> character);

  /// With the range of motion among its clips, if its joints can turn.
  [[nodiscard]] const Character& character() const { return *character_; }
  /// In the bind pose.
  [[nodiscard]] const SkinRuns& skin() const { return skin_; }
  [[nodiscard]] std::span<const Pose> poses() const { return poses_; }

  /// How much of what is seen in a pose counts: half in the range of motion, which goes farther than any clip does.
  [[nodiscard]] float shareOf(std::size_t pose) const { return poses_[pose].clip == kRangeOfMotionName ? 0.5f : 1.0f; }

  /// [poses * spots] frames of spots, pose after pose; nullopt as frameAt() has it.
  [[nodiscard]] std::vector<std::optional<SkinFrame>> framesOf(std::span<const SkinSpot> spots) const;
  /// [poses] places of a control vertex, world.
  [[nodiscard]] std::vector<glm::vec3> placesOf(int vertex) const;

 private:
  std::shared_ptr<const Character> character_;
  SkinRuns skin_;
  std::vector<Pose> poses_;
};

}  // namespace sinew
