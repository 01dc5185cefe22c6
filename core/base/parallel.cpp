// core/base/parallel.cpp: loops by oneTBB.
#include "core/base/parallel.h"

#include <algorithm>
#include <map>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace sinew {
namespace {

thread_local int mostThreads = 0;  // 0: no limit.

/// oneTBB hands work over inside of its library, where ThreadSanitizer sees nothing: it is told here.
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

/// This thread's arena, kept for its next calls: one may run inside another.
tbb::task_arena& limitedArena(int threads) {
  thread_local std::map<int, tbb::task_arena> arenas;
  return arenas.try_emplace(threads, threads).first->second;
}

}  // namespace

ThreadLimit::ThreadLimit(int most) : before_(mostThreads) { mostThreads = most; }
ThreadLimit::~ThreadLimit() { mostThreads = before_; }

int threadCount() {
  const int cores = tbb::this_task_arena::max_concurrency();
  return mostThreads > 0 ? std::min(mostThreads, cores) : cores;
}

void parallel::run(std::size_t count, std::size_t least, void* use, Call call) {
  const int limit = mostThreads;
  const int threads = threadCount();
  if (count <= least || threads == 1) {
    if (count > 0) call(use, 0, count);
    return;
  }
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

}  // namespace sinew
