// tests/support/allocations.h: counts what `new` is asked for. A test program that calls this counts all its own.
#pragma once

#include <cstdint>

namespace sinew::test {

/// Allocations by this thread since it began.
[[nodiscard]] std::int64_t allocations();

}  // namespace sinew::test
