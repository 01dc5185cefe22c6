// app/command/whole.h: all that `sinew bench` measures in one run.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/command/costs.h"
#include "app/command/machine.h"
#include "app/command/paper_tables.h"
#include "app/command/scene.h"
#include "app/command/speedup.h"

namespace sinew::app {

/// One surface mode, on its first scene.
struct ModeFigures {
  SurfaceMode mode = SurfaceMode::kSwell;
  std::string scene;
  Speedups speedups;
  MuscleCost cost;
  double exponentVertices = 0.0;
  double exponentPrimitives = 0.0;
  ThreadGain threads;
  std::optional<DrawCost> drawing;  ///< nullopt: no context to draw in.
};

struct Whole {
  Machine machine;
  int rounds = 0;
  std::vector<ModeFigures> modes;
  std::vector<Table1Row> table1;  ///< Each mode's first scene.
  std::vector<Table2Row> table2;  ///< All scenes.
};

/// The scenes of one mode, one at least.
using ModeScenes = std::vector<BenchScene>;

/// How far a run is: `done` of `all` parts, and what comes now.
using TellProgress = std::function<void(int done, int all, const std::string& now)>;

/// @param rounds  1 or more: how often everything is timed.  Error: a rig is refused, or there is no skin for muscles.
[[nodiscard]] Result<Whole> measureWhole(const std::vector<ModeScenes>& modes, int rounds, const TellProgress& tell);

/// Objects "swell" and "replace" with the figures of each mode, and "machine", "rounds", "table1", "table2":
/// docs/formats.md.
[[nodiscard]] Json jsonOf(const Whole& whole);

/// For people.
[[nodiscard]] std::string textOf(const Whole& whole);

}  // namespace sinew::app
