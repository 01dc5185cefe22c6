// tests/viewport/render/moving_resolution_test.cpp: resolution of a moving picture adapts to given frame times, and
// settles.

#include "app/window/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace sinew::test {
namespace {

using app::FrameCost;
using app::MovingResolution;

constexpr double kGoal = MovingResolution::kFrameGoal;

/// Simulated machine: cost of a frame at a scale.
struct Machine {
  double fixed = 0.0;     ///< Drawing that is independent of the resolution.
  double perPixel = 0.0;  ///< Drawing of a full-size picture.
  double other = 0.0;
  double noise = 0.0;  ///< Fraction by which a frame may take longer.

  [[nodiscard]] FrameCost cost(float scale, double chance = 0.0) const {
    const auto s = static_cast<double>(scale);
    return {(fixed + perPixel * s * s) * (1.0 + noise * chance), other};
  }
  [[nodiscard]] double seconds(float scale) const { return cost(scale).drawing + other; }
};

std::vector<float> played(MovingResolution& resolution, const Machine& machine, int frames, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> chance(0.0, 1.0);
  std::vector<float> scales;
  for (int i = 0; i < frames; ++i) {
    scales.push_back(resolution.scale());
    resolution.add(machine.cost(resolution.scale(), chance(random)));
  }
  return scales;
}

int changes(const std::vector<float>& scales) {
  int count = 0;
  for (std::size_t i = 1; i < scales.size(); ++i) count += scales[i] != scales[i - 1] ? 1 : 0;
  return count;
}

TEST(MovingResolutions, FastMachineKeepsFullResolution) {
  for (const double share : {0.01, 0.3, 0.7, 1.0}) {
    MovingResolution resolution;
    const std::vector<float> scales = played(resolution, {0.5 * share * kGoal, 0.5 * share * kGoal, 0.0, 0.05}, 1000);
    EXPECT_EQ(std::ranges::min(scales), 1.0f) << share;
  }
}

TEST(MovingResolutions, MeetsTheFrameTimeGoalIfPossible) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const float least = MovingResolution::kScales.back();
  int lowered = 0;
  for (int i = 0; i < 500; ++i) {
    const Machine machine{0.4 * kGoal * part(random), 5.0 * kGoal * part(random), 0.4 * kGoal * part(random)};
    MovingResolution resolution;
    played(resolution, machine, 400);
    const float scale = resolution.scale();
    if (machine.seconds(least) > 1.1 * kGoal) {
      EXPECT_EQ(scale, least) << "out of reach: as near as it gets";
      continue;
    }
    EXPECT_LE(machine.seconds(scale), 1.1 * kGoal + 1e-9) << machine.fixed << " " << machine.perPixel;
    lowered += scale < 1.0f ? 1 : 0;
  }
  EXPECT_GT(lowered, 100);
}

TEST(MovingResolutions, IsNoCoarserThanNecessary) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const auto& scales = MovingResolution::kScales;
  for (int i = 0; i < 500; ++i) {
    const Machine machine{0.0, 5.0 * kGoal * part(random), 0.4 * kGoal * part(random)};
    MovingResolution resolution;
    played(resolution, {0.0, 100.0 * kGoal, 0.0}, 100);  // Starting at the coarsest.
    ASSERT_EQ(resolution.scale(), scales.back());
    played(resolution, machine, 400);
    const auto* const at = std::ranges::find(scales, resolution.scale());
    if (at == scales.begin()) continue;
    EXPECT_GT(machine.seconds(at[-1]), kGoal) << "the finer step would keep the goal too";
  }
}

TEST(MovingResolutions, SettlesAndStays) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (unsigned i = 0; i < 300; ++i) {
    const Machine machine{0.3 * kGoal * part(random), 4.0 * kGoal * part(random), 0.3 * kGoal * part(random), 0.05};
    MovingResolution resolution;
    played(resolution, machine, 400, i);
    const int later = changes(played(resolution, machine, 600, i + 1000));
    EXPECT_LE(later, 1) << machine.fixed << " " << machine.perPixel << " " << machine.other;
  }
}

/// Drawing of `machine` except for `fixed` overlaps with the surface's computation.
FrameCost overlapped(const Machine& machine, float scale) {
  const double pixels = machine.perPixel * static_cast<double>(scale) * static_cast<double>(scale);
  return {machine.fixed + std::max(pixels - machine.other, 0.0), machine.other, machine.other};
}

TEST(MovingResolutions, SettlesIfDrawingTimeIsHidden) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  int coarse = 0;
  for (int i = 0; i < 500; ++i) {
    const Machine machine{0.4 * kGoal * part(random), 4.0 * kGoal * part(random), 0.9 * kGoal * part(random)};
    MovingResolution resolution;
    for (int frame = 0; frame < 400; ++frame) resolution.add(overlapped(machine, resolution.scale()));
    const float settled = resolution.scale();
    for (int frame = 0; frame < 200; ++frame) {
      resolution.add(overlapped(machine, resolution.scale()));
      ASSERT_EQ(resolution.scale(), settled) << machine.fixed << " " << machine.perPixel << " " << machine.other;
    }
    coarse += settled < 1.0f ? 1 : 0;
  }
  EXPECT_GT(coarse, 100);
}

TEST(MovingResolutions, OneSlowFrameChangesNothing) {
  MovingResolution resolution;
  for (int i = 0; i < 200; ++i) {
    resolution.add({i % 3 == 0 ? 20.0 * kGoal : 0.5 * kGoal, 0.0});
    ASSERT_EQ(resolution.scale(), 1.0f);
  }
}

TEST(MovingResolutions, SlowSurfaceDoesNotReduceIt) {
  MovingResolution resolution;
  played(resolution, {0.1 * kGoal, 0.3 * kGoal, 8.0 * kGoal}, 300);
  EXPECT_EQ(resolution.scale(), 1.0f);
}

TEST(MovingResolutions, DropsWithinAFewFramesAndRecovers) {
  MovingResolution resolution;
  const std::vector<float> down = played(resolution, {0.0, 4.0 * kGoal, 0.0}, 9);
  EXPECT_LE(resolution.scale(), 0.55f);
  EXPECT_TRUE(std::ranges::is_sorted(down, std::greater<>())) << "without going back and forth";
  const std::vector<float> up = played(resolution, {0.0, 0.2 * kGoal, 0.0}, 200);
  EXPECT_EQ(resolution.scale(), 1.0f);
  EXPECT_TRUE(std::ranges::is_sorted(up));
}

TEST(MovingResolutions, RandomTimesKeepItOnAStep) {
  std::mt19937 random(10);
  std::exponential_distribution<double> seconds(1.0 / kGoal);
  MovingResolution resolution;
  for (int i = 0; i < 20000; ++i) {
    resolution.add({i % 7 == 0 ? 0.0 : 2.0 * seconds(random), seconds(random)});
    const float scale = resolution.scale();
    ASSERT_NE(std::ranges::find(MovingResolution::kScales, scale), MovingResolution::kScales.end());
  }
}

}  // namespace
}  // namespace sinew::test
