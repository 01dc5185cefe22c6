// tests/geometry/parallel_list_test.cpp: a list built by several threads equals a single loop's.
#include "core/geometry/parallel.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace sinew::test {
namespace {

TEST(ParallelList, MatchesASequentialLoop) {
  std::mt19937 random(7);
  for (const std::size_t count : {0u, 1u, 63u, 64u, 65u, 640u, 5'000u, 100'001u}) {
    for (const unsigned rarity : {1u, 3u, 1000u}) {
      std::vector<int> expected;
      std::vector<bool> isListed(count);
      for (std::size_t i = 0; i < count; ++i) {
        isListed[i] = random() % rarity == 0;
        if (isListed[i]) expected.push_back(static_cast<int>(i));
      }
      for (const int most : {1, 2, 3, 8}) {
        const ThreadLimit limit(most);
        for (const std::size_t least : {std::size_t{1}, std::size_t{500}}) {
          std::vector<int> out(count + 1, -1);
          const std::size_t found =
              listInBlocks(count, least, out.data(), [&](std::size_t begin, std::size_t end, int* listed) {
                EXPECT_EQ(begin % 64, 0u);
                std::size_t written = 0;
                for (std::size_t i = begin; i < end; ++i) {
                  listed[written] = static_cast<int>(i);
                  written += isListed[i] ? 1 : 0;
                }
                return written;
              });
          ASSERT_EQ(std::vector(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(found)), expected) << count;
          EXPECT_EQ(out.back(), -1) << "Written beyond the end.";
        }
      }
    }
  }
}

}  // namespace
}  // namespace sinew::test
