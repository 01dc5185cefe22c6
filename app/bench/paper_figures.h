// app/bench/paper_figures.h: the results that the paper prints (its section 5, Tables 1 and 2).
#pragma once

#include <array>

namespace sinew::app {

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

}  // namespace sinew::app
