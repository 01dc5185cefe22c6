// app/bench/projections.cpp: smooths the same frames by all projections in turn.
#include "app/bench/projections.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>

#include "app/bench/measuring.h"
#include "core/lanes/instruction_set.h"
#include "sinew/base/threads.h"

namespace sinew::app {
namespace {

constexpr std::array kProjections{ProjectionKind::kNewton, ProjectionKind::kBisection, ProjectionKind::kAnalytic};
constexpr std::size_t kNewton = 0;
constexpr double kAgreement = 1e-4;  // Of H.

/// One projection at work: its smoother and what it has shown so far.
struct Contender {
  Smoother smoother;
  Surface surface;
  ProjectionRow row;
  std::vector<double> frameSeconds, projectSeconds, frameRatios, projectRatios;
  long long far = 0;
};

/// What does not change from round to round.
void recordCounts(Contender& contender, const Surface& newton, float height) {
  const SmoothingReport& report = contender.surface.report;
  ProjectionRow& row = contender.row;
  row.projected += report.projected;
  row.fieldPerVertex += static_cast<double>(report.evaluations.field);
  row.quarticPerVertex += static_cast<double>(report.evaluations.quartic);
  row.unresolved += report.unresolved;
  row.anchorFallbacks += report.anchorFallbacks;
  for (std::size_t v = 0; v < newton.positions.size(); ++v) {
    const auto apart = static_cast<double>(glm::distance(contender.surface.positions[v], newton.positions[v]) / height);
    row.differenceMax = std::max(row.differenceMax, apart);
    if (apart > kAgreement) ++contender.far;
  }
}

void recordTimes(Contender& contender, const StageSeconds& newton) {
  const StageSeconds& seconds = contender.surface.report.seconds;
  contender.frameSeconds.push_back(seconds.total());
  contender.projectSeconds.push_back(seconds.project);
  if (newton.total() > 0.0) contender.frameRatios.push_back(seconds.total() / newton.total());
  if (newton.project > 0.0) contender.projectRatios.push_back(seconds.project / newton.project);
}

ProjectionRow finished(Contender& contender, std::size_t frames) {
  ProjectionRow row = contender.row;
  const double sought = std::max(row.projected, 1.0);
  row.fieldPerVertex /= sought;
  row.quarticPerVertex /= sought;
  row.differenceShare = static_cast<double>(contender.far) / sought;
  row.projected /= static_cast<double>(frames);
  row.unresolved /= static_cast<double>(frames);
  row.anchorFallbacks /= static_cast<double>(frames);
  row.frameSeconds = median(contender.frameSeconds);
  row.projectSeconds = median(contender.projectSeconds);
  row.frameRatio = median(contender.frameRatios);
  row.projectRatio = median(contender.projectRatios);
  return row;
}

Result<std::vector<Contender>> contendersOf(const ProjectionTrial& trial, SurfaceMode mode) {
  std::vector<Contender> contenders;
  for (const ProjectionKind projection : kProjections) {
    Rig rig = trial.rig;
    rig.surface.mode = mode;
    rig.smoothing.projection = projection;
    Contender contender{Smoother(trial.character), {}, {}, {}, {}, {}, {}, 0};
    if (const auto prepared = contender.smoother.prepare(rig); !prepared) return prepared.error();
    contender.row.scene = trial.scene;
    contender.row.mode = mode;
    contender.row.projection = projection;
    contenders.push_back(std::move(contender));
  }
  return contenders;
}

}  // namespace

Result<std::vector<ProjectionRow>> measureProjections(const ProjectionTrial& trial,
                                                      const std::function<void(const std::string&)>& report) {
  const ThreadLimit one(1);
  // Like with like: the vector path knows newton alone.
  const InstructionSetScope vertexByVertex(InstructionSet::kScalar);
  const std::vector<Pose> poses = spreadFrames(*trial.character, trial.frames);
  std::vector<ProjectionRow> rows;
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    report(trial.scene + ", " + nameOf(mode));
    auto contenders = contendersOf(trial, mode);
    if (!contenders) return contenders.error();
    std::vector<Contender>& all = contenders.value();
    for (int round = 0; round <= trial.rounds; ++round) {  // Round 0 warms up and counts.
      for (const Pose& pose : poses) {
        for (Contender& contender : all) contender.smoother.smooth(pose, contender.surface);
        for (Contender& contender : all) {
          if (round == 0) {
            recordCounts(contender, all[kNewton].surface, trial.character->height);
          } else {
            recordTimes(contender, all[kNewton].surface.report.seconds);
          }
        }
      }
    }
    for (Contender& contender : all) rows.push_back(finished(contender, poses.size()));
  }
  return rows;
}

}  // namespace sinew::app
