// tests/ui/overflow_test.cpp: number of a bar's buttons that fit, and the stops of a stepped number.

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "app/ui/number_field.h"
#include "app/ui/ui.h"

namespace sinew::app {
namespace {

TEST(Overflow, ShowsAsManyItemsAsFit) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> length(5.0f, 80.0f);
  for (int round = 0; round < 2000; ++round) {
    std::vector<float> widths(std::uniform_int_distribution<std::size_t>(0, 9)(random));
    for (float& width : widths) width = length(random);
    const float room = 8.0f * length(random);
    const float more = 0.4f * length(random);
    const std::size_t shown = fittingCount(widths, room, more);
    ASSERT_LE(shown, widths.size());
    const auto sum = [&](std::size_t count) {
      return std::accumulate(widths.begin(), widths.begin() + static_cast<std::ptrdiff_t>(count), 0.0f);
    };
    const float all = sum(widths.size());
    ASSERT_EQ(shown == widths.size(), all <= room);
    if (shown == widths.size()) continue;
    if (shown > 0) {
      ASSERT_LE(sum(shown) + more, room);
    }
    // One more would not fit, or would leave no room for the overflow button.
    ASSERT_GT(sum(shown + 1) + more, room);
  }
}

TEST(NumberField, StepsAreMultiplesWithinTheRange) {
  for (float value = -2.0f; value < 2.0f; value += 0.013f) {
    const float stepped = toStep(value, 0.25f, -1.5f, 1.5f);
    EXPECT_FLOAT_EQ(stepped, std::round(stepped / 0.25f) * 0.25f);
    EXPECT_GE(stepped, -1.5f);
    EXPECT_LE(stepped, 1.5f);
    if (value > -1.5f && value < 1.5f) {
      EXPECT_LE(std::abs(stepped - value), 0.1251f);
    }
    EXPECT_EQ(toStep(value, 0.0f, -1.5f, 1.5f), value);
  }
}

}  // namespace
}  // namespace sinew::app
