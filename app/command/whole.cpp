// app/command/whole.cpp: part after part.
#include "app/command/whole.h"

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

}  // namespace sinew::app
