// core/include/sinew/geometry/threads.h: how many threads work on one call.
#pragma once

#include "sinew/geometry/same_version.h"

namespace sinew {

/// As long as it lives, calls from this thread work on so many threads at most, itself among them. Without one, on as
/// many as the process has cores. Results do not depend on it, to the last bit.
class ThreadLimit {
 public:
  /// @param most  at least 1; 0: no limit
  explicit ThreadLimit(int most);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  int before_ = 0;
};

/// Threads of calls from this thread: the cores that the process may use, at most this thread's limit.
[[nodiscard]] int threadCount();

}  // namespace sinew
