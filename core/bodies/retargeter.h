// core/bodies/retargeter.h: one clip of another skeleton on a character's bones.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "core/character/body_slots.h"
#include "sinew/character/animation_clip.h"
#include "sinew/character/skeleton.h"

namespace sinew {

// What turns another body's bind pose into the stance of the character's.

/// Two skeletons and what is known of them. Outlives what is made of it.
struct ClipBodies {
  const Skeleton& from;  ///< Whose clips are played.
  const Skeleton& to;    ///< Who plays them.
  const BodySlots& fromSlots;
  const BodySlots& toSlots;
  const std::vector<int>& partner;  ///< [bones of to] bone of from, or -1
};

/// The character's bone that is this part, or whose partner is: feet that are targets of their legs, not below them,
/// are found by their names alone. -1: none.
[[nodiscard]] int partOf(const ClipBodies& bodies, BodySlot slot);

struct CommonStance {
  /// World of the clips -> world of the character: about y, by whole quarters, so that both face the same way.
  glm::dquat facing{1.0, 0.0, 0.0, 0.0};
  /// [bones of to] Turns the partner, as it stands in its bind pose, to lie as the bone does. World of the character.
  /// Arms and legs: the least rotation, from the trunk outwards. Hands go with the arms; trunk, head and feet keep the
  /// stance they have.
  std::vector<glm::dquat> turn;
  int hips = -1;             ///< The bone of the character whose translation is transferred, or -1.
  double heightRatio = 1.0;  ///< Hips above the feet: the character's by the other's; > 0.
};

[[nodiscard]] CommonStance findCommonStance(const ClipBodies& bodies);

/// The rotation in a matrix; none where it is too flat to have one.
[[nodiscard]] glm::dquat rotationIn(const glm::mat4& matrix);

// The keys of what turns between two bones of a clip's skeleton.

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

/// Channels as they are made, found by node.
class MadeChannels {
 public:
  explicit MadeChannels(std::size_t nodes) : places_(2 * nodes, -1) {}

  void add(Channel channel);
  /// Of rotation or translation; null: the node rests.
  [[nodiscard]] const Channel* of(int node, ChannelPath path) const;
  [[nodiscard]] std::vector<Channel> take() && { return std::move(channels_); }

 private:
  std::vector<Channel> channels_;
  std::vector<int> places_;  // [nodes * 2]
};

/// Plays clips of one body on another.
class Retargeter {
 public:
  explicit Retargeter(const ClipBodies& bodies);

  /// Channels alone. Bones that would not leave their rest pose have none.
  /// @param budget  nodes times moments that may still be sampled; below 0 afterwards: the rest is left out
  [[nodiscard]] std::vector<Channel> channelsOf(const AnimationClip& clip, double& budget) const;

 private:
  [[nodiscard]] int partnerOf(int bone) const { return bodies_.partner[static_cast<std::size_t>(bone)]; }
  [[nodiscard]] bool canTurn(int bone) const;
  /// The nearest bone above that has a partner, or -1.
  [[nodiscard]] int anchorOf(int bone) const;
  [[nodiscard]] Channel turnOf(int bone, const ClipTurns& turns, double& budget) const;
  [[nodiscard]] Channel hipPath(const ClipTurns& turns, const MadeChannels& made, double& budget) const;
  [[nodiscard]] Channel follow(int bone, int carrier, const MadeChannels& made, double& budget) const;
  void addPartsApart(MadeChannels& made, double& budget) const;
  [[nodiscard]] glm::dmat4 placed(int node, const MadeChannels& made, float time) const;
  [[nodiscard]] std::vector<float> timesAbove(int node, const MadeChannels& made) const;
  [[nodiscard]] double depthOf(int node) const;
  [[nodiscard]] bool isAtRest(const Channel& channel) const;

  const ClipBodies& bodies_;
  CommonStance stance_;
};

}  // namespace sinew
