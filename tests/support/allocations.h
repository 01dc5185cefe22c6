// tests/support/allocations.h: counts what `new` is asked for. A test program that calls this counts all its own.
#pragma once

#include <cstddef>
#include <cstdint>

namespace sinew::test {

/// Allocations by this thread since it began.
[[nodiscard]] std::int64_t allocations();

/// Counts this thread's allocations of exactly so many bytes while it lives. One at a time.
class AllocationsOf {
 public:
  explicit AllocationsOf(std::size_t bytes);
  ~AllocationsOf();
  AllocationsOf(const AllocationsOf&) = delete;
  AllocationsOf& operator=(const AllocationsOf&) = delete;

  [[nodiscard]] std::int64_t count() const;
};

}  // namespace sinew::test
