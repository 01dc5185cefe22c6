// tests/bench/kernel_bench.cpp: a frame and its stages by every instruction set, with Google Benchmark.
//
// Names are scene/depth/set: kernel_bench --benchmark_filter=horse/5. A time is that of one surface, a moment after
// another one; the counters are the stages' seconds of it, and refined vertices a second.
#include <array>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "core/geometry/instruction_set.h"
#include "sinew/geometry/threads.h"
#include "sinew/surface/smoother.h"
#include "tests/support/rigs/trial_scenes.h"

namespace sinew::test {
namespace {

constexpr int kMoments = 6;

struct Stage {
  const char* name;
  double StageSeconds::*seconds;
};

constexpr Stage kStages[] = {{"skin", &StageSeconds::skin},
                             {"patch", &StageSeconds::patch},
                             {"project", &StageSeconds::project},
                             {"folds", &StageSeconds::folds},
                             {"normals", &StageSeconds::normals}};

/// A rig at one depth, prepared.
struct Subject {
  std::string name;
  Smoother smoother;
  std::vector<Pose> poses;
  Surface surface{};
};

void run(benchmark::State& state, Subject& subject, InstructionSet set) {
  const ThreadLimit one(1);
  const InstructionSetScope scope(set);
  std::array<double, std::size(kStages)> seconds{};
  std::size_t moment = 0;
  for (auto unused : state) {
    subject.smoother.smooth(subject.poses[moment++ % subject.poses.size()], subject.surface);
    for (std::size_t i = 0; i < seconds.size(); ++i) seconds[i] += subject.surface.report.seconds.*kStages[i].seconds;
  }
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    state.counters[kStages[i].name] = benchmark::Counter(seconds[i], benchmark::Counter::kAvgIterations);
  }
  const auto vertices = static_cast<double>(subject.surface.positions.size());
  state.counters["vertices"] = benchmark::Counter(vertices, benchmark::Counter::kIsIterationInvariantRate);
}

bool addSubjects(const char* scene, std::vector<std::unique_ptr<Subject>>& subjects) {
  const TrialScene trial = bundledTrialScene(scene);
  for (const int depth : {3, 5}) {
    Rig rig = trial.rig;
    rig.smoothing.detail = DetailKind::kUniform;
    rig.smoothing.depth = depth;
    auto subject =
        std::make_unique<Subject>(Subject{std::string(scene) + '/' + std::to_string(depth), Smoother(trial.character),
                                          spreadPoses(*trial.character, kMoments)});
    if (!subject->smoother.prepare(rig)) return false;
    subjects.push_back(std::move(subject));
  }
  return true;
}

/// @return false if a bundled rig cannot be prepared.
bool registerAll(std::vector<std::unique_ptr<Subject>>& subjects) {
  for (const char* scene : {"humanoid", "horse", "humanoid-wrapped", "horse-wrapped"}) {
    if (!addSubjects(scene, subjects)) return false;
  }
  for (const auto& subject : subjects) {
    for (const InstructionSet set : availableInstructionSets()) {
      const std::string name = subject->name + '/' + nameOf(set);
      benchmark::RegisterBenchmark(name.c_str(), [&subject = *subject, set](benchmark::State& state) {
        run(state, subject, set);
      })->Unit(benchmark::kMicrosecond);
    }
  }
  return true;
}

}  // namespace
}  // namespace sinew::test

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  std::vector<std::unique_ptr<sinew::test::Subject>> subjects;
  if (!sinew::test::registerAll(subjects)) return 1;
  return benchmark::RunSpecifiedBenchmarks() > 0 ? 0 : 1;
}
