// core/geometry/own_tasks.cpp: loops by oneTBB, or on one thread where Sinew was built without it.
#include "core/geometry/parallel.h"

#ifdef SINEW_WITH_TBB

#include <map>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace sinew::parallel {
namespace {

/// Tells ThreadSanitizer of the synchronization inside oneTBB's library, which it does not see.
class HandOver {
 public:
  void give() {
#ifdef __SANITIZE_THREAD__
    __tsan_release(this);
#endif
  }
  void take() {
#ifdef __SANITIZE_THREAD__
    __tsan_acquire(this);
#endif
  }
};

/// This thread's arena, kept for later calls; arenas may nest.
tbb::task_arena& limitedArena(int threads) {
  thread_local std::map<int, tbb::task_arena> arenas;
  return arenas.try_emplace(threads, threads).first->second;
}

}  // namespace

int ownThreads() { return tbb::this_task_arena::max_concurrency(); }

void runOnOwnThreads(std::size_t count, std::size_t least, int threads, int limit, void* use, Call call) {
  HandOver start;
  HandOver end;
  const auto all = [&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, least), [&](const tbb::blocked_range<std::size_t>& r) {
      start.take();
      const ThreadLimit inside(limit);
      call(use, r.begin(), r.end());
      end.give();
    });
  };
  start.give();
  if (threads == tbb::this_task_arena::max_concurrency()) all();
  else limitedArena(threads).execute(all);
  end.take();
}

}  // namespace sinew::parallel

#else

namespace sinew::parallel {

int ownThreads() { return 1; }

void runOnOwnThreads(std::size_t count, std::size_t /*least*/, int /*threads*/, int /*limit*/, void* use, Call call) {
  call(use, 0, count);
}

}  // namespace sinew::parallel

#endif
