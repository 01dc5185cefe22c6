// app/document/farm_job.h: a batch job as text for the tools of a farm. docs/install.md.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/geometry/result.h"
#include "sinew/rig/rig.h"

namespace sinew::app {

/// What one task of a job takes.
struct TaskNeeds {
  int cores = 1;
  int megabytes = 0;  ///< Peak.
};

/// For one input. One core unless --threads names more: many tasks on one core each use a machine best.
/// @param verb  "smooth", "export" or "render"  @param rig  with the changes of the command line
/// @param threads  of --threads, or 0  @param heldFrames  of a clip held in memory
/// Error: the rig does not fit the character.
[[nodiscard]] Result<TaskNeeds> taskNeeds(const std::string& verb, const std::shared_ptr<const Character>& character,
                                          const Rig& rig, int threads, double heldFrames = 0.0);

[[nodiscard]] TaskNeeds larger(const TaskNeeds& a, const TaskNeeds& b);  ///< Enough for both.

inline constexpr int kMostTasks = 100000;

struct FarmJob {
  std::string program;                 ///< Path on the machines of the farm.
  std::filesystem::path folder;        ///< Absolute; names in the arguments are relative to it.
  std::vector<std::string> arguments;  ///< The verb and its arguments, without --shard.
  int tasks = 1;                       ///< One shard each.
  bool resume = true;                  ///< Skip outputs that exist.
  TaskNeeds needs{};                   ///< Of one task.
};

/// A format of jobs.
struct FarmTarget {
  const char* word;    ///< After --to.
  const char* title;   ///< "GNU parallel"
  const char* ending;  ///< Usual ending of the job's file.
  const char* runWith;
  Result<std::string> (*write)(const FarmJob& job);  ///< Error: the format cannot express the job.
};
[[nodiscard]] std::span<const FarmTarget> farmTargets();
[[nodiscard]] const FarmTarget* findFarmTarget(std::string_view word);  ///< By its word, or null.

[[nodiscard]] std::string thisProgram();  ///< The path of the running program.

[[nodiscard]] std::string shellWord(const std::string& text);  ///< One word of a POSIX shell, quoted where needed.

}  // namespace sinew::app
