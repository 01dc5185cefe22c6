// app/command/measuring.h: medians and the frames to measure, for the benchmarks.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/character/pose.h"

namespace sinew::app {

/// The upper one of an even number; 0 of none.
[[nodiscard]] double median(std::vector<double> values);

/// Median of above[i] / below[i], of those with below[i] > 0; 0 of none. Both of one length.
[[nodiscard]] double medianRatio(const std::vector<double>& above, const std::vector<double>& below);

/// p of y = c x^p, by least squares of the logarithms. Only places where both are > 0 count; 0 of fewer than two
/// different x. Both of one length.
[[nodiscard]] double exponent(const std::vector<double>& x, const std::vector<double>& y);

/// Runs every variant once a round, each round beginning with the next one, so that a slow moment of the machine and
/// what one leaves in the caches meet all alike. Round 0 warms up and is not to be counted; rounds 1..rounds follow.
/// @param run  (variant, round)
void inTurn(std::size_t variants, int rounds, const std::function<void(std::size_t, int)>& run);

/// `count` moments of the first clip, `step` seconds apart from its start, round and round; the bind pose that often
/// where there is none.
[[nodiscard]] std::vector<Pose> steadyFrames(const Character& character, int count, double step);

/// As many moments, each far from the one before: the clip's halves in turn.
[[nodiscard]] std::vector<Pose> cutFrames(const Character& character, int count);

/// Spread evenly over the first clip; the bind pose alone where there is none.
[[nodiscard]] std::vector<Pose> spreadFrames(const Character& character, int count);

}  // namespace sinew::app
