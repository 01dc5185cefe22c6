// core/bodies/rotation_keys.h: the keys of what turns between two bones of a clip's skeleton.
#pragma once

#include <span>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "sinew/character/animation_clip.h"
#include "sinew/character/skeleton.h"

namespace sinew {

inline constexpr double kSampledFrame = 1.0 / 30.0;  ///< Between keys that cannot be copied, seconds.

/// A clip's channels by node, and the nodes as they turn in it. Outlives neither.
class ClipTurns {
 public:
  ClipTurns(const Skeleton& skeleton, const AnimationClip& clip);

  [[nodiscard]] const Channel* channel(int node, ChannelPath path) const;
  /// Of a node against its parent.
  [[nodiscard]] glm::dquat turn(int node, float time) const;
  /// [nodes above, the node itself last] that lie below `above`; all of them where that is -1.
  /// @return false: `above` is not above the node
  [[nodiscard]] bool chain(int above, int node, std::vector<int>& nodes) const;
  /// Of all the channels of these nodes, rising; between far ones more, where `fine`.
  [[nodiscard]] std::vector<float> timesOf(std::span<const int> nodes, bool fine) const;
  [[nodiscard]] const Skeleton& skeleton() const { return skeleton_; }

  /// left * (turn of `above`)^-1 * (turn of `node`) * right, both in the world; of a chain in which one channel turns
  /// the keys are that channel's, tangents too. Empty where the budget is spent.
  /// @param above  -1: the world itself
  [[nodiscard]] Channel between(int above, int node, const glm::dquat& left, const glm::dquat& right,
                                double& budget) const;

 private:
  const Skeleton& skeleton_;
  std::vector<const Channel*> channels_;  // [nodes * 3]
};

/// Keys further apart than a sampled frame get more between them; not where they would be too many.
[[nodiscard]] std::vector<float> refinedTimes(std::vector<float> times);

}  // namespace sinew
