// app/cli/farm.cpp: writes down a batch job for a farm. It starts nothing.
#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <system_error>

#include <CLI/CLI.hpp>

#include "app/cli/console.h"
#include "app/cli/verb.h"
#include "app/export/farm_job.h"
#include "core/io/files/atomic_file.h"

namespace sinew::app {
namespace {

struct FarmOptions {
  int tasks = 16;
  std::string to;
  std::string program;         ///< Empty: this one.
  std::filesystem::path file;  ///< Empty: stdout.
  CLI::App* parser = nullptr;  ///< Keeps what it did not understand: the verb and its arguments.
};

/// Why the verb would refuse its arguments, or nullopt.
std::optional<std::string> refusalOf(const Verb& verb, std::span<const std::string> arguments) {
  CLI::App parser{verb.summary, verb.name};
  const auto run = verb.add(parser);
  std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
  try {
    parser.parse(std::move(reversed));
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return std::nullopt;
}

int putJob(const std::string& text, const std::filesystem::path& file) {
  if (file.empty()) return putResult(text);
  if (const auto written = writeFileAtomically(file, text); !written) return badInput(written.error());
  return putResult(file.string() + '\n');
}

int runFarm(const FarmOptions& options, std::span<const Verb> verbs) {
  FarmJob job;
  job.arguments = options.parser->remaining();
  std::string names;
  for (const Verb& verb : verbs) names += (names.empty() ? "" : ", ") + verb.name;
  const std::string named = job.arguments.empty() ? "" : job.arguments.front();
  const auto verb = std::ranges::find(verbs, named, &Verb::name);
  if (verb == verbs.end()) return badCommandLine("farm: expected one of the verbs " + names + ", got \"" + named + '"');
  for (const char* own : {"--shard", "--resume", "--dry-run"}) {
    const auto isOwn = [&](const std::string& argument) {
      return argument == own || argument.starts_with(std::string(own) + '=');
    };
    if (std::ranges::any_of(job.arguments, isOwn)) return badCommandLine(std::string(own) + ": farm sets it");
  }
  if (const auto refusal = refusalOf(*verb, std::span(job.arguments).subspan(1))) {
    return badCommandLine(verb->name + ": " + *refusal + " (see: sinew " + verb->name + " --help)");
  }
  std::error_code failed;
  job.folder = std::filesystem::current_path(failed);
  if (failed) return badInput(errorAt("current folder", failed.message()));
  job.program = options.program.empty() ? thisProgram() : options.program;
  job.tasks = options.tasks;
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
  verb.add_option("--tasks", options.tasks, "How many tasks share the work (16)")
      ->type_name("N")
      ->check(CLI::Range(1, kMostTasks));
  verb.add_option("--program", options.program, "What the machines call this program; without it, its path here")
      ->type_name("PATH");
  verb.add_option_function<std::string>(
          "--job", [&options](const std::string& text) { options.file = text; }, "Write the job here, not to stdout")
      ->type_name("FILE");
}

}  // namespace

Verb farmVerb(std::vector<Verb> verbs) {
  return makeVerb<FarmOptions>(
      "farm", "Write down a batch job for Slurm, GNU parallel or another farm", addFarmOptions,
      [verbs = std::move(verbs)](const FarmOptions& options) { return runFarm(options, verbs); });
}

}  // namespace sinew::app
