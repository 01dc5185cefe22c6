// core/character/side_names.h: which side a name means, and the name of its counterpart.
//
// A side marker is left or right, l or r, lf or rt, fl or fr, bl or br, in any case, standing apart: "arm_L", "L.arm",
// "Bip01 R Hand", "thigh L 2", "LeftArm", "handR", "hand.l.001". left and right also count inside a word ("armleft").
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

enum class Side { kLeft, kRight };

/// A marker in a name.
struct SideMarker {
  std::size_t begin = 0;   ///< Byte.
  std::size_t length = 0;  ///< Bytes.
  Side side = Side::kLeft;
};

/// All markers, in order. Where a whole word (left, right) is among them, only the words.
[[nodiscard]] std::vector<SideMarker> sideMarkers(std::string_view name);

/// The side that a name says; nothing where it has no marker, or as many of both.
[[nodiscard]] std::optional<Side> sideNamed(std::string_view name);

/// The name with its side changed, case kept: "thigh L" -> "thigh R", "LEFT_arm" -> "RIGHT_arm". Nothing where the name
/// has no marker or several: then the pattern is not clear. Its own inverse.
[[nodiscard]] std::optional<std::string> mirroredName(std::string_view name);

/// The name without its one marker and what parts it from the rest: "biceps L" -> "biceps", "L_biceps" -> "biceps". The
/// name itself where it has none or several, or nothing would be left.
[[nodiscard]] std::string withoutSide(const std::string& name);

}  // namespace sinew
