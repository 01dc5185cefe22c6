// app/command/whole_text.cpp: a run of `sinew bench` for people.
#include <array>
#include <cstdarg>
#include <cstdio>

#include "app/command/whole.h"

namespace sinew::app {
namespace {

[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...) {
  std::array<char, 320> line{};
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(line.data(), line.size(), format, arguments);
  va_end(arguments);
  return line.data();
}

std::string textOf(const SetSpeedup& speedup) {
  return formatted("%8.2f %8.2f %8.2f %8.2f", speedup.cold, speedup.warm60Hz, speedup.warm20Hz, speedup.cut);
}

std::string textOf(const ModeFigures& figures) {
  const MuscleCost& cost = figures.cost;
  const Agreement& agreement = figures.speedups.agreement;
  std::string text = formatted("\n%s: %.40s at depth %d, %.3f ms a frame\n", nameOf(figures.mode),
                               figures.scene.c_str(), kBenchDepth, 1e3 * cost.frameSeconds);
  text += "  scalar / set     frame: cold    60 Hz    20 Hz      cut   projection: cold    60 Hz    20 Hz      cut\n";
  for (const SpeedupRow& row : figures.speedups.rows) {
    text += formatted("  %-19s", row.set.c_str()) + textOf(row.frame) + "          " + textOf(row.projection) + '\n';
  }
  text += formatted("  with muscles / without %28.2f\n", cost.withOverWithout);
  text += formatted("  ns a projected vertex, over the floor %13.1f\n", cost.nsPerProjectedVertex);
  text += formatted("  ns a vertex, floor %32.1f\n", cost.nsPerVertexFloor);
  text += formatted("  exponent of vertices %30.2f\n", figures.exponentVertices);
  text += formatted("  exponent of muscles %31.2f\n", figures.exponentPrimitives);
  text += formatted("  one thread / two, one surface %21.2f\n", figures.threads.single);
  text += formatted("  one thread / two, crowd of 100 %20.2f\n", figures.threads.crowd);
  text += formatted("  within 1e-4 H of scalar %27.3f %%\n", 100.0 * agreement.within);
  text += formatted("  left to scalar as uncertain %23.3f %%\n", 100.0 * agreement.uncertifiedShare);
  text += formatted("  not a number %38lld\n", agreement.notFinite);
  if (!figures.drawing) return text + "  drawing                                       no display\n";
  text += formatted("  ms to draw 1280x800 %31.2f\n", 1e3 * figures.drawing->drawSeconds);
  return text + formatted("  ms to upload %38.2f\n", 1e3 * figures.drawing->uploadSeconds);
}

std::string rateOf(const std::optional<double>& rate) { return rate ? formatted("%.0f", *rate) : "-"; }

/// One line for each scene, mode and depth: the row's rates by projection and culling, each beside the paper's.
std::string textOf(const std::vector<Table1Row>& rows) {
  std::string text =
      "\nTable 1: frames a second, smoothing alone, in brackets the paper's; culled: without back faces\n"
      "All three searches one vertex at a time, in double precision; the program itself uses newton, many at once.\n"
      "mode     scene             depth         analytic          culled       bisection          culled      newton"
      "   culled\n";
  const Table1Row* line = nullptr;
  for (const Table1Row& row : rows) {
    if (!line || row.depth != line->depth || row.mode != line->mode || row.scene != line->scene) {
      text += formatted("%s%-7s  %-16.40s  %5d ", line ? "\n" : "", nameOf(row.mode), row.scene.c_str(), row.depth);
      line = &row;
    }
    // The paper knows no newton: no room for its figure there.
    text += row.projection == ProjectionKind::kNewton
                ? formatted("   %7.0f", row.fps)
                : formatted(" %8.0f %6s", row.fps, ('[' + rateOf(row.paperFps) + ']').c_str());
  }
  return text + '\n';
}

std::string textOf(const std::vector<Table2Row>& rows) {
  std::string text =
      "\nTable 2: refined triangles and frames a second by newton, without back faces\n"
      "mode     scene             depth        N  paper's N       rate  paper's\n";
  for (const Table2Row& row : rows) {
    text += formatted("%-7s  %-16.40s  %5d  %7d  %9s  %9.0f  %7s\n", nameOf(row.mode), row.scene.c_str(), row.depth,
                      row.triangles, rateOf(row.paperTriangles).c_str(), row.fps, rateOf(row.paperFps).c_str());
  }
  return text;
}

}  // namespace

std::string textOf(const Whole& whole) {
  std::string text = textOf(whole.machine);
  text += formatted("Medians of %d round%s, variants in turn within each; ratios within one round.\n", whole.rounds,
                    whole.rounds == 1 ? "" : "s");
  for (const ModeFigures& figures : whole.modes) text += textOf(figures);
  return text + textOf(whole.table1) + textOf(whole.table2);
}

}  // namespace sinew::app
