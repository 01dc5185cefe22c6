// core/geometry/parallel.cpp: runs a loop on this thread, a game's task system, or Sinew's own threads.
#include "core/geometry/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>

#include "sinew/geometry/task_system.h"

namespace sinew {
namespace {

thread_local int mostThreads = 0;  // 0: no limit.
TaskSystem gameTasks;              // Without run(): Sinew's own threads.

/// More tasks than threads, so that a late thread does not delay the others.
constexpr std::size_t kTasksPerThread = 4;

/// A loop as tasks of a game. Keeps exceptions, which must not pass through the game's code.
struct TaskLoop {
  std::size_t count;
  std::size_t tasks;
  int limit;
  void* use;
  parallel::Call call;
  std::atomic_flag failed{};
  std::exception_ptr thrown{};

  void range(std::size_t index) {
    const ThreadLimit inside(limit);
    try {
      call(use, index * count / tasks, (index + 1) * count / tasks);
    } catch (...) {
      if (!failed.test_and_set()) thrown = std::current_exception();
    }
  }
};

void runOnGameThreads(std::size_t count, std::size_t least, int threads, int limit, void* use, parallel::Call call) {
  const std::size_t pieces = (count + least - 1) / std::max<std::size_t>(least, 1);
  // With a limit, no more tasks than may run at once.
  const std::size_t most = static_cast<std::size_t>(threads) * (limit > 0 ? 1 : kTasksPerThread);
  TaskLoop loop{count, std::min(pieces, most), limit, use, call};
  gameTasks.run(
      gameTasks.user, static_cast<int>(loop.tasks),
      [](void* work, int index) { static_cast<TaskLoop*>(work)->range(static_cast<std::size_t>(index)); }, &loop);
  if (loop.thrown) std::rethrow_exception(loop.thrown);
}

}  // namespace

ThreadLimit::ThreadLimit(int most) : before_(mostThreads) { mostThreads = most; }
ThreadLimit::~ThreadLimit() { mostThreads = before_; }

void setTaskSystem(const TaskSystem& tasks) { gameTasks = tasks; }

int threadCount() {
  const int threads = gameTasks.run ? std::max(1, gameTasks.threads) : parallel::ownThreads();
  return mostThreads > 0 ? std::min(mostThreads, threads) : threads;
}

void parallel::run(std::size_t count, std::size_t least, void* use, Call call) {
  const int limit = mostThreads;
  const int threads = threadCount();
  if (count <= least || threads == 1) {
    if (count > 0) call(use, 0, count);
    return;
  }
  if (gameTasks.run) runOnGameThreads(count, least, threads, limit, use, call);
  else runOnOwnThreads(count, least, threads, limit, use, call);
}

}  // namespace sinew
