// core/bodies/belly_trial.h: one muscle measured over all poses, as check() would see it.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/bodies/belly_motion.h"
#include "core/bodies/motions.h"
#include "core/rig/posed_rig.h"
#include "sinew/rig/rig.h"

namespace sinew {

/// How far a mended muscle may go, of what is found: it has some room.
inline constexpr float kMendedMargin = 0.9f;

/// A muscle as it could be.
struct BellyChoice {
  Primitive primitive;
  std::optional<MuscleLine> line;
  std::string said;
};

/// How far a line and its belly are from being clean: at most 1 is.
struct Trouble {
  float path = 0.0f;  ///< Belly against skin, and the line's length.
  float ball = 0.0f;

  [[nodiscard]] float worst() const { return std::max(path, ball); }
  void add(const Trouble& other) { path = std::max(path, other.path), ball = std::max(ball, other.ball); }
};

/// In one pose. @param line  usable  @param share  Motions::shareOf the pose
[[nodiscard]] Trouble troubleOf(const FollowedBelly& belly, const BellyMotion& motion, const PosedLine& line,
                                float share);

/// In a rig of its own.
class BellyTrial {
 public:
  BellyTrial(const BellyChoice& choice, const SurfaceSettings& surface, const Motions& motions);

  [[nodiscard]] bool canTell() const { return belly_.has_value(); }
  /// Over its middle.
  [[nodiscard]] const SkinSpot& spot() const { return belly_->spots()[0]; }
  [[nodiscard]] std::vector<int> carriers() const { return bonesAt(motions_.character(), spot()); }
  /// In the bind pose.
  [[nodiscard]] const BellyBody& body() const { return body_; }
  /// Of the skin over it, in the bind pose.
  [[nodiscard]] glm::vec3 outwards() const;

  /// At most 1: nothing is found.
  /// @param enough  after a pose that is worse no other is looked at
  /// @param first  in: the pose to begin with; out: the one that was worse
  [[nodiscard]] float trouble(float enough = std::numeric_limits<float>::max(), std::size_t* first = nullptr) const;

 private:
  const Motions& motions_;
  RigPoser poser_;
  std::optional<FollowedBelly> belly_;
  BellyBody body_;
};

}  // namespace sinew
