// tests/support/allocations.h: counts calls of operator new. A test program that includes it counts all of its own.
#pragma once

#include <cstddef>
#include <cstdint>

namespace sinew::test {

/// Allocations by this thread since it began.
[[nodiscard]] std::int64_t allocations();

/// Counts this thread's allocations of exactly this many bytes during its lifetime. One at a time.
class AllocationsOf {
 public:
  explicit AllocationsOf(std::size_t bytes);
  ~AllocationsOf();
  AllocationsOf(const AllocationsOf&) = delete;
  AllocationsOf& operator=(const AllocationsOf&) = delete;

  [[nodiscard]] std::int64_t count() const;
};

}  // namespace sinew::test
