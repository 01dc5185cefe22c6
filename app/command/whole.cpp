// app/command/whole.cpp: the machine, the measurements in order, and their JSON and text.
#include "app/command/whole.h"

#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <utility>

#include <sched.h>

#include "app/ui/data_files.h"
#include "core/geometry/instruction_set.h"
#include "sinew/geometry/threads.h"

namespace sinew::app {

// The machine and the build.

namespace {

int usableThreads() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return ::sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

std::string compilerName() {
#ifdef __clang__
  return __VERSION__;  // Begins with its name.
#else
  return std::string("GCC ") + __VERSION__;
#endif
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace

std::string processorName(std::istream& cpuinfo) {
  for (std::string line; std::getline(cpuinfo, line);) {
    const std::size_t colon = line.find(':');
    if (!line.starts_with("model name") || colon == std::string::npos) continue;
    if (std::string name = trimmed(line.substr(colon + 1)); !name.empty()) return name;
  }
  return "unknown";
}

Machine machineHere() {
  Machine machine;
  std::ifstream cpuinfo("/proc/cpuinfo");
  machine.processor = processorName(cpuinfo);
  for (const InstructionSet set : availableInstructionSets()) machine.instructionSets.emplace_back(nameOf(set));
  machine.threads = usableThreads();
  if (::getloadavg(&machine.load, 1) < 1) machine.load = 0.0;
  machine.compiler = compilerName();
  const std::string build = trimmed(SINEW_BUILD_TYPE);
  machine.buildType = build.empty() ? "none" : build;
#ifndef NDEBUG
  machine.assertions = true;
#endif
  machine.version = programVersion();
  return machine;
}

Json jsonOf(const Machine& machine) {
  Json json = Json::object();
  json.set("processor", machine.processor)
      .set("instruction_sets", jsonList(machine.instructionSets))
      .set("threads", machine.threads);
  json.set("load", machine.load);
  json.set("compiler", machine.compiler).set("build_type", machine.buildType).set("assertions", machine.assertions);
  json.set("version", machine.version);
  return json;
}

std::string textOf(const Machine& machine) {
  char load[32];
  std::snprintf(load, sizeof load, "%.1f", machine.load);
  std::string sets;
  for (const std::string& set : machine.instructionSets) sets += (sets.empty() ? "" : " ") + set;
  return "sinew " + machine.version + ", built with " + machine.compiler + ", build type " + machine.buildType +
         (machine.assertions ? ", assertions on\n" : "\n") + machine.processor + ", " +
         std::to_string(machine.threads) + (machine.threads == 1 ? " thread" : " threads") + ", load " + load +
         ", sets: " + sets + '\n';
}

// The run, part by part.

namespace {

using Parts = std::vector<std::function<Result<void>()>>;

/// Stores what was measured.
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

/// @param figures, whole  keep their addresses while the parts run
void addMode(const ModeScenes& scenes, int rounds, ModeFigures& figures, Whole& whole, Parts& parts) {
  const BenchScene& scene = scenes.front();
  figures.mode = scene.rig.surface.mode;
  figures.scene = scene.name;
  parts.push_back([&, rounds] { return keep(measureSpeedups(scene, rounds), figures.speedups); });
  parts.push_back([&, rounds] { return keep(measureMuscleCost(scene, rounds), figures.cost); });
  parts.push_back([&, rounds] { return keep(exponentOfVertices(scene, rounds), figures.exponentVertices); });
  parts.push_back([&, rounds] { return keep(exponentOfPrimitives(scene, rounds), figures.exponentPrimitives); });
  parts.push_back([&, rounds] { return keep(measureThreads(scene, rounds), figures.threads); });
  parts.push_back([&, rounds] { return append(measureTable1(scene, rounds), whole.table1); });
  for (const BenchScene& each : scenes) {
    parts.push_back([&, rounds] { return append(measureTable2(each, rounds), whole.table2); });
  }
  parts.push_back([&, rounds]() -> Result<void> {
    const Result<DrawCost> drawing = measureDrawing(scene, rounds);
    if (drawing) figures.drawing = drawing.value();
    return {};  // Other parts have prepared the rig: what fails here is the context.
  });
}

}  // namespace

Result<Whole> measureWhole(const std::vector<ModeScenes>& modes, int rounds,
                           const std::function<void(int done, int all)>& show) {
  const ThreadLimit one(1);  // measureThreads() has its own.
  Whole whole;
  whole.machine = machineHere();
  whole.rounds = rounds;
  whole.modes.resize(modes.size());
  Parts parts;
  for (std::size_t m = 0; m < modes.size(); ++m) addMode(modes[m], rounds, whole.modes[m], whole, parts);
  int done = 0;
  for (const auto& measure : parts) {
    show(done++, static_cast<int>(parts.size()));
    if (const Result<void> measured = measure(); !measured) return measured.error();
  }
  return whole;
}

// JSON: docs/formats.md.

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

constexpr auto kRowJson = [](const auto& row) { return jsonOf(row); };

}  // namespace

Json jsonOf(const Whole& whole) {
  Json json = Json::object();
  json.set("machine", jsonOf(whole.machine)).set("rounds", whole.rounds);
  for (const ModeFigures& figures : whole.modes) json.set(nameOf(figures.mode), jsonOf(figures));
  json.set("table1", jsonList(whole.table1, kRowJson)).set("table2", jsonList(whole.table2, kRowJson));
  return json;
}

// Text.

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

/// One line for each scene, mode and depth: rates by projection and culling, with the paper's.
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
    // The paper has no newton.
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
