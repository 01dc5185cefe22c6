// core/bodies/belly_motion.h: how bellies move against the skin over them, from the bind pose to a pose.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "core/bodies/skin_track.h"
#include "core/rig/posed_rig.h"

namespace sinew {

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

}  // namespace sinew
