// tests/bench/settle.cpp: adaptive detail while muscles are dragged, and how soon its levels have settled afterwards.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <utility>

#include "app/command/measuring.h"
#include "app/document/document.h"
#include "app/document/playback.h"
#include "core/geometry/stopwatch.h"
#include "sinew/geometry/threads.h"
#include "sinew/rig/rig_edit.h"
#include "tests/bench/parts.h"

namespace sinew::app {
namespace {

/// Seconds of one way to run: one core, or all.
struct SettleRow {
  std::string scene;
  int threads = 1;
  int vertices = 0;
  int muscles = 0;            ///< That were dragged, one after the other.
  double drag = 0.0;          ///< Edit, prepare, smooth: median of all frames of all drags.
  double worstDrag = 0.0;     ///< The slowest muscle's median.
  double prepare = 0.0;       ///< Of a drag's frame, median.
  double settled = 0.0;       ///< The frame after a drag: its levels are those of the new rig. Median of the muscles.
  double worstSettled = 0.0;  ///< The slowest muscle's.
  double settledCpu = 0.0;    ///< What the processor works on it, all threads, median: others do not count.
};

constexpr int kFramesOfDrag = 5;

/// Beside the dragged muscle its twin moves, as in the editor.
Placement draggedBy(Placement placement, int frame) {
  const float way = 0.05f * static_cast<float>(frame + 1);
  placement.center += way * placement.radii.x * glm::vec3(1.0f, 0.5f, 0.0f);
  placement.radii *= 1.0f + 0.2f * way;
  return placement;
}

Result<SettleRow> measureWith(int threads, const BenchScene& scene, const Effort& effort) {
  const ThreadLimit limit(threads);
  Document document;
  document.character = scene.character;
  Rig rig = scene.rig;
  rig.smoothing.detail = DetailKind::kAdaptive;
  document.commands = CommandStack(rig);
  prepareMirror(document);
  Transport transport;
  Result<LiveSurface> created = LiveSurface::create(document, transport);
  if (!created) return created.error();
  LiveSurface live = std::move(created).value();
  SettleRow row{scene.name, threads, live.report().refinedVertices};
  const auto count = static_cast<int>(rig.primitives.size());
  std::vector<double> drags;
  std::vector<double> prepares;
  std::vector<double> settles;
  std::vector<double> cpu;
  row.muscles = std::min(count, effort.frames);
  for (int i = 0; i < row.muscles; ++i) {
    const int muscle = i * count / row.muscles;
    const Placement start = at(document.rig().primitives, muscle).placement;
    std::vector<double> ownDrags;
    std::vector<double> ownSettles;
    for (int round = 0; round < effort.rounds; ++round) {
      document.commands.beginGesture("Drag");
      for (int frame = 0; frame < kFramesOfDrag; ++frame) {
        Stopwatch watch;
        Result<Rig> moved = setPlacement(document.rig(), muscle, draggedBy(start, frame));
        if (!moved) return moved.error();
        document.commands.updateGesture(std::move(moved).value());
        if (const Result<bool> updated = live.update(document); !updated) return updated.error();
        ownDrags.push_back(watch.lap());
        prepares.push_back(live.prepareSeconds());
      }
      document.commands.endGesture();
      const std::clock_t worked = std::clock();
      Stopwatch watch;
      if (const Result<bool> updated = live.update(document); !updated) return updated.error();
      ownSettles.push_back(watch.lap());
      cpu.push_back(static_cast<double>(std::clock() - worked) / CLOCKS_PER_SEC);
      document.commands.undo();
      if (const Result<bool> updated = live.update(document); !updated) return updated.error();
    }
    drags.insert(drags.end(), ownDrags.begin(), ownDrags.end());
    settles.insert(settles.end(), ownSettles.begin(), ownSettles.end());
    row.worstDrag = std::max(row.worstDrag, median(std::move(ownDrags)));
    row.worstSettled = std::max(row.worstSettled, median(std::move(ownSettles)));
  }
  row.drag = median(std::move(drags));
  row.prepare = median(std::move(prepares));
  row.settled = median(std::move(settles));
  row.settledCpu = median(std::move(cpu));
  return row;
}

Result<std::vector<SettleRow>> measureSettling(const BenchScene& scene, const Effort& effort) {
  std::vector<SettleRow> rows;
  for (const int threads : {1, 2}) {
    Result<SettleRow> row = measureWith(threads, scene, effort);
    if (!row) return row.error();
    rows.push_back(std::move(row).value());
  }
  return rows;
}

std::string tableOf(const std::vector<SettleRow>& rows) {
  std::string table =
      "Muscles are dragged in the bind pose, one after the other, with adaptive detail. Milliseconds beside drawing of "
      "a\n"
      "frame of a drag (edit, prepare, smooth) and of prepare alone; of the frame after it, in which levels are found "
      "anew,\n"
      "and of the processor's work on it: medians of all muscles, and the slowest muscle's.\n"
      "\n"
      "scene             threads  vertices  muscles  drag ms  slowest  prepare  settled ms  slowest  processor\n";
  char line[160];
  for (const SettleRow& row : rows) {
    std::snprintf(line, sizeof line, "%-16.40s  %7d  %8d  %7d  %7.2f  %7.2f  %7.2f  %10.2f  %7.2f  %7.2f\n",
                  row.scene.c_str(), row.threads, row.vertices, row.muscles, 1e3 * row.drag, 1e3 * row.worstDrag,
                  1e3 * row.prepare, 1e3 * row.settled, 1e3 * row.worstSettled, 1e3 * row.settledCpu);
    table += line;
  }
  return table;
}

Json jsonOf(const std::vector<SettleRow>& rows) {
  Json list = Json::array();
  for (const SettleRow& row : rows) {
    Json item = Json::object();
    item.set("scene", row.scene).set("threads", row.threads).set("vertices", row.vertices);
    item.set("muscles", row.muscles).set("drag_seconds", row.drag).set("drag_seconds_worst", row.worstDrag);
    item.set("drag_prepare_seconds", row.prepare).set("settled_seconds", row.settled);
    item.set("settled_seconds_worst", row.worstSettled).set("settled_cpu_seconds", row.settledCpu);
    list.push(item);
  }
  return list;
}

}  // namespace

Result<Report> reportSettling(Files files, const Effort& effort) {
  const auto rows = rowsOf<SettleRow>(files, [&](const auto& scene) { return measureSettling(scene, effort); });
  if (!rows) return rows.error();
  return Report{tableOf(rows.value()), jsonOf(rows.value())};
}

}  // namespace sinew::app
