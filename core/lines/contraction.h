// core/lines/contraction.h: how a muscle answers to the length of its line.
#pragma once

#include "sinew/rig/muscle_line.h"

namespace sinew {

/// Girth from belly stretch, both against the bind pose (omega; Scheepers' closed form where volume is 1).
[[nodiscard]] double girth(double bellyStretch, const LineSettings& settings);
/// Belly stretch of a line's stretch: tendons keep their length.
[[nodiscard]] double bellyStretch(double stretch, const LineSettings& settings);
/// Activation of a line's stretch, 0..1. @param added  to its base
[[nodiscard]] double activation(double stretch, const LineSettings& settings, double added);

}  // namespace sinew
