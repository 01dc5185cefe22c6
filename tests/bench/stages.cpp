// tests/bench/stages.cpp: smooths the same frames again and again and divides each stage's least time by the whole.
#include <algorithm>
#include <array>
#include <cstdio>

#include "app/command/measuring.h"
#include "sinew/geometry/threads.h"
#include "tests/bench/parts.h"

namespace sinew::app {
namespace {

/// One depth of one scene.
struct StageRow {
  std::string scene;
  int depth = 1;              ///< 0: adaptive detail.
  double projected = 0.0;     ///< Vertices a root was sought for, mean of the frames.
  double frameSeconds = 0.0;  ///< Sum of the stages' least times, mean of the frames.
  StageSeconds shares;        ///< Shares of the sum of all frames' least times.
};

constexpr std::array kDepths{3, 5, 0};
constexpr std::array kStages{&StageSeconds::skin, &StageSeconds::patch, &StageSeconds::project, &StageSeconds::folds,
                             &StageSeconds::normals};

/// The rig's own mode and search: what a user gets.
Rig atDepth(Rig rig, int depth) {
  rig.smoothing.detail = depth > 0 ? DetailKind::kUniform : DetailKind::kAdaptive;
  rig.smoothing.depth = std::max(depth, 1);
  return rig;
}

Result<StageRow> measureAt(int depth, const BenchScene& scene, int rounds, const std::vector<Pose>& poses) {
  Smoother smoother(scene.character);
  if (const auto prepared = smoother.prepare(atDepth(scene.rig, depth)); !prepared) return prepared.error();
  StageRow row{scene.name, depth, 0.0, 0.0, {}};
  Surface surface;
  std::vector<StageSeconds> least(poses.size());
  for (int round = 0; round <= rounds; ++round) {  // Round 0 warms up and counts.
    for (std::size_t i = 0; i < poses.size(); ++i) {
      smoother.smooth(poses[i], surface);
      if (round == 0) row.projected += surface.report.projected / static_cast<double>(poses.size());
      for (const auto stage : kStages) {
        const double seconds = surface.report.seconds.*stage;
        least[i].*stage = round <= 1 ? seconds : std::min(least[i].*stage, seconds);
      }
    }
  }
  StageSeconds sum;
  for (const StageSeconds& frame : least) {
    for (const auto stage : kStages) sum.*stage += frame.*stage;
  }
  row.frameSeconds = sum.total() / static_cast<double>(poses.size());
  for (const auto stage : kStages) row.shares.*stage = sum.*stage / std::max(sum.total(), 1e-12);
  return row;
}

/// Frames are spread evenly over the first clip, or are the bind pose.
Result<std::vector<StageRow>> measureStages(const BenchScene& scene, const Effort& effort) {
  const ThreadLimit one(1);
  const std::vector<Pose> poses = spreadFrames(*scene.character, effort.frames);
  std::vector<StageRow> rows;
  for (const int depth : kDepths) {
    Result<StageRow> row = measureAt(depth, scene, effort.rounds, poses);
    if (!row) return row.error();
    rows.push_back(std::move(row.value()));
  }
  return rows;
}

std::string tableOf(const std::vector<StageRow>& rows) {
  std::string table =
      "Smoothing as each rig asks. Of each frame's stages the least times of all rounds count: what the machine does\n"
      "when nothing else runs. Milliseconds of a frame, mean; per cent that each stage takes of all frames together.\n"
      "Depth adapt: adaptive detail.\n"
      "\n"
      "scene             depth  vertices  frame ms   skin  patch  project  folds  normals\n";
  char line[160];
  for (const StageRow& row : rows) {
    const StageSeconds& share = row.shares;
    const std::string depth = row.depth > 0 ? std::to_string(row.depth) : "adapt";
    std::snprintf(line, sizeof line, "%-16.40s  %5s  %8.0f  %8.3f  %5.1f  %5.1f  %7.1f  %5.1f  %7.1f\n",
                  row.scene.c_str(), depth.c_str(), row.projected, 1e3 * row.frameSeconds, 100.0 * share.skin,
                  100.0 * share.patch, 100.0 * share.project, 100.0 * share.folds, 100.0 * share.normals);
    table += line;
  }
  return table;
}

Json jsonOf(const std::vector<StageRow>& rows) {
  Json list = Json::array();
  for (const StageRow& row : rows) {
    Json shares = Json::object();
    shares.set("skin", row.shares.skin).set("patch", row.shares.patch).set("project", row.shares.project);
    shares.set("folds", row.shares.folds).set("normals", row.shares.normals);
    Json item = Json::object();
    item.set("scene", row.scene).set("depth", row.depth).set("vertices", row.projected);
    item.set("frame_seconds", row.frameSeconds).set("shares", shares);
    list.push(item);
  }
  return list;
}

}  // namespace

Result<Report> reportStages(Files files, const Effort& effort) {
  const auto rows = rowsOf<StageRow>(files, [&](const auto& scene) { return measureStages(scene, effort); });
  if (!rows) return rows.error();
  return Report{tableOf(rows.value()), jsonOf(rows.value())};
}

}  // namespace sinew::app
