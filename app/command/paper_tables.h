// app/command/paper_tables.h: the two tables of the paper's results, measured here, beside what the paper says.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/command/scene.h"

namespace sinew::app {

// What the paper prints (its section 5, Tables 1 and 2).

/// Frames a second of the humanoid at one depth.
struct PaperRates {
  int depth;
  double analytic, analyticCulled, bisection, bisectionCulled;
};
inline constexpr std::array kPaperTable1{PaperRates{2, 104, 123, 141, 165}, PaperRates{3, 54, 67, 76, 92},
                                         PaperRates{4, 33, 43, 47, 59},     PaperRates{5, 22, 30, 31, 40},
                                         PaperRates{6, 15, 21, 22, 29},     PaperRates{7, 11, 16, 17, 22}};

/// Refined triangles and frames a second, by binary search with face culling.
struct PaperSizes {
  int depth;
  double humanoidTriangles, humanoidFps, horseTriangles, horseFps;
};
inline constexpr std::array kPaperTable2{PaperSizes{2, 2368, 165, 1648, 197}, PaperSizes{3, 5328, 92, 3708, 133},
                                         PaperSizes{4, 9472, 59, 6592, 86}, PaperSizes{5, 14800, 40, 10300, 60}};

/// Smoothing alone; the paper's frames are drawn too, on a Pentium III at 733 MHz with a GeForce 1.
struct Table1Row {
  std::string scene;
  SurfaceMode mode = SurfaceMode::kSwell;
  int depth = 2;
  ProjectionKind projection = ProjectionKind::kNewton;
  bool culling = false;
  double frameSeconds = 0.0;       ///< Median.
  double fps = 0.0;                ///< 1 / frameSeconds.
  std::optional<double> paperFps;  ///< The paper's humanoid's, where the mesh has as many triangles; not by newton.
};

/// All projections by the scalar reference, with and without culling in turn, one depth after the other. Error: the rig
/// is refused.
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
