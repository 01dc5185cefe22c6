// app/document/farm_job.cpp: a task's needs; jobs in each format. Reruns make missing files unless jobs replace them.
#include "app/document/farm_job.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <string_view>
#include <system_error>

#include "core/files/json/json.h"
#include "sinew/character/pose.h"
#include "sinew/surface/smoother.h"

namespace sinew::app {

namespace {

/// Megabytes of a task, and kilobytes for each refined vertex: about twice what was measured.
struct Memory {
  double base;
  double ofVertex;
};

Memory memoryOf(const std::string& verb) {
  if (verb == "export") return {500.0, 6.0};
  if (verb == "render") return {400.0, 1.5};
  return {100.0, 1.0};
}

constexpr double kOfHeldPoint = 0.05;  ///< Kilobytes of a vertex in each frame of a clip held in memory.
constexpr double kStep = 100.0;        ///< Megabytes; needs are rounded up to it.

}  // namespace

Result<TaskNeeds> taskNeeds(const std::string& verb, const std::shared_ptr<const Character>& character, const Rig& rig,
                            int threads, double heldFrames) {
  Smoother smoother(character);
  if (const auto prepared = smoother.prepare(rig); !prepared) return prepared.error();
  Surface surface;
  smoother.smooth(bindPose(character->skeleton), surface);
  const Memory memory = memoryOf(verb);
  const double ofVertex = memory.ofVertex + kOfHeldPoint * heldFrames;
  const double megabytes = memory.base + ofVertex * static_cast<double>(surface.positions.size()) / 1000.0;
  return TaskNeeds{std::max(threads, 1), static_cast<int>(kStep * std::ceil(megabytes / kStep))};
}

TaskNeeds larger(const TaskNeeds& a, const TaskNeeds& b) {
  return {std::max(a.cores, b.cores), std::max(a.megabytes, b.megabytes)};
}

namespace {

constexpr const char* kShardWord = "SINEW_SHARD";  ///< GNU parallel replaces it with the shard's number.

std::string inFolder(const FarmJob& job) { return "cd " + shellWord(job.folder.string()) + " && "; }

/// The program with its arguments. @param shard  quoted for the shell
std::string commandOf(const FarmJob& job, const std::string& shard) {
  std::string line = shellWord(job.program) + ' ' + shellWord(job.arguments.front()) + " --shard " + shard +
                     (job.resume ? " --resume" : "");
  for (const std::string& argument : std::span(job.arguments).subspan(1)) line += ' ' + shellWord(argument);
  return line;
}

std::string shardText(const std::string& index, const FarmJob& job) { return index + '/' + std::to_string(job.tasks); }

std::string nameOf(const FarmJob& job) { return "sinew-" + job.arguments.front(); }

Result<std::string> commandLines(const FarmJob& job) {
  const auto breaks = [](const std::string& text) { return text.find('\n') != std::string::npos; };
  if (std::ranges::any_of(job.arguments, breaks) || breaks(job.folder.string()) || breaks(job.program)) {
    return errorAt("--to", "commands: a line break in what is to run would break its line");
  }
  std::string lines;
  for (int task = 0; task < job.tasks; ++task) {
    lines += inFolder(job) + commandOf(job, shardText(std::to_string(task), job)) + '\n';
  }
  return lines;
}

Result<std::string> parallelScript(const FarmJob& job) {
  return "#!/bin/sh\n"
         "# " +
         std::to_string(job.tasks) +
         " tasks for GNU parallel. Its options can be added: sh JOB --jobs 4 --sshlogin HOST\n" + inFolder(job) +
         "seq 0 " + std::to_string(job.tasks - 1) + " | parallel --quote --workdir " + shellWord(job.folder.string()) +
         " -I " + kShardWord + " \"$@\" " + commandOf(job, shardText(kShardWord, job)) + '\n';
}

Result<std::string> slurmScript(const FarmJob& job) {
  const std::string name = nameOf(job);
  return "#!/bin/sh\n"
         "#SBATCH --job-name=" +
         name + "\n#SBATCH --array=0-" + std::to_string(job.tasks - 1) +
         "\n#SBATCH --cpus-per-task=" + std::to_string(job.needs.cores) +
         "\n#SBATCH --mem=" + std::to_string(job.needs.megabytes) + "M\n#SBATCH --output=" + name +
         "-%A_%a.log\n"
         "# Submit with: sbatch JOB. Options of sbatch can be added, as --array=0-" +
         std::to_string(job.tasks - 1) + "%8 for eight tasks at once.\n" + inFolder(job) + "exec " +
         commandOf(job, "\"$SLURM_ARRAY_TASK_ID\"/" + std::to_string(job.tasks)) + '\n';
}

Result<std::string> openJobTemplate(const FarmJob& job) {
  const auto expands = [](const std::string& text) { return text.find("{{") != std::string::npos; };
  if (std::ranges::any_of(job.arguments, expands) || expands(job.folder.string()) || expands(job.program)) {
    return errorAt("--to", "openjd: a job template would expand \"{{\" in what it is to run");
  }
  const std::string script = inFolder(job) + "exec " + commandOf(job, shardText("{{Task.Param.Shard}}", job));
  Json parameter = Json::object();
  parameter.set("name", "Shard").set("type", "INT").set("range", "0-" + std::to_string(job.tasks - 1));
  Json space = Json::object();
  space.set("taskParameterDefinitions", Json::array({parameter}));
  Json run = Json::object();
  run.set("command", "sh").set("args", Json::array({"-c", script}));
  Json step = Json::object();
  step.set("name", job.arguments.front()).set("parameterSpace", space);
  step.set("script", Json::object().set("actions", Json::object().set("onRun", run)));
  Json json = Json::object();
  json.set("specificationVersion", "jobtemplate-2023-09").set("name", nameOf(job)).set("steps", Json::array({step}));
  return json.dump(true) + '\n';
}

constexpr FarmTarget kTargets[] = {
    {"slurm", "Slurm", ".sh", "sbatch", slurmScript},
    {"parallel", "GNU parallel", ".sh", "sh", parallelScript},
    {"openjd", "OpenJD", ".json", "openjd run, or Deadline Cloud", openJobTemplate},
    {"commands", "Commands", ".txt", "any shell, or a farm's command script", commandLines},
};

}  // namespace

std::span<const FarmTarget> farmTargets() { return kTargets; }

const FarmTarget* findFarmTarget(std::string_view word) {
  const auto* const found = std::ranges::find(kTargets, word, &FarmTarget::word);
  return found == std::end(kTargets) ? nullptr : found;
}

std::string thisProgram() {
  std::error_code failed;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failed);
  return failed ? "sinew" : program.string();
}

std::string shellWord(const std::string& text) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + '\'';
}

}  // namespace sinew::app
