// core/include/sinew/geometry/task_system.h: runs Sinew's work on a game's threads.
#pragma once

#include "sinew/geometry/same_version.h"

namespace sinew {

/// Runs tasks on a game's own threads instead of oneTBB's.
struct TaskSystem {
  /// Must call task(work, i) once for each i = 0..tasks-1, on any threads and in any order, and return when all have
  /// returned. May be called by several threads at once, and by a task. Tasks do not throw; must not throw.
  void (*run)(void* user, int tasks, void (*task)(void* work, int index), void* work) = nullptr;
  void* user = nullptr;
  int threads = 1;  ///< Number of threads of run(), including the calling one; at least 1.
};

/// For the whole process; `run` null: oneTBB's threads, or none if Sinew was built without it. Not while another thread
/// calls Sinew. Results do not depend on it, bit for bit.
void setTaskSystem(const TaskSystem& tasks);

}  // namespace sinew
