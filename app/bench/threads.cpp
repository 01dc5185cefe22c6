// app/bench/threads.cpp: the same poses by one thread and by two, in turn.
#include "app/bench/threads.h"

#include <array>

#include "app/bench/measuring.h"
#include "core/base/stopwatch.h"
#include "sinew/base/threads.h"
#include "sinew/smoothing/crowd_smoother.h"

namespace sinew::app {
namespace {

constexpr int kCrowd = 100;
constexpr int kCrowdDepth = 3;
constexpr double kStep = 1.0 / 60.0;

Result<double> gainOf(const BenchScene& scene, int depth, int count, int rounds) {
  CrowdSmoother smoother(scene.character);
  if (const auto prepared = smoother.prepare(rigAt(scene, depth)); !prepared) return prepared.error();
  const std::vector<Pose> poses = steadyFrames(*scene.character, count, kStep);
  std::vector<Surface> surfaces(poses.size());
  std::array<std::vector<double>, 2> seconds;  // [threads - 1]
  inTurn(seconds.size(), rounds, [&](std::size_t variant, int round) {
    const ThreadLimit limit(static_cast<int>(variant) + 1);
    Stopwatch watch;
    smoother.smooth(poses, surfaces);
    if (round > 0) seconds[variant].push_back(watch.lap());
  });
  return medianRatio(seconds[0], seconds[1]);
}

}  // namespace

Result<ThreadGain> measureThreads(const BenchScene& scene, int rounds) {
  const Result<double> single = gainOf(scene, kBenchDepth, 1, rounds);
  if (!single) return single.error();
  const Result<double> crowd = gainOf(scene, kCrowdDepth, kCrowd, rounds);
  if (!crowd) return crowd.error();
  return ThreadGain{single.value(), crowd.value()};
}

}  // namespace sinew::app
