// core/rig/contraction.h: how a muscle answers to the length of its line.
#pragma once

#include "sinew/rig/muscle_line.h"

namespace sinew {

/// What of the girth does not depend on the pose.
struct GirthRest {
  double volume = 1.0;
  double least = 1.0;   ///< -ln of the stretch towards which girth levels off when the belly shortens.
  double most = 1.0;    ///< ln of that when it lengthens.
  double inBind = 0.0;  ///< Softened logarithm of the belly stretch in the bind pose.
};

[[nodiscard]] GirthRest girthRest(const LineSettings& settings);

/// Girth from belly stretch, both against the bind pose (omega; Scheepers' closed form where volume is 1).
[[nodiscard]] double girth(double bellyStretch, const GirthRest& rest);
/// What tendons leave of the rest length.
[[nodiscard]] double bellyShare(const LineSettings& settings);
/// Belly stretch of a line's stretch: tendons keep their length.
[[nodiscard]] double bellyStretch(double stretch, const LineSettings& settings);
/// Activation of a line's stretch, 0..1. @param added  to its base
[[nodiscard]] double activation(double stretch, const LineSettings& settings, double added);

}  // namespace sinew
