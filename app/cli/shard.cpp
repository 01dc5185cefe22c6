// app/cli/shard.cpp: a share from the command line, or from the array job that this process is a task of.
#include "app/cli/shard.h"

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
};
constexpr ArrayVariables kSlurm{"SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX",
                                "SLURM_ARRAY_TASK_STEP"};
constexpr ArrayVariables kGridEngine{"SGE_TASK_ID", "SGE_TASK_FIRST", "SGE_TASK_LAST", "SGE_TASK_STEPSIZE"};

std::optional<Shard> shardIn(const ArrayVariables& names) {
  const auto id = variable(names.id), first = variable(names.first), last = variable(names.last);
  const int step = variable(names.step).value_or(1);
  if (!id || !first || !last || step < 1 || *first < 0 || *id < *first || *id > *last) return std::nullopt;
  return Shard{(*id - *first) / step, (*last - *first) / step + 1};
}

}  // namespace

Result<Shard> shardOf(const std::string& text) {
  if (text.empty()) return Shard{};
  if (text == "auto") {
    if (const auto slurm = shardIn(kSlurm)) return *slurm;
    if (const auto gridEngine = shardIn(kGridEngine)) return *gridEngine;
    return errorAt("--shard", "auto: this is no task of a Slurm or Grid Engine array job");
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
