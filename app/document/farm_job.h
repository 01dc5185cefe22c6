// app/document/farm_job.h: a batch job as the text that a farm's own tools take. docs/install.md.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/document/task_needs.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

inline constexpr int kMostTasks = 100000;

struct FarmJob {
  std::string program;                 ///< As the machines of the farm know it.
  std::filesystem::path folder;        ///< Absolute; names in the arguments are relative to it.
  std::vector<std::string> arguments;  ///< The verb and what follows it, without a shard.
  int tasks = 1;                       ///< Each makes one shard.
  bool resume = true;                  ///< Leaves out what is there already when it is run.
  TaskNeeds needs{};                   ///< Of one task.
};

/// What a job is written for.
struct FarmTarget {
  const char* word;    ///< Said after --to.
  const char* title;   ///< "GNU parallel"
  const char* ending;  ///< That the job's file usually has.
  const char* runWith;
  Result<std::string> (*write)(const FarmJob& job);
};
[[nodiscard]] std::span<const FarmTarget> farmTargets();
/// By its word; null: there is none.
[[nodiscard]] const FarmTarget* findFarmTarget(std::string_view word);

/// The path of the running program.
[[nodiscard]] std::string thisProgram();

/// One line per task, for a shell or a farm's command script. Error: a line break in what is to run.
[[nodiscard]] Result<std::string> commandLines(const FarmJob& job);
/// A shell script that calls GNU parallel.
[[nodiscard]] Result<std::string> parallelScript(const FarmJob& job);
/// A job array for sbatch.
[[nodiscard]] Result<std::string> slurmScript(const FarmJob& job);
/// An OpenJD job template, 2023-09. Error: an argument holds "{{", which the template would expand.
[[nodiscard]] Result<std::string> openJobTemplate(const FarmJob& job);

/// One word of a POSIX shell, quoted where it has to be.
[[nodiscard]] std::string shellWord(const std::string& text);

}  // namespace sinew::app
