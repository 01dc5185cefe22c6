// tests/files/export/error_meter_test.cpp: error statistics match those of a sorted list.
#include "core/files/fit/played_surface.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace sinew::exporting {
namespace {

TEST(ErrorMeter, MatchesASortedList) {
  std::mt19937 random(5);
  std::lognormal_distribution<double> spread(-4.0, 2.0);
  constexpr double kHeight = 1.7;
  ErrorMeter meter(kHeight);
  std::vector<double> percent;
  for (int i = 0; i < 54321; ++i) {
    const double distance = i % 10 == 0 ? 0.0 : spread(random);
    meter.add(distance, i);
    percent.push_back(100.0 * distance / kHeight);
  }
  meter.addPose(0, 0.0f);
  meter.addPose(0, 0.0f);
  std::ranges::sort(percent);
  double squares = 0.0;
  for (const double p : percent) squares += p * p;
  const ErrorFigures figures = meter.figures();
  EXPECT_EQ(figures.poses, 2);
  EXPECT_NEAR(figures.rms, std::sqrt(squares / static_cast<double>(percent.size())), 1e-9 * figures.rms);
  EXPECT_NEAR(figures.largest, percent.back(), 1e-12 * figures.largest);
  const double exact = percent[percent.size() - 1 - percent.size() / 1000];
  EXPECT_GE(figures.percentile999, exact * (1.0 - 1e-6));
  EXPECT_LE(figures.percentile999, exact * 1.0011);
}

TEST(ErrorMeter, IsZeroWithoutDistances) {
  const ErrorFigures figures = ErrorMeter(1.0).figures();
  EXPECT_EQ(figures.poses, 0);
  EXPECT_EQ(figures.rms, 0.0);
  EXPECT_EQ(figures.percentile999, 0.0);
  EXPECT_EQ(figures.largest, 0.0);
  EXPECT_EQ(figures.farthest.vertex, -1);
}

TEST(ErrorMeter, FewDistancesGiveTheLargestAsPercentileWithItsLocation) {
  ErrorMeter meter(100.0);
  meter.addPose(2, 0.5f);
  meter.add(0.25, 7);
  meter.addPose(3, 1.5f);
  meter.add(3.0, 9);
  meter.addPose(4, 2.5f);
  meter.add(1.0, 11);
  EXPECT_NEAR(meter.figures().percentile999, 3.0, 1e-9);
  EXPECT_EQ(meter.farthestClip(), 3);
  EXPECT_EQ(meter.figures().farthest.vertex, 9);
  EXPECT_EQ(meter.figures().farthest.time, 1.5f);
}

TEST(ErrorMeter, NonFiniteDistanceIsTheLargest) {
  for (const double odd : {std::nan(""), -std::nan(""), HUGE_VAL}) {
    ErrorMeter meter(2.0);
    meter.add(1.0, 3);
    meter.add(odd, 7);
    EXPECT_TRUE(std::isinf(meter.figures().largest));
    EXPECT_EQ(meter.figures().farthest.vertex, 7);
  }
}

}  // namespace
}  // namespace sinew::exporting
