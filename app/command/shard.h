// app/command/shard.h: which share of a job a process does.
#pragma once

#include <cstddef>
#include <string>

#include "sinew/geometry/result.h"

namespace sinew::app {

inline constexpr int kMostShards = 1000000;

struct Shard {
  int index = 0;  ///< 0..count-1.
  int count = 1;

  [[nodiscard]] bool holds(std::size_t item) const {
    return item % static_cast<std::size_t>(count) == static_cast<std::size_t>(index);
  }
};

/// "I/N", or "auto": what Slurm (SLURM_ARRAY_TASK_ID, _MIN, _MAX, _STEP) or Grid Engine (SGE_TASK_ID, _FIRST, _LAST,
/// _STEPSIZE) say in the environment. "": the whole job. Error: place is "--shard".
[[nodiscard]] Result<Shard> shardOf(const std::string& text);

}  // namespace sinew::app
