// app/editor/animated_names.h: how the interface and the history call numbers that are keyed or driven, and inputs.
#pragma once

#include <array>
#include <span>
#include <string>

#include "core/rig/animated_edit.h"
#include "sinew/character/skeleton.h"

namespace sinew::app {

/// "radius X of biceps L", "radius X of 3 muscles", "skin blend". At least one, all of one parameter.
[[nodiscard]] std::string wordsFor(const Rig& rig, std::span<const NumberRef> refs);
/// "bend of forearm.L", "length of biceps L", "channel effort".
[[nodiscard]] std::string wordsFor(const DriverInput& input, const Skeleton& skeleton);
/// The input's value as it is read: degrees, per cent or a plain number.
[[nodiscard]] std::string inputText(DriverInputKind kind, float value);
/// "Smooth"
[[nodiscard]] const char* wordFor(CurveKind kind);
inline constexpr std::array kCurveKinds{CurveKind::kSmooth, CurveKind::kLinear, CurveKind::kStep};
/// "0.43 s"
[[nodiscard]] std::string timeText(double seconds);

}  // namespace sinew::app
