// app/command/measuring.h: scenes, frames and medians for the benchmarks.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"
#include "sinew/surface/smoother.h"

namespace sinew::app {

/// A character with muscles in one surface mode.
struct BenchScene {
  std::string name;
  std::shared_ptr<const Character> character;
  Rig rig;
};

/// Opens a rig or a character (without muscles: 12 by rule), named "fox" for fox.glb. Error: as openDocument.
[[nodiscard]] Result<BenchScene> openScene(const std::filesystem::path& file);

inline constexpr int kBenchDepth = 5;  ///< Depth of single figures: the highest of the paper's second table.

[[nodiscard]] Rig rigAt(const BenchScene& scene, int depth);  ///< The scene's rig at a depth.

/// Error: the rig is refused.
[[nodiscard]] Result<Smoother> preparedSmoother(const BenchScene& scene, const Rig& rig,
                                                ProjectionKind projection = ProjectionKind::kNewton);

[[nodiscard]] double median(std::vector<double> values);  ///< The upper one of an even number; 0 for none.

/// Median of above[i] / below[i] where below[i] > 0; 0 for none. Both have the same length.
[[nodiscard]] double medianRatio(const std::vector<double>& above, const std::vector<double>& below);

/// p of y = c x^p, by least squares of the logarithms where both are > 0; 0 for fewer than two different x. Both have
/// the same length.
[[nodiscard]] double exponent(const std::vector<double>& x, const std::vector<double>& y);

/// Runs every variant once a round, each round beginning with the next one, so that slow moments of the machine and
/// warm caches affect all alike. Round 0 warms up and must not be counted; rounds 1..rounds follow.
/// @param run  (variant, round)
void inTurn(std::size_t variants, int rounds, const std::function<void(std::size_t, int)>& run);

/// `count` moments of the first clip, looped, `step` seconds apart; copies of the bind pose without a clip.
[[nodiscard]] std::vector<Pose> steadyFrames(const Character& character, int count, double step);

/// Moments that are far from each other: the clip's halves in turn.
[[nodiscard]] std::vector<Pose> cutFrames(const Character& character, int count);

/// Moments spread evenly over the first clip; the bind pose alone without a clip.
[[nodiscard]] std::vector<Pose> spreadFrames(const Character& character, int count);

}  // namespace sinew::app
