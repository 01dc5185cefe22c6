// core/bodies/motions.h: what a character does: poses of all its clips, and spots of its skin in each.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/bodies/skin_track.h"
#include "core/character/range_of_motion.h"
#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/rig/muscle_line.h"
#include "sinew/rig/rig.h"

namespace sinew {

// What muscle lines do over all clips, learned for many at once.

/// Lines from `first` on learn their full contraction (withLearned). Twins learn alike: from whichever side gets
/// shorter. One that never shortens keeps what it has.
/// @param character  with the range of motion as a clip
[[nodiscard]] Rig withLearnedLengths(Rig rig, std::size_t first, const Character& character);

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

// How short a line gets in what its character does.

/// Full contraction from the 2nd percentile of its lengths. A line that never shortens keeps what it has.
void learnFull(MuscleLine& line, const Motions& motions);

}  // namespace sinew
