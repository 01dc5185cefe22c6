// tests/command/measuring_test.cpp: medians, exponents, rotations and sample times of the benchmarks.
#include "app/command/measuring.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/characters/synthetic_characters.h"

namespace sinew::app {
namespace {

TEST(Measuring, MedianDoesNotDependOnOrder) {
  EXPECT_EQ(median({}), 0.0);
  EXPECT_EQ(median({3.0}), 3.0);
  EXPECT_EQ(median({9.0, 1.0, 4.0}), 4.0);
  EXPECT_EQ(median({4.0, 1.0}), 4.0) << "the upper one";
  EXPECT_EQ(medianRatio({2.0, 6.0, 5.0}, {1.0, 2.0, 0.0}), 3.0) << "where nothing is below, there is no ratio";
}

TEST(Measuring, ExponentMatchesKnownPowers) {
  const std::vector<double> x{1.0, 7.0, 50.0, 900.0};
  for (const double power : {-1.5, 0.0, 0.35, 1.0, 2.0}) {
    std::vector<double> y;
    for (const double each : x) y.push_back(3e-4 * std::pow(each, power));
    EXPECT_NEAR(exponent(x, y), power, 1e-12);
  }
}

TEST(Measuring, ExponentOfDegenerateDataIsZero) {
  EXPECT_EQ(exponent({}, {}), 0.0);
  EXPECT_EQ(exponent({4.0}, {2.0}), 0.0);
  EXPECT_EQ(exponent({4.0, 4.0}, {2.0, 3.0}), 0.0);
  EXPECT_NEAR(exponent({1.0, 10.0, 100.0, 5.0}, {1.0, 100.0, 10000.0, 0.0}), 2.0, 1e-12) << "no logarithm, no place";
}

TEST(Measuring, VariantsRotateThroughRounds) {
  std::vector<std::vector<std::size_t>> rounds(4);
  inTurn(3, 3, [&](std::size_t variant, int round) { rounds[static_cast<std::size_t>(round)].push_back(variant); });
  EXPECT_EQ(rounds[0], (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(rounds[1], (std::vector<std::size_t>{1, 2, 0}));
  EXPECT_EQ(rounds[2], (std::vector<std::size_t>{2, 0, 1}));
  EXPECT_EQ(rounds[3], rounds[0]);
}

TEST(Measuring, CharacterWithoutClipsGivesFrames) {
  Character character = *test::makeLimb();
  character.clips.clear();
  EXPECT_EQ(steadyFrames(character, 5, 0.1).size(), 5u);
  EXPECT_EQ(cutFrames(character, 4).size(), 4u);
}

}  // namespace
}  // namespace sinew::app
