// app/command/whole.cpp: part after part.
#include "app/command/whole.h"

#include <array>
#include <cstdarg>
#include <cstdio>
#include <utility>

#include "sinew/geometry/threads.h"

namespace sinew::app {
namespace {

/// A part of the run: what it is called, and what measures it.
struct Part {
  std::string name;
  std::function<Result<void>()> measure;
};

/// Puts what was measured into its place.
template <class Value>
Result<void> keep(Result<Value> measured, Value& place) {
  if (!measured) return measured.error();
  place = std::move(measured.value());
  return {};
}

template <class Row>
Result<void> append(Result<std::vector<Row>> measured, std::vector<Row>& rows) {
  if (!measured) return measured.error();
  rows.insert(rows.end(), measured->begin(), measured->end());
  return {};
}

/// @param figures  stays where it is while the parts run.
void addMode(const ModeScenes& scenes, int rounds, ModeFigures& figures, Whole& whole, std::vector<Part>& parts) {
  const BenchScene& scene = scenes.front();
  figures.mode = scene.rig.surface.mode;
  figures.scene = scene.name;
  const std::string where = std::string(", ") + scene.name + ", " + nameOf(figures.mode);
  parts.push_back({"speedup" + where, [&, rounds] { return keep(measureSpeedups(scene, rounds), figures.speedups); }});
  parts.push_back(
      {"cost of muscles" + where, [&, rounds] { return keep(measureMuscleCost(scene, rounds), figures.cost); }});
  parts.push_back({"growth with vertices" + where,
                   [&, rounds] { return keep(exponentOfVertices(scene, rounds), figures.exponentVertices); }});
  parts.push_back({"growth with muscles" + where,
                   [&, rounds] { return keep(exponentOfPrimitives(scene, rounds), figures.exponentPrimitives); }});
  parts.push_back({"threads" + where, [&, rounds] { return keep(measureThreads(scene, rounds), figures.threads); }});
  parts.push_back({"table 1" + where, [&, rounds] { return append(measureTable1(scene, rounds), whole.table1); }});
  for (const BenchScene& each : scenes) {
    parts.push_back({"table 2, " + each.name + ", " + nameOf(figures.mode),
                     [&, rounds] { return append(measureTable2(each, rounds), whole.table2); }});
  }
  parts.push_back({"drawing" + where, [&, rounds]() -> Result<void> {
                     const Result<DrawCost> drawing = measureDrawing(scene, rounds);
                     if (drawing) figures.drawing = drawing.value();
                     return {};  // The rig was taken before: there is no context.
                   }});
}

}  // namespace

Result<Whole> measureWhole(const std::vector<ModeScenes>& modes, int rounds, const TellProgress& tell) {
  const ThreadLimit one(1);  // measureThreads() has its own.
  Whole whole;
  whole.machine = machineHere();
  whole.rounds = rounds;
  whole.modes.resize(modes.size());
  std::vector<Part> parts;
  for (std::size_t m = 0; m < modes.size(); ++m) addMode(modes[m], rounds, whole.modes[m], whole, parts);
  int done = 0;
  for (const Part& part : parts) {
    tell(done++, static_cast<int>(parts.size()), part.name);
    if (const Result<void> measured = part.measure(); !measured) return measured.error();
  }
  return whole;
}

// A run of `sinew bench` for programs. docs/formats.md.

namespace {

Json orNull(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json jsonOf(const SetSpeedup& speedup) {
  Json json = Json::object();
  json.set("cold", speedup.cold).set("warm_60hz", speedup.warm60Hz).set("warm_20hz", speedup.warm20Hz);
  json.set("cut", speedup.cut);
  return json;
}

Json jsonOf(const std::vector<SpeedupRow>& rows, SetSpeedup SpeedupRow::*part) {
  Json json = Json::object();
  for (const SpeedupRow& row : rows) json.set(row.set, jsonOf(row.*part));
  return json;
}

Json jsonOf(const ModeFigures& figures) {
  const Speedups& speedups = figures.speedups;
  Json json = Json::object();
  json.set("scene", figures.scene).set("depth", kBenchDepth).set("frame_seconds", figures.cost.frameSeconds);
  json.set("reference_over_optimised", jsonOf(speedups.rows, &SpeedupRow::frame));
  json.set("reference_over_optimised_projection", jsonOf(speedups.rows, &SpeedupRow::projection));
  json.set("with_over_without", figures.cost.withOverWithout);
  json.set("ns_per_projected_vertex", figures.cost.nsPerProjectedVertex);
  json.set("ns_per_vertex_floor", figures.cost.nsPerVertexFloor);
  json.set("exponent_vertices", figures.exponentVertices).set("exponent_primitives", figures.exponentPrimitives);
  json.set("threads2_single", figures.threads.single).set("threads2_crowd", figures.threads.crowd);
  json.set("within_1e-4H", speedups.agreement.within).set("nan", speedups.agreement.notFinite);
  json.set("uncertified_share", speedups.agreement.uncertifiedShare);
  json.set("draw_seconds", figures.drawing ? Json(figures.drawing->drawSeconds) : Json());
  json.set("upload_seconds", figures.drawing ? Json(figures.drawing->uploadSeconds) : Json());
  return json;
}

Json jsonOf(const Table1Row& row) {
  Json json = Json::object();
  json.set("mode", nameOf(row.mode)).set("scene", row.scene).set("depth", row.depth);
  json.set("projection", nameOf(row.projection)).set("culling", row.culling);
  json.set("frame_seconds", row.frameSeconds).set("fps", row.fps).set("paper_fps", orNull(row.paperFps));
  return json;
}

Json jsonOf(const Table2Row& row) {
  Json json = Json::object();
  json.set("mode", nameOf(row.mode)).set("scene", row.scene).set("depth", row.depth);
  json.set("n", row.triangles).set("vertices", row.vertices);
  json.set("frame_seconds", row.frameSeconds).set("fps", row.fps);
  json.set("paper_n", orNull(row.paperTriangles)).set("paper_fps", orNull(row.paperFps));
  return json;
}

template <class Row>
Json listOf(const std::vector<Row>& rows) {
  Json list = Json::array();
  for (const Row& row : rows) list.push(jsonOf(row));
  return list;
}

}  // namespace

Json jsonOf(const Whole& whole) {
  Json json = Json::object();
  json.set("machine", jsonOf(whole.machine)).set("rounds", whole.rounds);
  for (const ModeFigures& figures : whole.modes) json.set(nameOf(figures.mode), jsonOf(figures));
  json.set("table1", listOf(whole.table1)).set("table2", listOf(whole.table2));
  return json;
}

// A run of `sinew bench` for people.

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
