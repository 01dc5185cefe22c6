// core/bodies/check.h: what goes wrong with a rig's muscles while its character moves. docs/muscles.md.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/bodies/motions.h"
#include "sinew/rig/rig.h"

namespace sinew {

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
