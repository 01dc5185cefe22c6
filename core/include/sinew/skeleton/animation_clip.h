// core/include/sinew/skeleton/animation_clip.h: keyframes for nodes, sampled as glTF 2.0 defines (3.11, appendix C).
#pragma once

#include <string>
#include <vector>

#include "sinew/skeleton/skeleton.h"

namespace sinew {

enum class ChannelPath { kTranslation, kRotation, kScale };
enum class Interpolation { kStep, kLinear, kCubicSpline };

/// One animated property of one node. Times strictly increasing, seconds, at least one.
struct Channel {
  int node = 0;
  ChannelPath path = ChannelPath::kTranslation;
  Interpolation interpolation = Interpolation::kLinear;
  std::vector<float> times;  ///< [K]
  std::vector<glm::vec4>
      values;  ///< [K], or [3K] for cubic splines: in-tangent, value, out-tangent. Rotations x,y,z,w.
};

struct AnimationClip {
  std::string name;
  float duration = 0.0f;  ///< Largest key time of any channel, seconds.
  std::vector<Channel> channels;
  /// The rotations turn joints of the bind pose (pose_override.h), where a file's clip places nodes. Made in memory
  /// alone (range_of_motion.h); no file holds such a clip.
  bool turnsBindPose = false;
};

/// Value at a time, seconds; before the first key the first value, after the last the last. Rotations come back unit.
[[nodiscard]] glm::vec4 sampleChannel(const Channel& channel, float time);

}  // namespace sinew
