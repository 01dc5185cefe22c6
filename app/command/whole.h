// app/command/whole.h: one whole run of `sinew bench`, and the machine it ran on.
#pragma once

#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "app/command/costs.h"
#include "app/command/measuring.h"
#include "app/command/speedup.h"
#include "core/files/json/json.h"

namespace sinew::app {

struct Machine {
  std::string processor;                     ///< Or "unknown".
  std::vector<std::string> instructionSets;  ///< Available ones, narrowest first.
  int threads = 1;                           ///< Available to this process.
  double load = 0.0;                         ///< Mean of the last minute; above `threads`, times are unreliable.
  std::string compiler;
  std::string buildType;  ///< With added flags; "none" without either.
  bool assertions = false;
  std::string version;  ///< The program's.
};

[[nodiscard]] Machine machineHere();

[[nodiscard]] std::string processorName(std::istream& cpuinfo);  ///< First "model name" of /proc/cpuinfo, or "unknown".

[[nodiscard]] Json jsonOf(const Machine& machine);
[[nodiscard]] std::string textOf(const Machine& machine);  ///< A few lines.

/// Figures of one surface mode on its first scene.
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

using ModeScenes = std::vector<BenchScene>;  ///< Scenes of one mode, at least one.

/// Error: a rig is refused, or there is no skin for muscles.
/// @param rounds  1 or more: how often everything is timed  @param show  how many of all parts are done
[[nodiscard]] Result<Whole> measureWhole(const std::vector<ModeScenes>& modes, int rounds,
                                         const std::function<void(int done, int all)>& show);

/// Each mode's figures under "swell" and "replace"; "machine", "rounds", "table1", "table2": docs/formats.md.
[[nodiscard]] Json jsonOf(const Whole& whole);

[[nodiscard]] std::string textOf(const Whole& whole);  ///< For people.

}  // namespace sinew::app
