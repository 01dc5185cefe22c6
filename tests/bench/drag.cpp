// tests/bench/drag.cpp: what a frame of a drag costs beside drawing: the same drag in several documents, frame by frame
// in turn.
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <utility>

#include "app/command/measuring.h"
#include "app/document/document.h"
#include "app/document/playback.h"
#include "core/geometry/stopwatch.h"
#include "core/rig/trial_rig.h"
#include "sinew/rig/rig_edit.h"
#include "tests/bench/parts.h"

namespace sinew::app {
namespace {

/// One situation. Seconds are medians of all timed frames.
struct DragRow {
  std::string scene;
  int undoSteps = 0;
  int untouched = 0;            ///< Muscles beside the one that is dragged.
  double frameSeconds = 0.0;    ///< Edit, pose, prepare, smooth.
  double prepareSeconds = 0.0;  ///< The part of it that prepare takes.
  double projected = 0.0;       ///< Vertices a root was sought for, mean of the frames.
  double frameRatio = 1.0;      ///< Over the first row's for the same frame in the same round, median.
};

struct Situation {
  int undoSteps;
  int untouched;
};
constexpr std::array kSituations{Situation{5, 10}, Situation{200, 10}, Situation{5, 60}};

constexpr int kDepth = 5;
constexpr int kDragged = 0;  ///< Rig index.
constexpr std::uint64_t kSeed = 1;
constexpr double kFrame = 1.0 / 60.0;

/// A document with a history, its surface, and what its frames have cost.
class Drag {
 public:
  static Result<Drag> create(const BenchScene& scene, const Situation& situation) {
    Drag drag(scene.character, situation);
    if (drag.document_.rig().primitives.empty()) return Error{"", scene.name, "no skin to lay muscles in"};
    Result<LiveSurface> live = LiveSurface::create(drag.document_, drag.transport_);
    if (!live) return live.error();
    drag.live_.emplace(std::move(live.value()));
    return drag;
  }

  void begin() { document_.commands.beginGesture("Drag"); }

  /// @param share of a turn that the muscle goes round a circle.  @param timed  else only warms up.
  Result<void> frame(double share, bool timed) {
    Stopwatch watch;
    Result<Rig> rig = setPlacement(document_.rig(), kDragged, placementAt(share));
    if (!rig) return rig.error();
    document_.commands.updateGesture(std::move(rig.value()));
    advance(transport_, kFrame, *document_.character);
    live_->movePose(transport_);
    if (const Result<bool> updated = live_->update(document_); !updated) return updated.error();
    if (timed) {
      frameSeconds_.push_back(watch.lap());
      prepareSeconds_.push_back(live_->prepareSeconds());
      projected_ += live_->surface().report.projected;
    }
    return {};
  }

  /// The drag leaves no step: the next one finds the same history.
  void end() { document_.commands.cancelGesture(); }

  [[nodiscard]] DragRow row(const std::string& scene, const Drag& usual) const {
    DragRow row;
    row.scene = scene;
    row.undoSteps = static_cast<int>(document_.commands.stepCount());
    row.untouched = static_cast<int>(document_.rig().primitives.size()) - 1;
    row.frameSeconds = median(frameSeconds_);
    row.prepareSeconds = median(prepareSeconds_);
    row.projected = projected_ / static_cast<double>(frameSeconds_.size());
    row.frameRatio = medianRatio(frameSeconds_, usual.frameSeconds_);
    return row;
  }

 private:
  Drag(std::shared_ptr<const Character> character, const Situation& situation) {
    document_.character = std::move(character);
    Rig rig = trialRig(*document_.character, situation.untouched + 1, kSeed);
    rig.smoothing.detail = DetailKind::kUniform;
    rig.smoothing.depth = kDepth;
    document_.commands = CommandStack(rig);
    prepareMirror(document_);
    if (rig.primitives.empty()) return;
    start_ = rig.primitives[kDragged].placement;
    for (int step = 1; step <= situation.undoSteps; ++step) {
      const bool isLast = step == situation.undoSteps;  // All situations end with the same muscle.
      rig.primitives[kDragged].reach = isLast ? kDefaultReach : step % 2 == 0 ? 1.5f : 1.6f;
      document_.commands.apply("Reach", rig);
    }
    if (document_.character->clips.empty()) return;
    chooseClip(transport_, 0, *document_.character);
    togglePlaying(transport_, *document_.character);
  }

  [[nodiscard]] Placement placementAt(double share) const {
    const auto angle = static_cast<float>(2.0 * std::numbers::pi * share);
    Placement placement = start_;
    placement.center += 0.3f * start_.radii.x * glm::vec3(std::cos(angle), std::sin(angle), 0.0f);
    return placement;
  }

  Document document_;
  Transport transport_;
  std::optional<LiveSurface> live_;
  Placement start_;
  std::vector<double> frameSeconds_, prepareSeconds_;
  double projected_ = 0.0;
};

/// One muscle is dragged through the command stack and the editor's live surface. Every frame is made in all situations
/// in turn, so that a slow moment of the machine meets them alike. Error: no skin to lay muscles in.
Result<std::vector<DragRow>> measureDrag(const BenchScene& scene, const Effort& effort) {
  std::vector<Drag> drags;
  for (const Situation& situation : kSituations) {
    Result<Drag> drag = Drag::create(scene, situation);
    if (!drag) return drag.error();
    drags.push_back(std::move(drag.value()));
  }
  for (int round = 0; round <= effort.rounds; ++round) {  // Round 0 warms up.
    for (Drag& drag : drags) drag.begin();
    for (int i = 0; i < effort.frames; ++i) {
      const double share = (i + 0.5) / effort.frames;
      for (Drag& drag : drags) {
        if (const Result<void> made = drag.frame(share, round > 0); !made) return made.error();
      }
    }
    for (Drag& drag : drags) drag.end();
  }
  std::vector<DragRow> rows;
  for (const Drag& drag : drags) rows.push_back(drag.row(scene.name, drags.front()));
  return rows;
}

std::string tableOf(const std::vector<DragRow>& rows) {
  std::string table =
      "One muscle is dragged at depth 5 while the first clip plays. Milliseconds of a frame beside drawing (edit, "
      "pose,\n"
      "prepare, smooth) and of prepare alone, medians; the frame over the scene's first row's for the same frame in "
      "the\n"
      "same round, median.\n"
      "\n"
      "scene             undo steps  untouched muscles  frame ms  prepare ms  x first\n";
  char line[160];
  for (const DragRow& row : rows) {
    std::snprintf(line, sizeof line, "%-16.40s  %10d  %17d  %8.3f  %10.3f  %7.2f\n", row.scene.c_str(), row.undoSteps,
                  row.untouched, 1e3 * row.frameSeconds, 1e3 * row.prepareSeconds, row.frameRatio);
    table += line;
  }
  return table;
}

Json jsonOf(const std::vector<DragRow>& rows) {
  Json list = Json::array();
  for (const DragRow& row : rows) {
    Json item = Json::object();
    item.set("scene", row.scene).set("undo_steps", row.undoSteps).set("untouched", row.untouched);
    item.set("vertices", row.projected).set("frame_seconds", row.frameSeconds);
    item.set("prepare_seconds", row.prepareSeconds).set("frame_ratio", row.frameRatio);
    list.push(item);
  }
  return list;
}

}  // namespace

Result<Report> reportDrag(Files files, const Effort& effort) {
  const auto rows = rowsOf<DragRow>(files, [&](const auto& scene) { return measureDrag(scene, effort); });
  if (!rows) return rows.error();
  return Report{tableOf(rows.value()), jsonOf(rows.value())};
}

}  // namespace sinew::app
