// tests/bench/sinew_bench.cpp: measurements for those who change the code: sinew_bench PART [FILE...] [OPTIONS].
//
// `sinew bench` measures what the project aims at; here are the parts that tell where time goes.
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/command/console.h"
#include "app/ui/data_files.h"
#include "core/files/disk/atomic_file.h"
#include "tests/bench/parts.h"

namespace sinew::app {
namespace {

/// What a part reads and how its numbers are named on the command line.
struct Part {
  const char* name;
  const char* summary;
  const char* file;    ///< Help of FILE; null: reads none.
  const char* frames;  ///< Help of --frames; null: one file at most, and neither --frames nor --json.
  const char* rounds;  ///< Help of --rounds; null: there are none.
  Effort usual;
  Result<Report> (*report)(Files files, const Effort& effort);
  std::vector<const char*> bundled = {};  ///< Where no file is given, these of assets.
};

constexpr const char* kRigs =
    "Rigs (.rig.json), or characters, which get 12 muscles by rule; none: scenes that ship with the program";
constexpr const char* kCharacters = "Characters, which get muscles by rule; none: the humanoid";
constexpr const char* kMoments = "Moments of the first clip (8)";
constexpr const char* kTimings = "Times everything is timed (15)";

const std::vector<Part> kParts = {
    {"field",
     "Compare ellipsoids with spheres and shapes: one evaluation of the field",
     nullptr,
     nullptr,
     kTimings,
     {0, 15},
     reportField},
    {"animation",
     "Time 4,000 muscle lines and 1,000 drivers beside skinning",
     "A character; none: the humanoid",
     nullptr,
     "Poses (60)",
     {0, 60},
     reportAnimation,
     {"humanoid.glb"}},
    {"drag",
     "Time a drag: short and long history, few and many muscles",
     kCharacters,
     "Frames of a drag (60)",
     "Drags (5)",
     {60, 5},
     reportDrag,
     {"humanoid.glb"}},
    {"detail",
     "Compare depth 3 with adaptive detail: vertices, error, time",
     "Rigs (.rig.json), or characters, which get 12 muscles by rule; none: scenes that ship with the program, and "
     "three characters as games have",
     "Moments of each clip at most (4); 1000: thirty a second",
     kTimings,
     {4, 5},
     reportDetail},
    {"settle",
     "Time adaptive detail: a frame of a drag, and the frame in which levels settle",
     kRigs,
     "Muscles that are dragged (8)",
     "Drags of each (3)",
     {8, 3},
     reportSettling,
     {"humanoid.rig.json", "humanoid-flex.rig.json", "horse.rig.json"}},
    {"pops",
     "Count what moves far within a frame, and at once",
     "Rigs (.rig.json), with their muscles, or characters, which get muscles by the tool and at random; none: those "
     "that ship with the program",
     "Frames of each clip at most (1000)",
     "Random rigs (10)",
     {1000, 10},
     reportPops,
     {"humanoid.glb", "horse.glb", "humanoid.rig.json", "horse.rig.json", "humanoid-flex.rig.json"}},
    {"shading",
     "Measure how much of the surface is shaded otherwise than a much finer one",
     kRigs,
     "Moments of each clip (4)",
     nullptr,
     {4, 1},
     reportShading,
     {"humanoid.rig.json", "humanoid-flex.rig.json", "horse.rig.json", "demo.rig.json"}},
    {"stages",
     "Divide a frame's time among skin, patch, project, folds, normals",
     kRigs,
     kMoments,
     kTimings,
     {8, 15},
     reportStages,
     {"humanoid.rig.json", "horse.rig.json", "demo.rig.json"}},
    {"exports",
     "Time every kind of export of a character with many vertices",
     "Rigs (.rig.json), or characters, which get 12 muscles by rule; none: the flexing humanoid",
     "Depth at which the character is split before it gets its muscles (10: 266,000 vertices are exported)",
     "Times each export is timed (1)",
     {10, 1},
     reportExports,
     {"humanoid-flex.rig.json"}},
};

struct Options {
  std::vector<std::filesystem::path> files;
  std::optional<std::filesystem::path> json;
  Effort effort;  ///< 0: as the part's usual one.
};

void addNumber(CLI::App& parser, const char* name, int& number, const char* help) {
  parser.add_option(name, number, help)->type_name("N")->check(CLI::Range(1, 1000));
}

void addPart(CLI::App& app, const Part& part, Options& options) {
  CLI::App& parser = *app.add_subcommand(part.name, part.summary);
  if (part.file != nullptr) {
    CLI::Option* files = parser.add_option_function<std::vector<std::string>>(
        "FILE", [&](const std::vector<std::string>& names) { options.files.assign(names.begin(), names.end()); },
        part.file);
    if (part.frames == nullptr) files->expected(1);
  }
  if (part.frames != nullptr) {
    parser
        .add_option_function<std::string>(
            "--json", [&](const std::string& file) { options.json = file; }, "Write the numbers as JSON too")
        ->type_name("FILE.json");
    addNumber(parser, "--frames", options.effort.frames, part.frames);
  }
  if (part.rounds != nullptr) addNumber(parser, "--rounds", options.effort.rounds, part.rounds);
}

int run(const Part& part, Options options) {
  if (options.files.empty()) {
    for (const char* name : part.bundled) options.files.push_back(dataFile(std::string("assets/") + name));
  }
  const Effort effort{options.effort.frames > 0 ? options.effort.frames : part.usual.frames,
                      options.effort.rounds > 0 ? options.effort.rounds : part.usual.rounds};
  const Result<Report> report = part.report(options.files, effort);
  if (!report) return badInput(report.error());
  if (options.json) {
    Json json = Json::object();
    json.set("bench", part.name).set("frames", effort.frames).set("rounds", effort.rounds).set("rows", report->rows);
    const auto written = writeFileAtomically(*options.json, json.dump(true) + '\n');
    if (!written) return badInput(written.error());
  }
  return putResult(report->table);
}

int runCommandLine(int argc, const char* const* argv) {
  CLI::App app{"Measurements of Sinew's parts on this machine.", "sinew_bench"};
  app.require_subcommand(1);
  Options options;
  for (const Part& part : kParts) addPart(app, part, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    const auto chosen = app.get_subcommands();
    return putResult(chosen.empty() ? app.help() : chosen.front()->help("sinew_bench"));
  } catch (const CLI::ParseError& error) {
    return badCommandLine(std::string(error.what()) + " (see: sinew_bench --help)");
  }
  for (const Part& part : kParts) {
    if (app.got_subcommand(part.name)) return run(part, options);
  }
  return kBadCommandLine;
}

}  // namespace

void progress(const std::string& text) {
  if (::isatty(STDERR_FILENO) == 1) std::fprintf(stderr, "sinew_bench: %s\n", text.c_str());
}
}  // namespace sinew::app

int main(int argc, char** argv) { return sinew::app::runCommandLine(argc, argv); }
