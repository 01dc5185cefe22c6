// core/include/sinew/rig/muscle_line.h: a muscle line: anchors and settings of a muscle between two bones.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sinew/geometry/geometry.h"
#include "sinew/rig/animated_number.h"
#include "sinew/rig/line_anchor.h"
#include "sinew/rig/not_compared.h"

namespace sinew {

/// Identity of a line, as PrimitiveId (rig.h).
struct LineId {
  std::uint32_t value = 0;

  [[nodiscard]] explicit operator bool() const { return value != 0; }
  friend auto operator<=>(const LineId&, const LineId&) = default;
};

// Ranges of LineSettings.
inline constexpr float kMostTendons = 0.8f;
inline constexpr float kLeastFull = 0.1f;
inline constexpr float kMostFull = 0.99f;
inline constexpr float kLeastRest = 0.25f;
inline constexpr float kMostRest = 4.0f;
inline constexpr float kMostVolume = 4.0f;
inline constexpr float kLeastFlex = -0.9f;  ///< Girth stays positive.
inline constexpr float kMostFlex = 4.0f;
inline constexpr float kMostGain = 4.0f;

/// How the belly responds to the length of its line. docs/muscles.md.
struct LineSettings {
  float rest = 1.0f;                ///< Rest length / length in the bind pose, kLeastRest..kMostRest.
  glm::vec2 tendons{0.13f, 0.15f};  ///< At origin and insertion, fractions of rest length; >= 0, sum <= kMostTendons.
  float volume = 1.0f;              ///< 0: constant girth; 1: constant volume; more: exaggerated. 0..kMostVolume.
  glm::vec2 limits{0.4f, 2.0f};     ///< Belly stretches at which girth levels off; 0 < x < 1 < y.
  float pivot = 1.0f;               ///< Girth grows from 0: the line, 1: the bone below it.
  float twist = 0.5f;               ///< The belly rotates with 0: the origin's bone, 1: the insertion's.
  glm::vec2 flex{0.3f, 0.0f};       ///< Height and width added at full activation, kLeastFlex..kMostFlex.
  float base = 0.0f;                ///< Manual activation, 0..1.
  float gain = 1.0f;                ///< Activation from shortening, 0..kMostGain; 0: manual only.
  float full = 0.75f;               ///< Line stretch of full activation by shortening, kLeastFull..kMostFull.

  friend bool operator==(const LineSettings&, const LineSettings&) = default;
};

/// From a point on one bone to one on another or the same; its primitives stretch and thicken (core/rig/line_pose.h).
struct MuscleLine {
  std::string name;  ///< Unique among lines, not empty.
  LineAnchor origin;
  LineAnchor insertion;
  std::optional<LineAnchor> via;  ///< The line passes through this point.
  LineSettings settings;
  std::string unknownActivationKeys;
  std::string mirror;  ///< Name of the linked twin, or empty.
  std::string sheet;   ///< Name of the sheet that it is a strip of, from which it follows; empty: none.
  std::vector<AnimatedNumber> animated;
  std::string unknownKeys;
  NotCompared<LineId> identity{};

  [[nodiscard]] LineId id() const { return identity.value; }
  friend bool operator==(const MuscleLine&, const MuscleLine&) = default;
};

}  // namespace sinew
