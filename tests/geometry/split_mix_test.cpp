// tests/geometry/split_mix_test.cpp: numbers of the published generator.

#include "core/geometry/index_table.h"

#include <array>

#include <gtest/gtest.h>

namespace sinew {
namespace {

TEST(SplitMix64, GivesThePublishedSequence) {
  // Output of the authors' own code from the state 1234567.
  constexpr std::array<std::uint64_t, 5> kExpected{6457827717110365317ULL, 3203168211198807973ULL,
                                                   9817491932198370423ULL, 4593380528125082431ULL,
                                                   16408922859458223821ULL};
  std::uint64_t state = 1234567;
  for (const std::uint64_t expected : kExpected) {
    EXPECT_EQ(splitMix64(state), expected);
    state += kSplitMixStep;
  }
}

}  // namespace
}  // namespace sinew
