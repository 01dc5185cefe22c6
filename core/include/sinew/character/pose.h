// core/include/sinew/character/pose.h: a pose of a skeleton.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "sinew/character/animation_clip.h"
#include "sinew/character/skeleton.h"

namespace sinew {

/// Matrices of bones, including any scale, weights of morph targets, and flex of muscles.
struct Pose {
  std::vector<glm::mat4> boneInWorld;  ///< [bones] bone space -> world.
  std::vector<float> morphWeights;     ///< [Character::morphTargets]; empty: as in the file.
  float flex = 0.0f;                   ///< Added to the activation of muscle lines, 0..1.
  std::vector<int> flexedLines;        ///< Lines that `flex` applies to, ascending indices; empty: all.
  std::string clip;                    ///< Name of the sampled clip, for keys; empty: none.
  float time = 0.0f;                   ///< Time in that clip, seconds.

  /// Added to a line's activation. @param line  index into Rig::lines
  [[nodiscard]] float flexOf(int line) const {
    const bool flexes = flexedLines.empty() || std::ranges::binary_search(flexedLines, line);
    return flexes ? flex : 0.0f;
  }
  friend bool operator==(const Pose&, const Pose&) = default;
};

/// The pose of the inverse bind matrices, upright (docs/design.md).
[[nodiscard]] Pose bindPose(const Skeleton& skeleton);

/// The pose of the nodes without animation. May differ from the bind pose.
[[nodiscard]] Pose restPose(const Skeleton& skeleton);

/// A clip at a time in seconds, clamped to the clip. Nodes without channels are at rest, and morph targets as in the
/// file; samplePose() of character_pose.h also samples morph targets.
[[nodiscard]] Pose samplePose(const Skeleton& skeleton, const AnimationClip& clip, float time);

}  // namespace sinew
