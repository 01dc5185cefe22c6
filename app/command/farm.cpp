// app/command/farm.cpp: `sinew farm`: writes a batch job. It starts nothing.
#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <system_error>

#include <CLI/CLI.hpp>

#include "app/command/console.h"
#include "app/command/verbs.h"
#include "app/document/farm_job.h"
#include "core/files/disk/atomic_file.h"
#include "core/geometry/nearest_name.h"

namespace sinew::app {
namespace {

struct FarmOptions {
  int tasks = 16;
  std::string to;
  std::string program;         ///< Empty: this one.
  std::filesystem::path file;  ///< Empty: stdout.
  CLI::App* parser = nullptr;  ///< Its remaining arguments are the verb and the verb's arguments.
};

/// Whether the verb can run with these arguments. Error: in the command line, or in the job's inputs.
Result<FarmCheck> checkJob(const Verb& verb, std::span<const std::string> arguments) {
  CLI::App parser{verb.summary, verb.name};
  const VerbCalls calls = verb.add(parser);
  std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
  try {
    parser.parse(std::move(reversed));
  } catch (const CLI::ParseError& error) {
    return errorAt("", verb.name + ": " + parseRefusal(parser, error) + " (see: sinew " + verb.name + " --help)");
  }
  return calls.check();
}

/// At most one task per file.
int tasksFor(const FarmOptions& options, std::size_t files) {
  const auto most = static_cast<int>(std::min<std::size_t>(std::max<std::size_t>(files, 1), kMostTasks));
  if (options.tasks <= most) return options.tasks;
  if (options.parser->count("--tasks") == 0) return most;
  message("farm: " + std::to_string(files) + (files == 1 ? " file" : " files") + ": " + std::to_string(most) +
          (most == 1 ? " task" : " tasks"));
  return most;
}

int putJob(const std::string& text, const std::filesystem::path& file) {
  if (file.empty()) return putResult(text);
  if (const auto written = writeFileAtomically(file, text); !written) return badInput(written.error());
  return putResult(file.string() + '\n');
}

int runFarm(const FarmOptions& options, std::span<const Verb> verbs) {
  FarmJob job;
  job.arguments = options.parser->remaining();
  std::vector<std::string> names;
  for (const Verb& verb : verbs) names.push_back(verb.name);
  const std::string named = job.arguments.empty() ? "" : job.arguments.front();
  const auto verb = std::ranges::find(verbs, named, &Verb::name);
  if (verb == verbs.end()) {
    return badCommandLine("farm: expected one of the verbs " + listed(names, "or") + ", got \"" + named + '"' +
                          didYouMean(named, names));
  }
  for (const char* own : {"--shard", "--resume", "--dry-run"}) {
    const auto isOwn = [&](const std::string& argument) {
      return argument == own || argument.starts_with(std::string(own) + '=');
    };
    if (std::ranges::any_of(job.arguments, isOwn)) return badCommandLine(std::string(own) + ": farm sets it");
  }
  for (std::size_t i = 1; i < job.arguments.size(); ++i) {
    const bool isPipe = job.arguments[i] == "--list=-" || (job.arguments[i] == "-" && job.arguments[i - 1] == "--list");
    if (isPipe) return badCommandLine("--list: expected a file: the machines of a farm have no standard input");
  }
  const auto check = checkJob(*verb, std::span(job.arguments).subspan(1));
  if (!check) return refused(check.error());
  std::error_code failed;
  job.folder = std::filesystem::current_path(failed);
  if (failed) return badInput(errorAt("current folder", failed.message()));
  job.program = options.program.empty() ? thisProgram() : options.program;
  job.tasks = tasksFor(options, check->files);
  job.needs = check->needs;
  const auto text = findFarmTarget(options.to)->write(job);
  if (!text) return badCommandLine(text.error().text());
  return putJob(text.value(), options.file);
}

void addFarmOptions(CLI::App& verb, FarmOptions& options) {
  options.parser = &verb;
  verb.allow_extras();
  std::vector<std::string> words;
  for (const FarmTarget& target : farmTargets()) words.emplace_back(target.word);
  verb.add_option("--to", options.to,
                  "slurm (sbatch), parallel (GNU parallel), openjd (Deadline), commands (a line each)")
      ->type_name("FARM")
      ->required()
      ->check(CLI::IsMember(words));
  verb.add_option("--tasks", options.tasks, "How many tasks share the work (16), no more than there are files")
      ->type_name("N")
      ->check(CLI::Range(1, kMostTasks));
  verb.add_option("--program", options.program, "What the machines call this program; without it, its path here")
      ->type_name("PATH");
  addPath(verb, "--job", options.file, "Write the job here, not to stdout")->type_name("FILE");
}

}  // namespace

Verb farmVerb(std::vector<Verb> verbs) {
  return makeVerb<FarmOptions>(
      "farm", "Write a batch job for Slurm, GNU parallel or another farm", addFarmOptions,
      [verbs = std::move(verbs)](const FarmOptions& options) { return runFarm(options, verbs); });
}

}  // namespace sinew::app
