// core/include/sinew/geometry/threads.h: the number of threads for one call.
#pragma once

#include "sinew/geometry/same_version.h"

namespace sinew {

/// Limits the threads of calls from this thread, itself included, for its lifetime; the default is the number of cores.
/// Results do not depend on it, bit for bit.
class ThreadLimit {
 public:
  explicit ThreadLimit(int most);  ///< @param most  at least 1; 0: no limit
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  int before_ = 0;
};

/// Number of threads of calls from this thread: the cores of the process, at most this thread's limit.
[[nodiscard]] int threadCount();

}  // namespace sinew
