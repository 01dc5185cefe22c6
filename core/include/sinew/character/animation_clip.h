// core/include/sinew/character/animation_clip.h: keyframes for nodes, sampled as glTF 2.0 defines (3.11, appendix C).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sinew/character/skeleton.h"

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

/// The animated weights of all morph targets of one node. Times as for Channel.
struct MorphChannel {
  int firstTarget = 0;  ///< Index into Character::morphTargets.
  int targets = 0;      ///< How many; > 0.
  Interpolation interpolation = Interpolation::kLinear;
  std::vector<float> times;  ///< [K]
  std::vector<float>
      values;  ///< [K][targets], or [K][3][targets] for cubic splines: in-tangents, values, out-tangents.
};

struct AnimationClip {
  std::string name;
  float duration = 0.0f;  ///< Largest key time of any channel, seconds.
  std::vector<Channel> channels;
  /// The rotations turn joints of the bind pose (pose_override.h), where a file's clip places nodes. Made in memory
  /// alone (range_of_motion.h); no file holds such a clip.
  bool turnsBindPose = false;
  std::vector<MorphChannel> morphChannels{};
  std::string addedFrom{};  ///< The file it was added from (Rig::clipFiles); empty: the character's own.
};

/// The weights of a channel's targets at a time, seconds; before the first key the first, after the last the last.
/// @param out [targets]
void sampleMorphs(const MorphChannel& channel, float time, std::span<float> out);

/// Value at a time, seconds; before the first key the first value, after the last the last. Rotations come back unit.
[[nodiscard]] glm::vec4 sampleChannel(const Channel& channel, float time);

}  // namespace sinew
