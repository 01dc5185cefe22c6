// core/geometry/own_tasks.h: threads where a program brings none of its own.
#pragma once

#include <cstddef>

#include "core/geometry/parallel.h"

namespace sinew::parallel {

/// Cores that this process may use; 1 where Sinew was built without oneTBB.
[[nodiscard]] int ownThreads();

/// As run() of parallel.h on so many threads. @param limit  this thread's limit, which holds inside too
void runOnOwnThreads(std::size_t count, std::size_t least, int threads, int limit, void* use, Call call);

}  // namespace sinew::parallel
