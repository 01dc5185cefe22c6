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
  /// [K], or [3K] for cubic splines: in-tangent, value, out-tangent. Rotations x, y, z, w.
  std::vector<glm::vec4> values;
};

/// The animated weights of all morph targets of one node. Times as for Channel.
struct MorphChannel {
  int firstTarget = 0;  ///< Index into Character::morphTargets.
  int targets = 0;      ///< Their number; > 0.
  Interpolation interpolation = Interpolation::kLinear;
  std::vector<float> times;  ///< [K]
  /// [K][targets], or [K][3][targets] for cubic splines: in-tangents, values, out-tangents.
  std::vector<float> values;
};

struct AnimationClip {
  std::string name;
  float duration = 0.0f;  ///< Largest key time of any channel, seconds.
  std::vector<Channel> channels;
  /// Rotations are turns of joints of the bind pose (core/character/pose_override.h), not transforms of nodes. Only for
  /// the range of motion (core/character/range_of_motion.h); never in files.
  bool turnsBindPose = false;
  std::vector<MorphChannel> morphChannels{};
  std::string addedFrom{};  ///< File of an additional clip (Rig::clipFiles); empty: the character's own.
};

/// Weights at a time in seconds, clamped to the first and last key. @param out [targets]
void sampleMorphs(const MorphChannel& channel, float time, std::span<float> out);

/// Value at a time in seconds, clamped to the first and last key. Rotations are unit.
[[nodiscard]] glm::vec4 sampleChannel(const Channel& channel, float time);

}  // namespace sinew
