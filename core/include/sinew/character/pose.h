// core/include/sinew/character/pose.h: one moment of a skeleton.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "sinew/character/animation_clip.h"
#include "sinew/character/skeleton.h"

namespace sinew {

/// Where every bone is, the weights of morph targets, and how hard muscles are flexed. Bone scale, also uneven, is part
/// of the matrices.
struct Pose {
  std::vector<glm::mat4> boneInWorld;  ///< [bones] bone space -> world.
  std::vector<float> morphWeights;     ///< [Character::morphTargets]; empty: as in the file.
  float flex = 0.0f;                   ///< Added to the activation of muscle lines, 0..1.
  std::vector<int> flexedLines;        ///< Which: indices into Rig::lines, ascending; empty: all.
  std::string clip;                    ///< Name of the clip that it was sampled from; empty: none. Keys go by it.
  float time = 0.0f;                   ///< Time in that clip, seconds.

  /// What is added to a line's activation. @param line  index into Rig::lines
  [[nodiscard]] float flexOf(int line) const {
    const bool flexes = flexedLines.empty() || std::ranges::binary_search(flexedLines, line);
    return flexes ? flex : 0.0f;
  }
  friend bool operator==(const Pose&, const Pose&) = default;
};

/// The pose the inverse bind matrices describe, upright (docs/design.md).
[[nodiscard]] Pose bindPose(const Skeleton& skeleton);

/// The nodes as they stand when nothing is animated. Need not be the bind pose.
[[nodiscard]] Pose restPose(const Skeleton& skeleton);

/// A clip at a time, seconds, clamped to the clip (looping is up to the caller). Unanimated nodes rest, and morph
/// targets stay as in the file: samplePose of character/character_pose.h plays them too.
[[nodiscard]] Pose samplePose(const Skeleton& skeleton, const AnimationClip& clip, float time);

}  // namespace sinew
