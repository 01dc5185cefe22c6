// app/command/verbs.cpp: the table of verbs, what they share, the parse and its refusals.
#include "app/command/verbs.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/command/console.h"
#include "core/geometry/nearest_name.h"

namespace sinew::app {
namespace {

Result<void> checkFolders(const BatchInput& input, std::set<std::filesystem::path>& known) {
  for (const std::filesystem::path& output : input.outputs) {
    const std::filesystem::path folder = output.parent_path();
    std::error_code failed;
    if (folder.empty() || known.contains(folder)) continue;
    if (!std::filesystem::is_directory(folder, failed)) {
      return Error{output.string(), "", "cannot be written: there is no such folder"};
    }
    known.insert(folder);
  }
  return {};
}

std::vector<std::string> optionNames(const CLI::App& parser) {
  std::vector<std::string> names;
  for (const CLI::Option* option : parser.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

}  // namespace

Result<FarmCheck> checkForFarm(const std::string& verb, const Batch& batch, const BatchOptions& options,
                               const std::function<Result<InputCheck>(const BatchInput&)>& open) {
  FarmCheck check;
  std::set<std::filesystem::path> folders;
  ProgressLine line("checking", false);
  for (const BatchInput& input : batch.inputs) {
    if (const auto found = checkFolders(input, folders); !found) return found.error();
    const auto opened = open(input);
    if (!opened) return opened.error();
    const auto needs = taskNeeds(verb, opened->character, opened->rig, options.threads, opened->heldFrames);
    if (!needs) return Error{input.file.string(), needs.error().place, needs.error().reason};
    check.needs = larger(check.needs, needs.value());
    check.files += opened->frames.count;
    if (!opened->frames.left.empty()) message(opened->frames.left);
    if (batch.listed)
      line.show(static_cast<double>(&input - batch.inputs.data() + 1) / static_cast<double>(batch.inputs.size()));
  }
  return check;
}

CLI::Option* addPath(CLI::App& verb, const char* name, std::filesystem::path& path, const std::string& help) {
  return verb.add_option_function<std::string>(
      name, [&path](const std::string& text) { path = text; }, help);
}

std::string parseRefusal(const CLI::App& parser, const CLI::ParseError& error) {
  // A required option may be there, misspelled.
  const bool isMissing = dynamic_cast<const CLI::RequiredError*>(&error) && !parser.get_allow_extras();
  if (!isMissing && dynamic_cast<const CLI::ExtrasError*>(&error) == nullptr) return error.what();
  const std::vector<std::string> extras = parser.remaining(true);
  const auto unknown = std::ranges::find_if(extras, [](const std::string& word) { return word.starts_with("--"); });
  if (unknown == extras.end()) return error.what();
  const std::string option = unknown->substr(0, unknown->find('='));
  return "there is no option " + option + didYouMean(option, optionNames(parser));
}

namespace {

constexpr const char* kSummary =
    "Sinew: muscles for animated characters.\n"
    "Adds ellipsoids to the bones of a skinned glTF character and makes one smooth, closed surface of both.";
constexpr const char* kExamples =
    "Without a verb the editor opens: sinew fox.glb, sinew fox.rig.json, or sinew alone for a bundled character.\n"
    "\n"
    "  sinew inspect fox.glb --json\n"
    "  sinew muscle fox.glb -o fox.rig.json\n"
    "  sinew smooth fox.rig.json --clip Walk --time 0.4 --depth 6 -o fox.obj --report fox.json\n"
    "  sinew export fox.rig.json -o fox_muscled.glb\n"
    "  sinew render fox.rig.json --clip Walk --frames 0:23 -o fox_%04d.png\n"
    "  sinew farm render fox.rig.json --clip Walk --frames 0:239 -o fox_%04d.png --tasks 16 --to slurm\n"
    "\n"
    "Exit status: 0 done, 1 the input is bad, 2 the command line is wrong, 3 some inputs of a list failed.\n"
    "'sinew VERB --help' lists a verb's options.";

void addEditOptions(CLI::App& parser, EditRequest& request) {
  parser.add_option("FILE", request.file,
                    "Character (.glb, .gltf, .vrm) or rig (.rig.json); without it, a bundled character");
  parser.add_option("--log-state", request.logState, "Append a JSON line per drawn frame that changed")
      ->type_name("FILE");
  parser.add_option("--scale", request.scale, "Size of the interface: 1, 1.5, 2; without it, the system's")
      ->check(CLI::Range(0.5, 4.0))
      ->type_name("S");
}

/// In the order of the help. The first runs where the command line names none.
std::vector<Verb> allVerbs(const RunEditor& edit) {
  return {
      makeVerb<EditRequest>("edit", "Open the editor", addEditOptions, edit),
      inspectVerb(),
      checkRigVerb(),
      muscleVerb(),
      retargetVerb(),
      fitVerb(),
      smoothVerb(),
      exportVerb(),
      packVerb(),
      renderVerb(),
      farmVerb({smoothVerb(), exportVerb(), renderVerb()}),
      benchVerb(),
  };
}

/// The parser of the whole command line, and what runs each verb.
struct CommandLine {
  CLI::App app{kSummary, "sinew"};
  std::vector<std::pair<CLI::App*, VerbCalls>> runs;

  explicit CommandLine(std::span<const Verb> verbs) {
    app.set_version_flag("--version", std::string("sinew ") + programVersion(), "Print the version and exit");
    app.set_help_flag("-h,--help", "Print this and exit");
    app.footer(kExamples);
    app.require_subcommand(1);
    for (const Verb& verb : verbs) {
      CLI::App* parser = app.add_subcommand(verb.name, verb.summary);
      runs.emplace_back(parser, verb.add(*parser));
      parser->footer("");
    }
  }
};

bool isVerb(std::span<const Verb> verbs, const std::string& word) {
  return std::ranges::find(verbs, word, &Verb::name) != verbs.end();
}

/// The arguments after the program's name, with the first verb in front if there is none.
std::vector<std::string> withVerb(std::span<const Verb> verbs, int argc, const char* const* argv) {
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  const bool asked = !arguments.empty() && (isVerb(verbs, arguments[0]) || arguments[0] == "--help" ||
                                            arguments[0] == "-h" || arguments[0] == "--version");
  if (!asked) arguments.insert(arguments.begin(), verbs.front().name);
  return arguments;
}

/// A word that names neither a verb nor a file is a typo, not a reason to open a window.
bool isUnknownWord(std::span<const Verb> verbs, const std::string& word) {
  std::error_code failed;
  return !word.empty() && word.find_first_of("./-") == std::string::npos && !isVerb(verbs, word) &&
         !std::filesystem::exists(word, failed);
}

/// Help and version go to stdout, everything else to stderr.
int answer(const CommandLine& line, const CLI::ParseError& error) {
  if (dynamic_cast<const CLI::CallForHelp*>(&error)) {
    const auto chosen = line.app.get_subcommands();
    return putResult(chosen.empty() ? line.app.help() : chosen.front()->help("sinew"));
  }
  if (dynamic_cast<const CLI::CallForVersion*>(&error)) return putResult(std::string(error.what()) + '\n');
  const auto chosen = line.app.get_subcommands();
  const std::string refusal = parseRefusal(chosen.empty() ? line.app : *chosen.front(), error);
  return badCommandLine(refusal + " (see: sinew " + (chosen.empty() ? "" : chosen.front()->get_name() + ' ') +
                        "--help)");
}

}  // namespace

int runCommandLine(int argc, const char* const* argv, const RunEditor& edit) {
  const std::vector<Verb> verbs = allVerbs(edit);
  if (argc > 1 && isUnknownWord(verbs, argv[1])) {
    std::vector<std::string> names;
    for (const Verb& verb : verbs) names.push_back(verb.name);
    return badCommandLine('"' + std::string(argv[1]) + "\" is neither a verb nor a file" + didYouMean(argv[1], names) +
                          " (see: sinew --help)");
  }
  CommandLine line(verbs);
  std::vector<std::string> arguments = withVerb(verbs, argc, argv);
  std::ranges::reverse(arguments);  // The parser takes them from the back.
  try {
    line.app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    return answer(line, error);
  }
  const auto chosen = std::ranges::find_if(line.runs, [](const auto& run) { return run.first->parsed(); });
  return chosen->second.run();
}

}  // namespace sinew::app
