// tests/bench/projections.cpp: work, time and agreement of the three projections on the same frames, in turn.
#include <algorithm>
#include <array>
#include <cstdio>

#include <glm/geometric.hpp>

#include "app/command/measuring.h"
#include "core/geometry/instruction_set.h"
#include "sinew/geometry/threads.h"
#include "tests/bench/parts.h"

namespace sinew::app {
namespace {

/// One mode and projection of one scene, over all its frames. Lengths are fractions of H.
struct ProjectionRow {
  std::string scene;
  SurfaceMode mode = SurfaceMode::kSwell;
  ProjectionKind projection = ProjectionKind::kNewton;
  double projected = 0.0;         ///< Vertices a root was sought for, mean of the frames.
  double fieldPerVertex = 0.0;    ///< Evaluations::field per such vertex.
  double quarticPerVertex = 0.0;  ///< Evaluations::quartic per such vertex.
  double frameSeconds = 0.0;      ///< Median of all timed frames: skin, patch and projection.
  double projectSeconds = 0.0;    ///< ... the projection alone.
  double frameRatio = 1.0;        ///< Median of time / newton's time for the same frame in the same round.
  double projectRatio = 1.0;
  double differenceMax = 0.0;    ///< Largest distance of a vertex from newton's.
  double differenceShare = 0.0;  ///< Share of the projected vertices further than 1e-4 from newton's.
  double unresolved = 0.0;       ///< Mean of the frames.
  double anchorFallbacks = 0.0;  ///< Mean of the frames.
};

constexpr std::array kProjections{ProjectionKind::kNewton, ProjectionKind::kBisection, ProjectionKind::kAnalytic};
constexpr std::size_t kNewton = 0;
constexpr double kAgreement = 1e-4;  // Fraction of H.

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

Result<std::vector<Contender>> contendersOf(const BenchScene& scene, SurfaceMode mode) {
  std::vector<Contender> contenders;
  for (const ProjectionKind projection : kProjections) {
    Rig rig = scene.rig;
    rig.surface.mode = mode;
    rig.smoothing.projection = projection;
    Contender contender{Smoother(scene.character), {}, {}, {}, {}, {}, {}, 0};
    if (const auto prepared = contender.smoother.prepare(rig); !prepared) return prepared.error();
    contender.row.scene = scene.name;
    contender.row.mode = mode;
    contender.row.projection = projection;
    contenders.push_back(std::move(contender));
  }
  return contenders;
}

/// In every round each frame is smoothed by all three in turn, so that a slow moment of the machine meets them alike.
Result<std::vector<ProjectionRow>> measureProjections(const BenchScene& scene, const Effort& effort) {
  const ThreadLimit one(1);
  // Like with like: the vector path knows newton alone.
  const InstructionSetScope vertexByVertex(InstructionSet::kScalar);
  const std::vector<Pose> poses = spreadFrames(*scene.character, effort.frames);
  std::vector<ProjectionRow> rows;
  for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) {
    progress("measuring " + scene.name + ", " + nameOf(mode));
    auto contenders = contendersOf(scene, mode);
    if (!contenders) return contenders.error();
    std::vector<Contender>& all = contenders.value();
    for (int round = 0; round <= effort.rounds; ++round) {  // Round 0 warms up and counts.
      for (const Pose& pose : poses) {
        for (Contender& contender : all) contender.smoother.smooth(pose, contender.surface);
        for (Contender& contender : all) {
          if (round == 0) {
            recordCounts(contender, all[kNewton].surface, scene.character->height);
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

constexpr const char* kColumns =
    "scene, mode, projection   what was smoothed, and how roots were found\n"
    "vertices                  refined vertices for which a root was sought, mean of the frames\n"
    "field, quartic            evaluations per such vertex: of the field along its ray, of quartics made from it\n"
    "frame, project            milliseconds, median: a whole frame (skin, patch, project), the projection alone\n"
    "x newton                  the same over newton's for the same frame in the same round, median\n"
    "differs, far              largest distance from newton's vertices in H; share of the vertices beyond 1e-4 H\n"
    "lost, fallback            vertices without a root; anchors outside, replaced by the normal; mean of the frames\n"
    "In replace, analytic follows the normal and the other two the segment to the anchor: it differs by definition.\n";

std::string tableOf(const std::vector<ProjectionRow>& rows) {
  std::size_t widest = 5;
  for (const ProjectionRow& row : rows) widest = std::max(widest, row.scene.size());
  const int width = static_cast<int>(std::min<std::size_t>(widest, 40));
  char line[320];
  std::snprintf(line, sizeof line, "%-*s  %-7s  %-10s  %8s  %6s  %7s  %9s  %8s  %10s  %8s  %9s  %6s  %6s  %8s\n", width,
                "scene", "mode", "projection", "vertices", "field", "quartic", "frame ms", "x newton", "project ms",
                "x newton", "differs H", "far %", "lost", "fallback");
  std::string table = std::string(kColumns) + '\n' + line;
  for (const ProjectionRow& row : rows) {
    std::snprintf(
        line, sizeof line,
        "%-*.40s  %-7s  %-10s  %8.0f  %6.2f  %7.2f  %9.3f  %8.2f  %10.3f  %8.2f  %9.2g  %6.2f  %6.1f  %8.1f\n", width,
        row.scene.c_str(), nameOf(row.mode), nameOf(row.projection), row.projected, row.fieldPerVertex,
        row.quarticPerVertex, 1e3 * row.frameSeconds, row.frameRatio, 1e3 * row.projectSeconds, row.projectRatio,
        row.differenceMax, 100.0 * row.differenceShare, row.unresolved, row.anchorFallbacks);
    table += line;
  }
  return table;
}

Json jsonOf(const std::vector<ProjectionRow>& rows) {
  Json list = Json::array();
  for (const ProjectionRow& row : rows) {
    Json item = Json::object();
    item.set("scene", row.scene).set("mode", nameOf(row.mode)).set("projection", nameOf(row.projection));
    item.set("vertices", row.projected);
    item.set("field_per_vertex", row.fieldPerVertex).set("quartic_per_vertex", row.quarticPerVertex);
    item.set("frame_seconds", row.frameSeconds).set("frame_ratio", row.frameRatio);
    item.set("project_seconds", row.projectSeconds).set("project_ratio", row.projectRatio);
    item.set("difference_max", row.differenceMax).set("difference_share", row.differenceShare);
    item.set("unresolved", row.unresolved).set("anchor_fallbacks", row.anchorFallbacks);
    list.push(item);
  }
  return list;
}

}  // namespace

Result<Report> reportProjections(Files files, const Effort& effort) {
  const auto rows = rowsOf<ProjectionRow>(files, [&](const auto& scene) { return measureProjections(scene, effort); });
  if (!rows) return rows.error();
  return Report{tableOf(rows.value()), jsonOf(rows.value())};
}

}  // namespace sinew::app
