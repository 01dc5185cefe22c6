// app/cli/verbs.cpp: the table of verbs, the parse and its refusals.
#include "app/cli/verbs.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/console.h"

namespace sinew::app {
namespace {

constexpr const char* kSummary =
    "Sinew: muscles for animated characters.\n"
    "Adds ellipsoids to the bones of a skinned glTF character and makes one smooth, closed surface of both.";
constexpr const char* kExamples =
    "Without a verb the editor opens: sinew fox.glb, sinew fox.rig.json, or sinew alone for a bundled character.\n"
    "\n"
    "  sinew inspect fox.glb --json\n"
    "  sinew smooth fox.rig.json --clip Walk --time 0.4 --depth 6 -o fox.obj --report fox.json\n"
    "  sinew render fox.rig.json --clip Walk --frames 0:23 -o fox_%04d.png\n"
    "\n"
    "Exit status: 0 done, 1 the input is bad, 2 the command line is wrong. 'sinew VERB --help' lists a verb's options.";

constexpr std::array<std::string_view, 5> kVerbs{"edit", "inspect", "smooth", "render", "bench"};

/// All verbs with what they read. The subcommands refer to the options, so it stays where it is.
struct CommandLine {
  CLI::App app{kSummary, "sinew"};
  EditRequest edit;
  InspectOptions inspect;
  SmoothOptions smooth;
  RenderOptions render;
  BenchOptions bench;
  CLI::App* editVerb = nullptr;
  CLI::App* inspectVerb = nullptr;
  CLI::App* smoothVerb = nullptr;
  CLI::App* renderVerb = nullptr;
  CLI::App* benchVerb = nullptr;

  CommandLine() {
    app.set_version_flag("--version", std::string("sinew ") + programVersion(), "Print the version and exit");
    app.set_help_flag("-h,--help", "Print this and exit");
    app.footer(kExamples);
    app.require_subcommand(1);
    editVerb = app.add_subcommand("edit", "Open the editor");
    editVerb->add_option("FILE", edit.file,
                         "Character (.glb, .gltf) or rig (.rig.json); without it, a bundled character");
    editVerb->add_option("--log-state", edit.logState, "Append a JSON line per drawn frame that changed")
        ->type_name("FILE");
    editVerb->add_option("--scale", edit.scale, "Size of the interface: 1, 1.5, 2; without it, the system's")
        ->check(CLI::Range(0.5, 4.0))
        ->type_name("S");
    inspectVerb = app.add_subcommand("inspect", "Describe a character or a rig, and what is wrong with it");
    addInspectOptions(*inspectVerb, inspect);
    smoothVerb = app.add_subcommand("smooth", "Write the smoothed surface of one moment");
    addSmoothOptions(*smoothVerb, smooth);
    renderVerb = app.add_subcommand("render", "Make pictures, off screen");
    addRenderOptions(*renderVerb, render);
    benchVerb = app.add_subcommand("bench", "Measure on this machine");
    addBenchOptions(*benchVerb, bench);
    for (CLI::App* verb : {editVerb, inspectVerb, smoothVerb, renderVerb, benchVerb}) verb->footer("");
  }
};

/// The arguments after the program's name, "edit" put in front where no verb stands there.
std::vector<std::string> withVerb(int argc, const char* const* argv) {
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  const bool asked =
      !arguments.empty() && (std::ranges::find(kVerbs, arguments[0]) != kVerbs.end() || arguments[0] == "--help" ||
                             arguments[0] == "-h" || arguments[0] == "--version");
  if (!asked) arguments.insert(arguments.begin(), "edit");
  return arguments;
}

/// A lone word that names neither verb nor file: a typo, not a reason to open a window.
bool isUnknownWord(const std::string& word) {
  std::error_code failed;
  return !word.empty() && word.find_first_of("./-") == std::string::npos &&
         std::ranges::find(kVerbs, word) == kVerbs.end() && !std::filesystem::exists(word, failed);
}

/// Help and version go to stdout; all else is a line on stderr.
int answer(const CommandLine& line, const CLI::ParseError& error) {
  if (dynamic_cast<const CLI::CallForHelp*>(&error)) {
    const auto chosen = line.app.get_subcommands();
    return putResult(chosen.empty() ? line.app.help() : chosen.front()->help("sinew"));
  }
  if (dynamic_cast<const CLI::CallForVersion*>(&error)) return putResult(std::string(error.what()) + '\n');
  const auto chosen = line.app.get_subcommands();
  return badCommandLine(std::string(error.what()) + " (see: sinew " +
                        (chosen.empty() ? "" : chosen.front()->get_name() + ' ') + "--help)");
}

}  // namespace

int runCommandLine(int argc, const char* const* argv, const std::function<int(const EditRequest&)>& edit) {
  if (argc > 1 && isUnknownWord(argv[1])) {
    return badCommandLine('"' + std::string(argv[1]) + "\" is neither a verb nor a file (see: sinew --help)");
  }
  CommandLine line;
  std::vector<std::string> arguments = withVerb(argc, argv);
  std::ranges::reverse(arguments);  // The parser takes them from the back.
  try {
    line.app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    return answer(line, error);
  }
  if (line.inspectVerb->parsed()) return runInspect(line.inspect);
  if (line.smoothVerb->parsed()) return runSmooth(line.smooth);
  if (line.renderVerb->parsed()) return runRender(line.render);
  if (line.benchVerb->parsed()) return runBench(line.bench);
  return edit(line.edit);
}

}  // namespace sinew::app
