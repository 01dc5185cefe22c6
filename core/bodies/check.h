// core/bodies/check.h: finds muscles that leave the flesh while their character moves. docs/muscles.md.
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

// Limits of BellyMotion; anything above is a finding.
inline constexpr float kMostOut = 0.5f;
inline constexpr float kMostBeside = 1.0f;
inline constexpr float kMostBall = 0.8f;

/// How a belly has moved relative to the skin over it, from the bind pose to a pose.
struct BellyMotion {
  float out = 0.0f;     ///< How far its underside has come out of the skin, fraction of its height in this pose.
  float beside = 0.0f;  ///< How far it has moved sideways under the skin, fraction of half its width in this pose.
  float ball = 0.0f;    ///< Height over length.
};

/// A muscle's visible body in a pose: unit ball -> world.
struct BellyBody {
  glm::vec3 center{0.0f};
  glm::mat3 axes{1.0f};  ///< Columns: half axes.
};
[[nodiscard]] BellyBody bellyBody(const PosedMuscle& muscle);

/// The middle of a muscle and two points towards its ends, each with the nearest outer skin in the bind pose. Motion is
/// measured relative to that skin.
class FollowedBelly {
 public:
  static constexpr std::size_t kPoints = 3;

  /// nullopt: no skin to follow, or the muscle's center is on its bone's axis. @param bind  the muscle in the bind pose
  [[nodiscard]] static std::optional<FollowedBelly> create(const Character& character, const SkinRuns& skin,
                                                           const PosedMuscle& bind, int bone);

  [[nodiscard]] const std::array<SkinSpot, kPoints>& spots() const { return spots_; }  ///< The middle first.
  /// Limit of BellyMotion::ball: kMostBall, or somewhat more than in the bind pose.
  [[nodiscard]] float mostBall() const;
  /// The worst of the points; only the middle for a muscle without a line, which need not follow the skin.
  /// @param frames  [kPoints] of spots() in the muscle's pose
  [[nodiscard]] BellyMotion motion(const PosedMuscle& muscle, std::span<const std::optional<SkinFrame>> frames) const;

 private:
  struct Point {
    glm::vec3 inSkin{0.0f};  ///< In the skin's frame, bind pose.
    float under = 0.0f;      ///< From the skin to the belly's underside along the skin's normal, bind pose.
  };

  std::array<SkinSpot, kPoints> spots_;
  std::array<Point, kPoints> points_;
  int long_ = 1;       ///< Longest axis in the bind pose.
  float ball_ = 0.0f;  ///< Height over length in the bind pose.
};

// One muscle measured over all poses, as by check().

/// Largest BellyTrial::trouble() of a mended muscle: some room below 1, from which on check() reports.
inline constexpr float kMendedMargin = 0.9f;

struct BellyChoice {
  Primitive primitive;
  std::optional<MuscleLine> line;
  std::string said;
};

/// Measures over their limits: clean up to 1.
struct Trouble {
  float path = 0.0f;  ///< Motion of the belly in the skin, and length of the line.
  float ball = 0.0f;

  [[nodiscard]] float worst() const { return std::max(path, ball); }
  void add(const Trouble& other) { path = std::max(path, other.path), ball = std::max(ball, other.ball); }
};

/// In one pose. @param line  usable  @param share  Motions::shareOf() of the pose
[[nodiscard]] Trouble troubleOf(const FollowedBelly& belly, const BellyMotion& motion, const PosedLine& line,
                                float share);

/// Tries a muscle in a rig of its own.
class BellyTrial {
 public:
  BellyTrial(const BellyChoice& choice, const SurfaceSettings& surface, const Motions& motions);

  [[nodiscard]] bool canTell() const { return belly_.has_value(); }
  [[nodiscard]] const SkinSpot& spot() const { return belly_->spots()[0]; }  ///< The skin over its middle.
  [[nodiscard]] std::vector<int> carriers() const { return bonesAt(motions_.character(), spot()); }
  [[nodiscard]] const BellyBody& body() const { return body_; }  ///< In the bind pose.
  [[nodiscard]] glm::vec3 outwards() const;                      ///< Normal of the skin over it, in the bind pose.

  /// The worst over all poses; up to 1 is clean. @param enough  stops after a pose that is worse than this
  /// @param first  in: pose to begin with; out: pose at which it stopped
  [[nodiscard]] float trouble(float enough = std::numeric_limits<float>::max(), std::size_t* first = nullptr) const;

 private:
  const Motions& motions_;
  RigPoser poser_;
  std::optional<FollowedBelly> belly_;
  BellyBody body_;
};

enum class FindingKind { kComesOut, kSlidesOff, kBall, kTooShort, kTooLong, kReachesAcross };

/// The worst pose of one kind of trouble of one muscle.
struct Finding {
  FindingKind kind = FindingKind::kComesOut;
  int primitive = 0;      ///< Index into Rig::primitives; for a line the first muscle on it, for a strip its first.
  std::string clip;       ///< Empty: in the bind pose.
  float time = 0.0f;      ///< Seconds.
  float measure = 0.0f;   ///< Fraction of what textOf() names.
  std::string bone = {};  ///< kReachesAcross: bone of the skin.

  friend bool operator==(const Finding&, const Finding&) = default;
};

[[nodiscard]] std::string_view nameOf(FindingKind kind);   ///< Name in files: "comes_out".
[[nodiscard]] std::string textOf(const Finding& finding);  ///< "comes out of the skin by 62 % of its height".

// Lengths of lines, of their rest length; outside of these limits a line probably passes through a joint.
inline constexpr float kLeastStretch = 0.5f;
inline constexpr float kMostStretch = 1.6f;

/// Findings of muscles that add and are attached, in the rig's order, then in that of the kinds. The bellies of a strip
/// are one muscle, with the mean of their motions.
/// - comes out, slides off: motion of a belly relative to the skin over it
/// - ball: height more than 0.8 of the length, and more than 1.3 times that ratio in the bind pose
/// - too short, too long: a line's length relative to its rest length
/// - reaches across: skin in the muscle's own territory, three or more joints away from its bones, those of its line
/// and
///   those of its sheet, comes within its reach
/// @param rig  valid, on the motions' character
[[nodiscard]] std::vector<Finding> check(const Rig& rig, const Motions& motions);

}  // namespace sinew
