// app/cli/bench.cpp: opens what is to be measured, and puts the measurements into a table and a file.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/bench/animation.h"
#include "app/bench/drag.h"
#include "app/bench/field.h"
#include "app/bench/projections.h"
#include "app/bench/rig_or_trial.h"
#include "app/bench/stages.h"
#include "app/cli/bench_whole.h"
#include "app/cli/console.h"
#include "app/cli/verb.h"
#include "app/document/document.h"
#include "app/platform/data_files.h"
#include "core/io/files/atomic_file.h"
#include "core/io/json/json.h"

namespace sinew::app {
namespace {

enum class Bench {
  kWhole,        ///< Everything that the project aims at.
  kProjections,  ///< The three ways to find roots, on the same frames.
  kAnimation,    ///< Lines and drivers beside skinning.
  kField,        ///< The field of ellipsoids, spheres and shapes.
  kDrag,         ///< Frames of a drag, by length of the history and number of muscles.
  kStages,       ///< The stages' shares of a frame.
};

struct BenchOptions {
  Bench bench = Bench::kWhole;
  std::vector<std::filesystem::path> files;   ///< Rigs or characters; none: those that ship with the program.
  std::optional<std::filesystem::path> json;  ///< Empty, of the whole alone: on stdout.
  int frames = 0;                             ///< Moments of the clip or of the drag; 0: as many as the bench takes.
  int rounds = 0;                             ///< Each frame is timed once a round; 0: as many as the bench takes.
};

constexpr const char* kColumns =
    "scene, mode, projection   what was smoothed, and how roots were found\n"
    "vertices                  refined vertices for which a root was sought, mean of the frames\n"
    "field, quartic            evaluations per such vertex: of the field along its ray, of quartics made from it\n"
    "frame, project            milliseconds, median: a whole frame (skin, patch, project), the projection alone\n"
    "x newton                  the same over newton's for the same frame in the same round, median\n"
    "differs, far              largest distance from newton's vertices in H; share of the vertices beyond 1e-4 H\n"
    "lost, fallback            vertices without a root; anchors outside, replaced by the normal; mean of the frames\n"
    "In replace, analytic follows the normal and the other two the segment to the anchor: it differs by definition.\n";

/// @param bundled  of assets, where no file was given.
std::vector<std::filesystem::path> filesOf(const BenchOptions& options, std::initializer_list<const char*> bundled) {
  if (!options.files.empty()) return options.files;
  std::vector<std::filesystem::path> files;
  for (const char* name : bundled) files.push_back(dataFile(std::string("assets/") + name));
  return files;
}

std::string tableOf(const std::vector<ProjectionRow>& rows) {
  std::size_t widest = 5;
  for (const ProjectionRow& row : rows) widest = std::max(widest, row.scene.size());
  const int width = static_cast<int>(std::min<std::size_t>(widest, 40));
  char line[320];
  std::snprintf(line, sizeof line, "%-*s  %-7s  %-10s  %8s  %6s  %7s  %9s  %8s  %10s  %8s  %9s  %6s  %6s  %8s\n", width,
                "scene", "mode", "projection", "vertices", "field", "quartic", "frame ms", "x newton", "project ms",
                "x newton", "differs H", "far %", "lost", "fallback");
  std::string table = std::string(kColumns) + '\n' + line;
  for (const ProjectionRow& row : rows) {
    std::snprintf(
        line, sizeof line,
        "%-*.40s  %-7s  %-10s  %8.0f  %6.2f  %7.2f  %9.3f  %8.2f  %10.3f  %8.2f  %9.2g  %6.2f  %6.1f  %8.1f\n", width,
        row.scene.c_str(), nameOf(row.mode), nameOf(row.projection), row.projected, row.fieldPerVertex,
        row.quarticPerVertex, 1e3 * row.frameSeconds, row.frameRatio, 1e3 * row.projectSeconds, row.projectRatio,
        row.differenceMax, 100.0 * row.differenceShare, row.unresolved, row.anchorFallbacks);
    table += line;
  }
  return table;
}

Json jsonOf(const std::vector<ProjectionRow>& rows) {
  Json list = Json::array();
  for (const ProjectionRow& row : rows) {
    Json item = Json::object();
    item.set("scene", row.scene).set("mode", nameOf(row.mode)).set("projection", nameOf(row.projection));
    item.set("vertices", row.projected);
    item.set("field_per_vertex", row.fieldPerVertex).set("quartic_per_vertex", row.quarticPerVertex);
    item.set("frame_seconds", row.frameSeconds).set("frame_ratio", row.frameRatio);
    item.set("project_seconds", row.projectSeconds).set("project_ratio", row.projectRatio);
    item.set("difference_max", row.differenceMax).set("difference_share", row.differenceShare);
    item.set("unresolved", row.unresolved).set("anchor_fallbacks", row.anchorFallbacks);
    list.push(item);
  }
  return list;
}

Json jsonOf(const std::vector<DragRow>& rows) {
  Json list = Json::array();
  for (const DragRow& row : rows) {
    Json item = Json::object();
    item.set("scene", row.scene).set("undo_steps", row.undoSteps).set("untouched", row.untouched);
    item.set("vertices", row.projected).set("frame_seconds", row.frameSeconds);
    item.set("prepare_seconds", row.prepareSeconds).set("frame_ratio", row.frameRatio);
    list.push(item);
  }
  return list;
}

Json jsonOf(const std::vector<StageRow>& rows) {
  Json list = Json::array();
  for (const StageRow& row : rows) {
    Json shares = Json::object();
    shares.set("skin", row.shares.skin).set("patch", row.shares.patch).set("project", row.shares.project);
    shares.set("folds", row.shares.folds).set("normals", row.shares.normals);
    Json item = Json::object();
    item.set("scene", row.scene).set("depth", row.depth).set("vertices", row.projected);
    item.set("frame_seconds", row.frameSeconds).set("shares", shares);
    list.push(item);
  }
  return list;
}

/// How much is measured: what was asked for, else what the bench takes.
struct Effort {
  int frames = 0;
  int rounds = 0;
};

Effort effortOf(const BenchOptions& options, const Effort& usual) {
  return {options.frames > 0 ? options.frames : usual.frames, options.rounds > 0 ? options.rounds : usual.rounds};
}

/// Opens and measures file after file, then puts table and JSON. @param measure (file, document) -> Result of rows.
template <class Row, class Measure>
int benchFiles(const BenchOptions& options, const Effort& effort, const char* name,
               const std::vector<std::filesystem::path>& files, const Measure& measure) {
  std::vector<Row> rows;
  for (const std::filesystem::path& file : files) {
    progress("reading " + file.string());
    const auto document = openDocument(file);
    if (!document) return badInput(document.error());
    const Result<std::vector<Row>> measured = measure(file, document.value());
    if (!measured) return badInput({file.string(), measured.error().place, measured.error().reason});
    rows.insert(rows.end(), measured->begin(), measured->end());
  }
  if (options.json) {
    Json json = Json::object();
    json.set("bench", name).set("frames", effort.frames).set("rounds", effort.rounds).set("rows", jsonOf(rows));
    const auto written = writeFileAtomically(*options.json, json.dump(true) + '\n');
    if (!written) return badInput(written.error());
  }
  return putResult(tableOf(rows));
}

int benchProjections(const BenchOptions& options) {
  const Effort effort = effortOf(options, {8, 15});
  const auto measure = [&](const std::filesystem::path& file, const Document& document) {
    const auto tell = [](const std::string& what) { progress("measuring " + what); };
    return measureProjections({sceneName(file), document.character, rigOrTrial(document), effort.frames, effort.rounds},
                              tell);
  };
  const auto files = filesOf(options, {"wrapped.rig.json", "tangle.rig.json", "demo.rig.json"});
  return benchFiles<ProjectionRow>(options, effort, "projections", files, measure);
}

int benchDrag(const BenchOptions& options) {
  const Effort effort = effortOf(options, {60, 5});
  const auto measure = [&](const std::filesystem::path& file, const Document& document) {
    return measureDrag({sceneName(file), document.character, effort.frames, effort.rounds});
  };
  return benchFiles<DragRow>(options, effort, "drag", filesOf(options, {"humanoid.glb"}), measure);
}

int benchAnimation(const BenchOptions& options) {
  const std::filesystem::path file = filesOf(options, {"humanoid.glb"}).front();
  const auto document = openDocument(file);
  if (!document) return badInput(document.error());
  const Character& character = *document->character;
  const bool jointed = std::ranges::any_of(character.skeleton.bones, [](const Bone& bone) { return bone.parent >= 0; });
  if (!jointed) return badInput({file.string(), "", "this character has no joint: there is nothing to span or drive"});
  return putResult(animationTable(measureAnimation(character, effortOf(options, {0, 60}).rounds)));
}

int benchStages(const BenchOptions& options) {
  const Effort effort = effortOf(options, {8, 15});
  const auto measure = [&](const std::filesystem::path& file, const Document& document) {
    return measureStages({sceneName(file), document.character, rigOrTrial(document), effort.frames, effort.rounds});
  };
  const auto files = filesOf(options, {"humanoid.rig.json", "horse.rig.json", "demo.rig.json"});
  return benchFiles<StageRow>(options, effort, "stages", files, measure);
}

void addNumber(CLI::App& bench, const char* name, int& number, const char* help) {
  bench.add_option(name, number, help)->type_name("N")->check(CLI::Range(1, 1000));
}

void addInputs(CLI::App& bench, BenchOptions& options, const char* help) {
  bench.add_option_function<std::vector<std::string>>(
      "FILE", [&options](const std::vector<std::string>& files) { options.files.assign(files.begin(), files.end()); },
      help);
}

void addFiles(CLI::App& bench, BenchOptions& options, const char* help) {
  addInputs(bench, options, help);
  bench
      .add_option_function<std::string>(
          "--json", [&options](const std::string& file) { options.json = file; }, "Write the numbers as JSON too")
      ->type_name("FILE.json");
}

/// `--json` may stand alone here: the numbers go to stdout, as other verbs' do.
void addWhole(CLI::App& verb, BenchOptions& options) {
  verb.require_subcommand(0, 1);
  addInputs(
      verb, options,
      "Rigs (.rig.json), or characters, which get 12 muscles by rule; none: humanoid and horse, made for each mode");
  verb.add_option_function<std::vector<std::string>>(
          "--json",
          [&options](const std::vector<std::string>& files) { options.json = files.empty() ? "" : files.front(); },
          "Print JSON, for programs; or write it to FILE.json beside the table")
      ->type_name("FILE.json")
      ->expected(0, 1);
  addNumber(verb, "--rounds", options.rounds, "Times everything is timed (7)");
}

void addBenchOptions(CLI::App& verb, BenchOptions& options) {
  addWhole(verb, options);
  CLI::App* field =
      verb.add_subcommand("field", "Compare ellipsoids with spheres and shapes: one evaluation of the field");
  field->callback([&options] { options.bench = Bench::kField; });
  addNumber(*field, "--rounds", options.rounds, "Times everything is timed (15)");

  CLI::App* animation = verb.add_subcommand("animation", "Time 4,000 muscle lines and 1,000 drivers beside skinning");
  animation->callback([&options] { options.bench = Bench::kAnimation; });
  animation->add_option_function<std::string>(
      "FILE", [&options](const std::string& file) { options.files = {file}; },
      "A character; none: the humanoid that ships with the program");
  addNumber(*animation, "--rounds", options.rounds, "Poses (60)");

  CLI::App* projections =
      verb.add_subcommand("projections", "Compare newton, bisection and analytic: work, time, agreement");
  projections->callback([&options] { options.bench = Bench::kProjections; });
  addFiles(
      *projections, options,
      "Rigs (.rig.json), or characters, which get 12 muscles by rule; none: the scenes that ship with the program");
  addNumber(*projections, "--frames", options.frames, "Moments of the first clip (8)");
  addNumber(*projections, "--rounds", options.rounds, "Times each moment is timed (15)");

  CLI::App* drag = verb.add_subcommand("drag", "Time a drag: short and long history, few and many muscles");
  drag->callback([&options] { options.bench = Bench::kDrag; });
  addFiles(*drag, options, "Characters, which get muscles by rule; none: the humanoid that ships with the program");
  addNumber(*drag, "--frames", options.frames, "Frames of a drag (60)");
  addNumber(*drag, "--rounds", options.rounds, "Drags (5)");

  CLI::App* stages = verb.add_subcommand("stages", "Divide a frame's time among skin, patch, project, folds, normals");
  stages->callback([&options] { options.bench = Bench::kStages; });
  addFiles(*stages, options,
           "Rigs (.rig.json), or characters, which get 12 muscles by rule; none: those that ship with the program");
  addNumber(*stages, "--frames", options.frames, "Moments of the first clip (8)");
  addNumber(*stages, "--rounds", options.rounds, "Times each moment is timed (15)");
  // The whole's options belong to no part: those have their own behind their names.
  for (CLI::App* part : verb.get_subcommands([](const CLI::App*) { return true; })) {
    for (CLI::Option* option : verb.get_options()) part->excludes(option);
  }
}

int runBench(const BenchOptions& options) {
  switch (options.bench) {
    case Bench::kWhole:
      return benchWhole({options.files, options.json, options.rounds});
    case Bench::kField:
      return putResult(fieldTable(measureField(effortOf(options, {0, 15}).rounds)));
    case Bench::kAnimation:
      return benchAnimation(options);
    case Bench::kDrag:
      return benchDrag(options);
    case Bench::kStages:
      return benchStages(options);
    case Bench::kProjections:
      break;
  }
  return benchProjections(options);
}

}  // namespace

Verb benchVerb() { return makeVerb<BenchOptions>("bench", "Measure on this machine", addBenchOptions, runBench); }

}  // namespace sinew::app
