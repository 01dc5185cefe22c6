// tests/geometry/parallel_test.cpp: every index is visited once for any number of threads; exceptions are rethrown.

#include "core/geometry/parallel.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace sinew::test {
namespace {

TEST(Parallel, EveryIndexIsVisitedOnce) {
  for (const int most : {0, 1, 2, 3, 8}) {
    const ThreadLimit limit(most);
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{63}, std::size_t{10'000}}) {
      std::vector<int> seen(count, 0);
      std::atomic<bool> tooShort = false;
      forRanges(count, 16, [&](std::size_t begin, std::size_t end) {
        if (end - begin < 8 && count > 16) tooShort = true;  // oneTBB splits ranges longer than that.
        for (std::size_t i = begin; i < end; ++i) ++seen[i];
      });
      EXPECT_TRUE(std::ranges::all_of(seen, [](int times) { return times == 1; })) << most << ' ' << count;
      EXPECT_FALSE(tooShort);
    }
  }
}

TEST(Parallel, ThreadLimitLastsForItsScope) {
  const int before = threadCount();
  {
    const ThreadLimit limit(2);
    const int limited = threadCount();
    EXPECT_EQ(limited, std::min(2, before));
    std::atomic<int> others = 0;
    forEachIndex(1000, 1, [&](std::size_t) { others += threadCount() == limited ? 0 : 1; });
    EXPECT_EQ(others, 0);
    {
      const ThreadLimit inner(1);
      EXPECT_EQ(threadCount(), 1);
    }
    EXPECT_EQ(threadCount(), limited);
  }
  EXPECT_EQ(threadCount(), before);
}

TEST(Parallel, ExceptionsPropagate) {
  for (const int most : {1, 4}) {
    const ThreadLimit limit(most);
    const auto thrower = [](std::size_t i) {
      if (i == 777) throw std::runtime_error("777");
    };
    EXPECT_THROW(forEachIndex(1000, 1, thrower), std::runtime_error);
  }
}

}  // namespace
}  // namespace sinew::test
