// app/bench/paper_tables.h: the two tables of the paper's results, measured here, beside what the paper says.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/bench/scene.h"

namespace sinew::app {

/// Smoothing alone; the paper's frames are drawn too, on a Pentium III at 733 MHz with a GeForce 1.
struct Table1Row {
  std::string scene;
  SurfaceMode mode = SurfaceMode::kSwell;
  int depth = 2;
  ProjectionKind projection = ProjectionKind::kNewton;
  bool culling = false;
  double frameSeconds = 0.0;       ///< Median.
  double fps = 0.0;                ///< 1 / frameSeconds.
  std::optional<double> paperFps;  ///< Of the paper's humanoid, where the mesh has as many triangles; not by newton.
};

/// All projections with and without culling in turn, one depth after the other. Error: the rig is refused.
[[nodiscard]] Result<std::vector<Table1Row>> measureTable1(const BenchScene& scene, int rounds);

/// By newton, back faces culled as in the paper.
struct Table2Row {
  std::string scene;
  SurfaceMode mode = SurfaceMode::kSwell;
  int depth = 2;
  int triangles = 0;  ///< N: refined triangles.
  int vertices = 0;   ///< Refined.
  double frameSeconds = 0.0;
  double fps = 0.0;
  std::optional<double> paperTriangles;  ///< Where the mesh has as many triangles as the paper's humanoid or horse.
  std::optional<double> paperFps;
};

/// Error: the rig is refused.
[[nodiscard]] Result<std::vector<Table2Row>> measureTable2(const BenchScene& scene, int rounds);

}  // namespace sinew::app
