// app/command/speedup.h: the paper's tables, gains by vectors and a second thread, agreement with scalar code.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/command/measuring.h"

namespace sinew::app {

// Section 5 of the paper, Tables 1 and 2.

/// Frames per second of the humanoid at one depth.
struct PaperRates {
  int depth;
  double analytic, analyticCulled, bisection, bisectionCulled;
};
inline constexpr std::array kPaperTable1{PaperRates{2, 104, 123, 141, 165}, PaperRates{3, 54, 67, 76, 92},
                                         PaperRates{4, 33, 43, 47, 59},     PaperRates{5, 22, 30, 31, 40},
                                         PaperRates{6, 15, 21, 22, 29},     PaperRates{7, 11, 16, 17, 22}};

/// Refined triangles and frames per second, by binary search with face culling.
struct PaperSizes {
  int depth;
  double humanoidTriangles, humanoidFps, horseTriangles, horseFps;
};
inline constexpr std::array kPaperTable2{PaperSizes{2, 2368, 165, 1648, 197}, PaperSizes{3, 5328, 92, 3708, 133},
                                         PaperSizes{4, 9472, 59, 6592, 86}, PaperSizes{5, 14800, 40, 10300, 60}};

/// Smoothing only; the paper's frames include drawing, on a Pentium III at 733 MHz with a GeForce 1.
struct Table1Row {
  std::string scene;
  SurfaceMode mode = SurfaceMode::kSwell;
  int depth = 2;
  ProjectionKind projection = ProjectionKind::kNewton;
  bool culling = false;
  double frameSeconds = 0.0;       ///< Median.
  double fps = 0.0;                ///< 1 / frameSeconds.
  std::optional<double> paperFps;  ///< For a mesh with as many triangles as the paper's humanoid; not for newton.
};

/// All projections by the scalar reference, with and without culling in turn, by depth. Error: the rig is refused.
[[nodiscard]] Result<std::vector<Table1Row>> measureTable1(const BenchScene& scene, int rounds);

/// Newton, back faces culled as in the paper.
struct Table2Row {
  std::string scene;
  SurfaceMode mode = SurfaceMode::kSwell;
  int depth = 2;
  int triangles = 0;  ///< N: refined triangles.
  int vertices = 0;   ///< Refined.
  double frameSeconds = 0.0;
  double fps = 0.0;
  std::optional<double> paperTriangles;  ///< For a mesh with as many triangles as the paper's humanoid or horse.
  std::optional<double> paperFps;
};

/// Error: the rig is refused.
[[nodiscard]] Result<std::vector<Table2Row>> measureTable2(const BenchScene& scene, int rounds);

// Vectors and threads.

/// Scalar reference over optimized, medians over frames of the same moment and round.
struct SetSpeedup {
  double cold = 0.0;      ///< The first frame of a smoother.
  double warm60Hz = 0.0;  ///< A clip at 60 frames per second.
  double warm20Hz = 0.0;  ///< At 20.
  double cut = 0.0;       ///< Moments far from each other.
};

/// One instruction set.
struct SpeedupRow {
  std::string set;
  SetSpeedup frame;       ///< Whole frames.
  SetSpeedup projection;  ///< The projection alone.
};

/// The widest set compared with the scalar reference. Fractions are of the vertices with a root search.
struct Agreement {
  double within = 1.0;            ///< Fraction within 1e-4 H of the reference.
  double uncertifiedShare = 0.0;  ///< Fraction that the vector path left to the scalar one.
  long long notFinite = 0;        ///< Positions and normals that are not finite.
  long long projected = 0;        ///< Vertices counted.
};

struct Speedups {
  std::vector<SpeedupRow> rows;
  Agreement agreement;
};

/// At kBenchDepth, by newton. Every set and the reference smooth the same moments in turn, each with its own smoother.
/// Only the projection of the reference is scalar: the rest of its frame uses vectors. Error: the rig is refused.
[[nodiscard]] Result<Speedups> measureSpeedups(const BenchScene& scene, int rounds);

/// Time on one thread over time on two, medians; 1 on a machine with one core.
struct ThreadGain {
  double single = 1.0;  ///< One surface at kBenchDepth.
  double crowd = 1.0;   ///< A hundred moments at depth 3, smoothed together.
};

[[nodiscard]] Result<ThreadGain> measureThreads(const BenchScene& scene, int rounds);  ///< Error: the rig is refused.

}  // namespace sinew::app
