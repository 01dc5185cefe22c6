// core/include/sinew/geometry/task_system.h: whose threads do the work.
#pragma once

#include "sinew/geometry/same_version.h"

namespace sinew {

/// Does tasks on a game's own threads in place of oneTBB's.
struct TaskSystem {
  /// Calls task(work, i) once for each i = 0..tasks-1, on any threads and in any order, and returns when all have
  /// returned. May be called by several threads at once, and by a task. Tasks throw nothing. Must not throw.
  void (*run)(void* user, int tasks, void (*task)(void* work, int index), void* work) = nullptr;
  void* user = nullptr;
  int threads = 1;  ///< That run() works on, the calling one among them; at least 1.
};

/// For the whole process, from then on; with `run` null, oneTBB's threads again (or none where Sinew was built without
/// it). Not while another thread calls Sinew. Results do not depend on it, to the last bit.
void setTaskSystem(const TaskSystem& tasks);

}  // namespace sinew
