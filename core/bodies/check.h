// core/bodies/check.h: what goes wrong with a rig's muscles while its character moves. docs/muscles.md.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/bodies/motions.h"
#include "core/rig/posed_rig.h"
#include "sinew/rig/rig.h"

namespace sinew {

// How bellies move against the skin over them, from the bind pose to a pose.

// More than this is found.
inline constexpr float kMostOut = 0.5f;
inline constexpr float kMostBeside = 1.0f;
inline constexpr float kMostBall = 0.8f;

/// One belly in one pose.
struct BellyMotion {
  float out = 0.0f;     ///< How far its underside has come out of the skin, of its height in this pose.
  float beside = 0.0f;  ///< How far it has moved sideways under the skin, of half its width in this pose.
  float ball = 0.0f;    ///< Height over length.
};

/// A muscle's visible body in a pose: unit ball -> world.
struct BellyBody {
  glm::vec3 center{0.0f};
  glm::mat3 axes{1.0f};  ///< Columns: half its extents.
};
[[nodiscard]] BellyBody bellyBody(const PosedMuscle& muscle);

/// The middle of a muscle and two points towards its ends, each with the nearest outer skin of the bind pose. What that
/// skin carries along is no motion of the belly's.
class FollowedBelly {
 public:
  static constexpr std::size_t kPoints = 3;

  /// nullopt: there is no skin to follow, or the muscle lies round its bone's axis.
  /// @param skin  of the character  @param bind  the muscle in the bind pose  @param bone  that it rides, or its line
  /// begins at
  [[nodiscard]] static std::optional<FollowedBelly> create(const Character& character, const SkinRuns& skin,
                                                           const PosedMuscle& bind, int bone);

  /// The middle's first.
  [[nodiscard]] const std::array<SkinSpot, kPoints>& spots() const { return spots_; }
  /// The most that it may swell to a ball: kMostBall, or somewhat more than in the bind pose.
  [[nodiscard]] float mostBall() const;
  /// The worst of the points. Of a muscle on one bone the middle alone counts: it does not claim to go with the skin.
  /// @param frames [kPoints] of spots() in the muscle's pose
  [[nodiscard]] BellyMotion motion(const PosedMuscle& muscle, std::span<const std::optional<SkinFrame>> frames) const;

 private:
  struct Point {
    glm::vec3 inSkin{0.0f};  ///< From the skin, in its frame, bind pose.
    float under = 0.0f;      ///< Along the skin's normal, from the skin to the belly's underside, bind pose.
  };

  std::array<SkinSpot, kPoints> spots_;
  std::array<Point, kPoints> points_;
  int long_ = 1;       ///< The belly's longest axis in the bind pose.
  float ball_ = 0.0f;  ///< In the bind pose.
};

// One muscle measured over all poses, as check() would see it.

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

enum class FindingKind { kComesOut, kSlidesOff, kBall, kTooShort, kTooLong, kReachesAcross };

/// The worst moment of one kind of trouble of one muscle.
struct Finding {
  FindingKind kind = FindingKind::kComesOut;
  int primitive = 0;      ///< Index into Rig::primitives; of a line the first muscle on it.
  std::string clip;       ///< Empty: in the bind pose.
  float time = 0.0f;      ///< Seconds.
  float measure = 0.0f;   ///< Fraction; what of follows from the kind (textOf).
  std::string bone = {};  ///< kReachesAcross: whose skin.

  friend bool operator==(const Finding&, const Finding&) = default;
};

/// What files call it: "comes_out".
[[nodiscard]] std::string_view nameOf(FindingKind kind);
/// "comes out of the skin by 62 % of its height".
[[nodiscard]] std::string textOf(const Finding& finding);

// A line that gets shorter or longer than this probably passes through a joint.
inline constexpr float kLeastStretch = 0.5f;
inline constexpr float kMostStretch = 1.6f;

/// Muscles that add and are attached, in the rig's order; a muscle's findings in the order of the kinds. Empty: nothing
/// was found.
/// - comes out, slides off: a belly against the skin over it (belly_motion.h)
/// - ball: higher than 0.8 of its length, and than 1.3 of that ratio in the bind pose
/// - too short, too long: a line's length, of its rest length
/// - reaches across: skin of a bone of the muscle's own territory, three joints away or more, comes within its reach
/// @param rig  valid, on the motions' character
[[nodiscard]] std::vector<Finding> check(const Rig& rig, const Motions& motions);

}  // namespace sinew
