// app/command/shard.cpp: a share from the command line, or from the array job that this process is a task of.
#include "app/command/shard.h"

#include <charconv>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace sinew::app {
namespace {

std::optional<int> intIn(std::string_view text) {
  int value = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failed != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Grid Engine says "undefined" in jobs that are no arrays.
std::optional<int> variable(const char* name) {
  const char* text = std::getenv(name);
  return text == nullptr ? std::nullopt : intIn(text);
}

struct ArrayVariables {
  const char* id;
  const char* first;
  const char* last;
  const char* step;
  const char* count;  ///< Null: the system does not say.
};
constexpr ArrayVariables kSlurm{"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX",
                                "SLURM_ARRAY_TASK_STEP", "SLURM_ARRAY_TASK_COUNT"};
constexpr ArrayVariables kGridEngine{"SGE_TASK_ID", "SGE_TASK_FIRST", "SGE_TASK_LAST", "SGE_TASK_STEPSIZE", nullptr};

std::optional<Shard> shardIn(const ArrayVariables& names) {
  const auto id = variable(names.id), first = variable(names.first), last = variable(names.last);
  const int step = variable(names.step).value_or(1);
  if (!id || !first || !last || step < 1 || *first < 0 || *id < *first || *id > *last) return std::nullopt;
  const Shard shard{(*id - *first) / step, (*last - *first) / step + 1};
  // An array with gaps, such as one of failed tasks alone, would leave shares out.
  const int tasks = names.count == nullptr ? shard.count : variable(names.count).value_or(shard.count);
  if ((*id - *first) % step != 0 || tasks != shard.count) return std::nullopt;
  return shard;
}

}  // namespace

Result<Shard> shardOf(const std::string& text) {
  if (text.empty()) return Shard{};
  if (text == "auto") {
    if (const auto slurm = shardIn(kSlurm)) return *slurm;
    if (const auto gridEngine = shardIn(kGridEngine)) return *gridEngine;
    return errorAt("--shard", "auto: this is no task of a Slurm or Grid Engine array job without gaps");
  }
  const std::size_t slash = text.find('/');
  const auto index = intIn(std::string_view(text).substr(0, slash));
  const auto count = slash == std::string::npos ? std::nullopt : intIn(std::string_view(text).substr(slash + 1));
  if (!index || !count || *count < 1 || *count > kMostShards || *index < 0 || *index >= *count) {
    return errorAt("--shard", "expected auto, or I/N with 0 <= I < N, got \"" + text + '"');
  }
  return Shard{*index, *count};
}

}  // namespace sinew::app
