// core/rig/motion_clip.h: the range of motion as a clip of a character, and the times at which clips are sampled.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/character/range_of_motion.h"
#include "core/rig/mirror.h"
#include "sinew/character/character.h"

namespace sinew {

/// Arguments of rangeOfMotion() besides the skeleton.
[[nodiscard]] RangeOfMotionHints motionHints(const Character& character);

/// The character with a clip "Range of motion" (core/character/range_of_motion.h) after its own clips; the same
/// character if it already has a clip of that name or none of its joints can turn.
[[nodiscard]] std::shared_ptr<const Character> withRangeOfMotion(std::shared_ptr<const Character> character);
/// The same with the character's mirror plan, which takes longest to find.
[[nodiscard]] std::shared_ptr<const Character> withRangeOfMotion(std::shared_ptr<const Character> character,
                                                                 const MirrorPlan& plan);

/// The character, with the range of motion if that is the named clip.
[[nodiscard]] std::shared_ptr<const Character> withClipNamed(std::shared_ptr<const Character> character,
                                                             const std::string& clip);

/// Index of the first clip of that name, or -1.
[[nodiscard]] int findClip(const Character& character, std::string_view name);

struct ClipTime {
  const AnimationClip* clip;
  float time;  ///< Seconds.
};

/// Evenly spaced times in every clip, 15 per second; fewer if that would be more than about `most` in all.
[[nodiscard]] std::vector<ClipTime> sampleTimes(std::span<const AnimationClip> clips, double most);

}  // namespace sinew
