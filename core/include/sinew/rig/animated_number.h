// core/include/sinew/rig/animated_number.h: keys and drivers of numbers, and channels for drivers. docs/muscles.md.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sinew/geometry/geometry.h"
#include "sinew/rig/line_anchor.h"
#include "sinew/rig/parameter.h"

namespace sinew {

enum class CurveKind {
  kSmooth,  ///< Monotone cubic: never overshoots its points.
  kLinear,
  kStep,  ///< The value of the point before.
};

/// A function given by points; constant before the first and after the last.
struct Curve {
  std::vector<glm::vec2> points;  ///< x strictly rising; at least one.
  CurveKind kind = CurveKind::kSmooth;

  friend bool operator==(const Curve&, const Curve&) = default;
};

inline constexpr std::size_t kMostDriverPoints = 16;
inline constexpr std::size_t kMostKeys = 10000;  ///< In one track.

/// Values over the time of a clip.
struct KeyTrack {
  std::string clip;  ///< Name of the character's clip; empty: in every clip.
  Curve curve;       ///< x: seconds from the clip's start, >= 0.
  std::string unknownKeys;

  friend bool operator==(const KeyTrack&, const KeyTrack&) = default;
};

/// A custom track for drivers to read. Tracks with the same name are one channel in several clips.
struct RigChannel {
  std::string name;
  KeyTrack track;

  friend bool operator==(const RigChannel&, const RigChannel&) = default;
};

enum class DriverInputKind {
  kBend,      ///< Degrees between the bone and its parent, minus the same in the bind pose.
  kTwist,     ///< Degrees about the bone's own direction, from the bind pose, -180..180.
  kAxis,      ///< Degrees about `axis`, from the bind pose, -180..180.
  kPose,      ///< 0..1: nearness of the joint's rotation to `rotation`.
  kLength,    ///< Stretch of a muscle line, without drivers of that line.
  kDistance,  ///< Distance between two anchors over that in the bind pose.
  kChannel,   ///< Value of a channel; 0 in clips where it has no track.
};

inline constexpr float kDefaultPoseWidth = 35.0f;
inline constexpr float kLeastPoseWidth = 1.0f;
inline constexpr float kMostPoseWidth = 180.0f;

/// Input that a driver reads from the pose. Members that the kind does not use stay at their defaults.
struct DriverInput {
  DriverInputKind kind = DriverInputKind::kBend;
  std::string bone;                            ///< Bend, twist, axis, pose.
  glm::vec3 axis{1.0f, 0.0f, 0.0f};            ///< Unit, in the joint's frame (core/character/pose_override.h).
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};  ///< Unit; the joint's rotation from the bind pose, in that frame.
  float width = kDefaultPoseWidth;             ///< Degrees: standard deviation of the nearness.
  std::string line;
  std::string channel;
  LineAnchor from;
  LineAnchor to;
  std::string unknownKeys;

  friend bool operator==(const DriverInput&, const DriverInput&) = default;
};

enum class DriverMode { kAdd, kMultiply, kReplace };

struct Driver {
  DriverInput input;
  Curve curve;  ///< Input -> value; 1..kMostDriverPoints points.
  DriverMode mode = DriverMode::kAdd;
  std::string unknownKeys;

  friend bool operator==(const Driver&, const Driver&) = default;
};

/// Keys and drivers of one number of its owner. The value is the keyed one if the clip has keys, else the owner's
/// number; drivers are applied in order; the result is clamped to the parameter's range.
struct AnimatedNumber {
  Parameter parameter = Parameter::kAmount;  ///< A parameter of the owner; at most one entry for each.
  std::vector<KeyTrack> keys;                ///< At most one for each clip.
  std::vector<Driver> drivers;
  std::string unknownKeys;

  friend bool operator==(const AnimatedNumber&, const AnimatedNumber&) = default;
};

[[nodiscard]] const char* nameOf(CurveKind kind);
[[nodiscard]] const char* nameOf(DriverInputKind kind);
[[nodiscard]] const char* nameOf(DriverMode mode);
[[nodiscard]] std::optional<CurveKind> curveKindNamed(const std::string& name);
[[nodiscard]] std::optional<DriverInputKind> driverInputKindNamed(const std::string& name);
[[nodiscard]] std::optional<DriverMode> driverModeNamed(const std::string& name);

[[nodiscard]] float valueAt(const Curve& curve, float x);

/// The entry of a parameter, or null.
[[nodiscard]] const AnimatedNumber* animationOf(const std::vector<AnimatedNumber>& animated, Parameter parameter);
/// The track for a clip, or else the one for every clip; null: none, or no clip.
[[nodiscard]] const KeyTrack* trackIn(const std::vector<KeyTrack>& tracks, const std::string& clip);

}  // namespace sinew
