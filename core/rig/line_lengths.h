// core/rig/line_lengths.h: how long a muscle line gets in what a character does.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/rig/line_rest.h"
#include "sinew/character/character.h"

namespace sinew {

/// Line stretches (lambda) over clips.
struct LineLengths {
  float least = 1.0f;
  float secondPercentile = 1.0f;  ///< Shorter is rare: what full contraction is learned from.
  float most = 1.0f;
  std::string longestIn;  ///< Names of the clips in which it is longest and shortest.
  std::string shortestIn;
  int poses = 0;  ///< Looked at; 0: the rest says nothing.
};

/// Samples 15 times a second; of more than an hour of clips, 60,000 times in all.
[[nodiscard]] LineLengths lengthsOver(const LineRest& rest, const Character& character,
                                      std::span<const AnimationClip> clips);

/// The same of several lines, for the price of one: each pose is sampled once.  @return [rests]
[[nodiscard]] std::vector<LineLengths> lengthsOver(std::span<const LineRest> rests, const Character& character,
                                                   std::span<const AnimationClip> clips);

/// The same over poses.
[[nodiscard]] LineLengths lengthsOver(const LineRest& rest, const Skeleton& skeleton, std::span<const Pose> poses);

// Outside of these a straight line probably passes through a joint.
inline constexpr float kPlausibleLeast = 0.6f;
inline constexpr float kPlausibleMost = 1.4f;

}  // namespace sinew
