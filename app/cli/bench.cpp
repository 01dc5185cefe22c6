// app/cli/bench.cpp: opens what is to be measured, and puts the measurements into a table and a file.
#include "app/cli/bench.h"

#include <algorithm>
#include <cstdio>

#include <CLI/CLI.hpp>

#include "app/cli/bench_field.h"
#include "app/cli/bench_projections.h"
#include "app/cli/console.h"
#include "app/cli/trial_rig.h"
#include "app/document/document.h"
#include "app/platform/data_files.h"
#include "core/io/files/atomic_file.h"
#include "core/io/json/json.h"

namespace sinew::app {
namespace {

constexpr int kTrialMuscles = 12;
constexpr std::uint64_t kTrialSeed = 1;

constexpr const char* kColumns =
    "scene, mode, projection   what was smoothed, and how roots were found\n"
    "vertices                  refined vertices for which a root was sought, mean of the frames\n"
    "field, quartic            evaluations per such vertex: of the field along its ray, of quartics made from it\n"
    "frame, project            milliseconds, median: a whole frame (skin, patch, project), the projection alone\n"
    "x newton                  the same over newton's for the same frame in the same round, median\n"
    "differs, far              largest distance from newton's vertices in H; share of the vertices beyond 1e-4 H\n"
    "lost, fallback            vertices without a root; anchors outside, replaced by the normal; mean of the frames\n"
    "In replace, analytic follows the normal and the other two the segment to the anchor: it differs by definition.\n";

std::vector<std::filesystem::path> filesOf(const BenchOptions& options) {
  if (!options.files.empty()) return options.files;
  std::vector<std::filesystem::path> files;
  for (const char* name : {"wrapped", "tangle", "demo"}) {
    files.push_back(dataFile(std::string("assets/") + name + ".rig.json"));
  }
  return files;
}

/// "fox" of both fox.glb and fox.rig.json.
std::string sceneName(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return name.substr(0, name.find('.', 1));
}

Result<ProjectionTrial> trialOf(const std::filesystem::path& file, const BenchOptions& options) {
  const auto document = openDocument(file);
  if (!document) return document.error();
  Rig rig = document->rig();
  if (rig.primitives.empty()) rig = trialRig(*document->character, kTrialMuscles, kTrialSeed);
  return ProjectionTrial{sceneName(file), document->character, std::move(rig), options.frames, options.rounds};
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

std::string jsonOf(const std::vector<ProjectionRow>& rows, const BenchOptions& options) {
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
  Json json = Json::object();
  json.set("bench", "projections").set("frames", options.frames).set("rounds", options.rounds).set("rows", list);
  return json.dump(true) + '\n';
}

}  // namespace

void addBenchOptions(CLI::App& verb, BenchOptions& options) {
  verb.require_subcommand(1);
  CLI::App* field = verb.add_subcommand("field", "Compare spheres with ellipsoids: one evaluation of the field");
  field->callback([&options] { options.field = true; });
  field->add_option("--rounds", options.rounds, "Times everything is timed (15)")
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  CLI::App* projections =
      verb.add_subcommand("projections", "Compare newton, bisection and analytic: work, time, agreement");
  projections->add_option_function<std::vector<std::string>>(
      "FILE", [&options](const std::vector<std::string>& files) { options.files.assign(files.begin(), files.end()); },
      "Rigs (.rig.json), or characters, which get 12 muscles by rule; none: the scenes that ship with the program");
  projections
      ->add_option_function<std::string>(
          "--json", [&options](const std::string& file) { options.json = file; }, "Write the numbers as JSON too")
      ->type_name("FILE.json");
  projections->add_option("--frames", options.frames, "Moments of the first clip (8)")
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  projections->add_option("--rounds", options.rounds, "Times each moment is timed (15)")
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
}

int runBench(const BenchOptions& options) {
  if (options.field) return putResult(fieldTable(measureField(options.rounds)));
  std::vector<ProjectionRow> rows;
  for (const std::filesystem::path& file : filesOf(options)) {
    progress("reading " + file.string());
    const auto trial = trialOf(file, options);
    if (!trial) return badInput(trial.error());
    const auto tell = [](const std::string& what) { progress("measuring " + what); };
    const auto measured = measureProjections(trial.value(), tell);
    if (!measured) return badInput({file.string(), measured.error().place, measured.error().reason});
    rows.insert(rows.end(), measured.value().begin(), measured.value().end());
  }
  if (!options.json.empty()) {
    const auto written = writeFileAtomically(options.json, jsonOf(rows, options));
    if (!written) return badInput(written.error());
  }
  return putResult(tableOf(rows));
}

}  // namespace sinew::app
