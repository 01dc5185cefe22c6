// core/bodies/retargeter.h: one clip of another skeleton on a character's bones.
#pragma once

#include <utility>
#include <vector>

#include "core/bodies/common_stance.h"
#include "core/bodies/rotation_keys.h"

namespace sinew {

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
