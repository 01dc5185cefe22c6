// app/command/speedup.cpp: the same moments by every projection, instruction set and number of threads in turn.
#include "app/command/speedup.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "app/viewport/render/view.h"
#include "core/character/skinning.h"
#include "core/geometry/instruction_set.h"
#include "core/geometry/stopwatch.h"
#include "sinew/geometry/threads.h"
#include "sinew/surface/crowd_smoother.h"

namespace sinew::app {

// The tables of the paper.

namespace {

constexpr int kTableFrames = 2;
constexpr std::array kProjections{ProjectionKind::kAnalytic, ProjectionKind::kBisection, ProjectionKind::kNewton};

/// A moment and the eye for culling: slightly to the side of the front, as for a picture.
struct Moment {
  Pose pose;
  glm::vec3 eye;
};

std::vector<Moment> momentsOf(const Character& character) {
  std::vector<Moment> moments;
  for (Pose& pose : spreadFrames(character, kTableFrames)) {
    SkinnedMesh skinned;
    skin(character, pose, skinned);
    const View view = framedView(skinned.positions, std::numbers::pi_v<float> / 6.0f, 0.2f, {1280, 800}, false);
    moments.push_back({std::move(pose), view.facingPoint()});
  }
  return moments;
}

struct TableContender {
  Smoother* smoother = nullptr;
  bool culling = false;
  Surface surface;
  std::vector<double> seconds;
};

void run(std::vector<TableContender>& contenders, const std::vector<Moment>& moments, int rounds) {
  inTurn(contenders.size(), rounds, [&](std::size_t variant, int round) {
    TableContender& contender = contenders[variant];
    for (const Moment& moment : moments) {
      const auto eye = contender.culling ? std::optional(moment.eye) : std::nullopt;
      contender.smoother->smooth(moment.pose, contender.surface, eye);
      if (round > 0) contender.seconds.push_back(contender.surface.report.seconds.total());
    }
  });
}

double rateOf(double seconds) { return seconds > 0.0 ? 1.0 / seconds : 0.0; }

bool isPaperHumanoid(const Character& character) {
  return 4.0 * static_cast<double>(character.mesh.triangles.size()) == kPaperTable2.front().humanoidTriangles;
}

bool isPaperHorse(const Character& character) {
  return 4.0 * static_cast<double>(character.mesh.triangles.size()) == kPaperTable2.front().horseTriangles;
}

std::optional<double> paperRate(const PaperRates& rates, ProjectionKind projection, bool culling) {
  if (projection == ProjectionKind::kAnalytic) return culling ? rates.analyticCulled : rates.analytic;
  if (projection == ProjectionKind::kBisection) return culling ? rates.bisectionCulled : rates.bisection;
  return std::nullopt;
}

}  // namespace

Result<std::vector<Table1Row>> measureTable1(const BenchScene& scene, int rounds) {
  const bool humanoid = isPaperHumanoid(*scene.character);
  const std::vector<Moment> moments = momentsOf(*scene.character);
  std::vector<Table1Row> rows;
  const InstructionSetScope vertexByVertex(InstructionSet::kScalar);  // Vectors have newton only.
  for (const PaperRates& paper : kPaperTable1) {                      // Depth by depth: all together fill the memory.
    std::vector<Smoother> smoothers;
    for (const ProjectionKind projection : kProjections) {
      Result<Smoother> smoother = preparedSmoother(scene, rigAt(scene, paper.depth), projection);
      if (!smoother) return smoother.error();
      smoothers.push_back(std::move(smoother.value()));
    }
    std::vector<TableContender> contenders;
    for (Smoother& smoother : smoothers) {
      for (const bool culling : {false, true}) contenders.push_back({&smoother, culling, {}, {}});
    }
    run(contenders, moments, rounds);
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      const double seconds = median(contenders[i].seconds);
      const ProjectionKind projection = kProjections[i / 2];
      const bool culling = contenders[i].culling;
      rows.push_back({scene.name, scene.rig.surface.mode, paper.depth, projection, culling, seconds, rateOf(seconds),
                      humanoid ? paperRate(paper, projection, culling) : std::nullopt});
    }
  }
  return rows;
}

Result<std::vector<Table2Row>> measureTable2(const BenchScene& scene, int rounds) {
  std::vector<Table2Row> rows;
  std::vector<Smoother> smoothers;
  const bool humanoid = isPaperHumanoid(*scene.character), horse = isPaperHorse(*scene.character);
  for (const PaperSizes& paper : kPaperTable2) {
    Result<Smoother> smoother = preparedSmoother(scene, rigAt(scene, paper.depth));
    if (!smoother) return smoother.error();
    smoothers.push_back(std::move(smoother.value()));
    Table2Row row{scene.name, scene.rig.surface.mode, paper.depth, 0, 0, 0.0, 0.0, {}, {}};
    if (humanoid || horse) {
      row.paperTriangles = humanoid ? paper.humanoidTriangles : paper.horseTriangles;
      row.paperFps = humanoid ? paper.humanoidFps : paper.horseFps;
    }
    rows.push_back(std::move(row));
  }
  std::vector<TableContender> contenders;
  for (Smoother& smoother : smoothers) contenders.push_back({&smoother, true, {}, {}});
  run(contenders, momentsOf(*scene.character), rounds);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const SmoothingReport& report = contenders[i].surface.report;
    rows[i].triangles = report.refinedTriangles;
    rows[i].vertices = report.refinedVertices;
    rows[i].frameSeconds = median(contenders[i].seconds);
    rows[i].fps = rateOf(rows[i].frameSeconds);
  }
  return rows;
}

// Vectors and threads.

namespace {

constexpr int kTimedFrames = 8;
constexpr double kSpeedupFrameStep = 1.0 / 60.0;
constexpr int kSpeedupCrowd = 100;
constexpr int kCrowdDepth = 3;
constexpr float kAgreement = 1e-4f;  // Fraction of H.

/// A sequence of moments, and the member for its ratio.
struct Situation {
  double SetSpeedup::*ratio;
  bool fresh;  ///< A new smoother for every frame.
  std::vector<Pose> poses;
};

/// One instruction set in one situation.
struct TimedThreads {
  InstructionSet set;
  Smoother smoother;
  Surface surface;
  std::vector<double> frameSeconds, projectSeconds;
};

long long countNotFinite(const Surface& surface) {
  const auto isFinite = [](const glm::vec3& v) { return std::isfinite(v.x + v.y + v.z); };
  return std::ranges::count_if(surface.positions, std::not_fn(isFinite)) +
         std::ranges::count_if(surface.normals, std::not_fn(isFinite));
}

struct Comparison {
  long long projected = 0, far = 0, uncertified = 0, notFinite = 0;

  void add(const Surface& reference, const Surface& optimized, float height) {
    projected += reference.report.projected;
    uncertified += optimized.report.uncertified;
    notFinite += countNotFinite(optimized);
    for (std::size_t v = 0; v < reference.positions.size(); ++v) {
      // NaN counts as far.
      if (!(glm::distance(reference.positions[v], optimized.positions[v]) <= kAgreement * height)) ++far;
    }
  }
  [[nodiscard]] Agreement shares() const {
    const auto all = static_cast<double>(std::max(projected, 1ll));
    return {1.0 - static_cast<double>(far) / all, static_cast<double>(uncertified) / all, notFinite, projected};
  }
};

/// Runs all sets in one situation. The first contender is the reference, the last the widest set.
Result<std::vector<TimedThreads>> run(const BenchScene& scene, const Situation& situation, int rounds,
                                      Comparison& comparison) {
  const Rig rig = rigAt(scene, kBenchDepth);
  std::vector<TimedThreads> contenders;
  for (const InstructionSet set : availableInstructionSets()) {
    Result<Smoother> smoother = preparedSmoother(scene, rig);
    if (!smoother) return smoother.error();
    contenders.push_back({set, std::move(smoother.value()), {}, {}, {}});
  }
  std::vector<Surface> references(situation.poses.size());
  inTurn(contenders.size(), rounds, [&](std::size_t variant, int round) {
    TimedThreads& contender = contenders[variant];
    const InstructionSetScope scope(contender.set);
    for (std::size_t p = 0; p < situation.poses.size(); ++p) {
      if (situation.fresh) {
        contender.smoother = std::move(preparedSmoother(scene, rig).value());  // It was prepared above.
        contender.surface = {};
      }
      contender.smoother.smooth(situation.poses[p], contender.surface);
      if (round > 0) {
        contender.frameSeconds.push_back(contender.surface.report.seconds.total());
        contender.projectSeconds.push_back(contender.surface.report.seconds.project);
      } else if (variant == 0) {  // In round 0 the reference comes first.
        references[p] = contender.surface;
      } else if (variant + 1 == contenders.size()) {
        comparison.add(references[p], contender.surface, scene.character->height);
      }
    }
  });
  return contenders;
}

Result<double> gainOf(const BenchScene& scene, int depth, int count, int rounds) {
  CrowdSmoother smoother(scene.character);
  if (const auto prepared = smoother.prepare(rigAt(scene, depth)); !prepared) return prepared.error();
  const std::vector<Pose> poses = steadyFrames(*scene.character, count, kSpeedupFrameStep);
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

Result<Speedups> measureSpeedups(const BenchScene& scene, int rounds) {
  const Character& character = *scene.character;
  const std::array situations{
      Situation{&SetSpeedup::cold, true, steadyFrames(character, 1, 0.0)},
      Situation{&SetSpeedup::warm60Hz, false, steadyFrames(character, kTimedFrames, kSpeedupFrameStep)},
      Situation{&SetSpeedup::warm20Hz, false, steadyFrames(character, kTimedFrames, 1.0 / 20.0)},
      Situation{&SetSpeedup::cut, false, cutFrames(character, kTimedFrames)},
  };
  Speedups speedups;
  for (const InstructionSet set : availableInstructionSets().subspan(1)) speedups.rows.push_back({nameOf(set), {}, {}});
  Comparison comparison;
  for (const Situation& situation : situations) {
    const auto contenders = run(scene, situation, rounds, comparison);
    if (!contenders) return contenders.error();
    const TimedThreads& reference = contenders->front();
    for (std::size_t i = 0; i < speedups.rows.size(); ++i) {
      const TimedThreads& contender = contenders.value()[i + 1];
      speedups.rows[i].frame.*situation.ratio = medianRatio(reference.frameSeconds, contender.frameSeconds);
      speedups.rows[i].projection.*situation.ratio = medianRatio(reference.projectSeconds, contender.projectSeconds);
    }
  }
  speedups.agreement = comparison.shares();
  return speedups;
}

Result<ThreadGain> measureThreads(const BenchScene& scene, int rounds) {
  const Result<double> single = gainOf(scene, kBenchDepth, 1, rounds);
  if (!single) return single.error();
  const Result<double> crowd = gainOf(scene, kCrowdDepth, kSpeedupCrowd, rounds);
  if (!crowd) return crowd.error();
  return ThreadGain{single.value(), crowd.value()};
}

}  // namespace sinew::app
