// tests/surface/roots/root_finding_test.cpp: all three root finding methods on random rays match dense marching.

#include "core/surface/roots/ray_field.h"

#include <cmath>
#include <random>
#include <tuple>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace sinew {
namespace {

struct Scene {
  std::vector<PosedPrimitive> primitives;
  CliqueLevels levels;
  RayField field;
};

/// @param softest  upper end of grooves  @param inPart  some groups are linked in part
void fill(Scene& scene, float softest, bool inPart, std::mt19937& random, double iso = 0.25) {
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  scene.primitives.clear();
  const std::array<CliqueLists, 3> cliques{CliqueLists{{0, 1}, {1, 2}, {3}}, {{0}, {1}, {2}, {3}}, {{0, 3}, {1, 2, 3}}};
  const auto which = random() % 4;
  scene.levels = which == 3 ? CliqueLevels{} : CliqueLevels{{1.0, cliques[which]}};
  if (inPart) scene.levels = {{0.3, {{0, 1, 2}, {3}}}, {0.5, {{0, 1}, {1, 2}, {3}}}, {0.2, {{0}, {1}, {2}, {3}}}};
  scene.field.reset(iso, scene.levels);
  const glm::vec3 direction = glm::normalize(glm::vec3(unit(random), unit(random), 1.2f));
  for (int i = 0; i < 6; ++i) {
    Placement placement;
    placement.center = {0.7f * unit(random), 0.7f * unit(random), 0.7f * unit(random)};
    placement.radii = {0.3f + 0.2f * unit(random), 0.4f, 0.3f};
    placement.rotation = glm::normalize(glm::quat(1.0f, unit(random), unit(random), unit(random)));
    const float strength = i == 5 ? -0.6f : 1.0f;
    const float groove = softest * 0.5f * (1.0f + unit(random));
    scene.primitives.push_back({unitBallMap(placement, 1.4142135f, glm::mat4(1.0f)), strength, 0.3f, groove});
    scene.field.addPrimitive(scene.primitives.back(), 0.9f, i % 4, {0, 0, 0}, direction);
  }
}

/// First sign change by 40,000 steps and bisection. nullopt: none.
std::optional<double> march(const RayField& field, double end) {
  RayScratch scratch;
  const double sign = field.sample(0.0, scratch).value > 0.0 ? 1.0 : -1.0;
  double low = 0.0;
  for (int i = 1; i <= 40000; ++i) {
    double high = end * i / 40000;
    if (field.sample(high, scratch).value * sign <= 0.0) {
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (field.sample(middle, scratch).value * sign > 0.0 ? low : high) = middle;
      }
      return high;
    }
    low = high;
  }
  return std::nullopt;
}

TEST(ProjectionKinds, NamesRoundTrip) {
  for (const auto kind : {ProjectionKind::kNewton, ProjectionKind::kBisection, ProjectionKind::kAnalytic}) {
    EXPECT_EQ(projectionKindNamed(nameOf(kind)), kind);
  }
  EXPECT_EQ(projectionKindNamed("pn"), std::nullopt);
}

class FirstRoot : public testing::TestWithParam<std::tuple<float, bool>> {};

TEST_P(FirstRoot, AllMethodsMatchMarching) {
  std::mt19937 random(31);
  Scene scene;
  RayScratch scratch;
  std::array<int, 3> wrong{};
  int compared = 0;
  for (int round = 0; round < 1000; ++round) {
    fill(scene, std::get<0>(GetParam()), std::get<1>(GetParam()), random);
    const double end = 2.0;
    const std::optional<double> expected = march(scene.field, end);
    ++compared;
    const std::array methods{ProjectionKind::kNewton, ProjectionKind::kAnalytic, ProjectionKind::kBisection};
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const bool positive = scene.field.sample(0.0, scratch).value > 0.0;
      const std::optional<double> found = firstChange(scene.field, 0.0, end, positive, methods[m], 1e-9, scratch);
      const bool same = found.has_value() == expected.has_value() && (!found || std::abs(*found - *expected) < 1e-4);
      wrong[m] += !same;
    }
  }
  std::printf("first roots off by more than 1e-4 of %d: newton %d, analytic %d, bisection %d\n", compared, wrong[0],
              wrong[1], wrong[2]);
  for (const int count : wrong) EXPECT_LE(count, 1) << "every root is isolated; a touch may differ";
}

INSTANTIATE_TEST_SUITE_P(Grooves, FirstRoot, testing::Combine(testing::Values(0.0f, 0.2f, 2.0f), testing::Bool()));

/// The least phi between two places where it is larger; none: 1.
double leastDip(const RayField& field) {
  RayScratch scratch;
  const auto phi = [&](double t) { return field.sample(t, scratch).value; };
  double least = 1.0;
  for (double t = 0.01; t < 1.0; t += 0.01) {
    if (phi(t) < phi(t - 0.01) && phi(t) < phi(t + 0.01)) least = std::min(least, phi(t));
  }
  return least;
}

TEST(FirstRoot, HalvingsEndEarlyInGroovesWherePhiFallsSlowly) {
  // The least and the largest derivative of a clique would not tell that phi only falls.
  Scene scene;
  int found = 0;
  std::size_t depths = 0;  // Only halvings that go on with the first half count.
  for (unsigned seed = 0; seed < 8000; ++seed) {
    std::mt19937 random(seed);
    fill(scene, 1.0f, false, random);
    if (scene.levels.empty() || scene.levels.front().cliques.size() < 4) continue;
    const double iso = 0.25 + leastDip(scene.field) + 1e-3;
    if (iso < 0.1 || iso > 0.9) continue;
    random.seed(seed);
    fill(scene, 1.0f, false, random, iso);
    RayScratch scratch;
    if (!(scene.field.sample(0.0, scratch).value > 0.0)) continue;
    if (!firstChange(scene.field, 0.0, 1.0, true, ProjectionKind::kNewton, 1e-9, scratch)) continue;
    ++found;
    depths += scratch.soft.halves.size() - 1;
  }
  EXPECT_GT(found, 50);
  const double mean = static_cast<double>(depths) / static_cast<double>(found);
  EXPECT_LT(mean, 8.0) << "of 40 halvings each";
}

TEST(RayField, SampleGivesTheFieldAndItsDerivative) {
  std::mt19937 random(37);
  Scene scene;
  RayScratch scratch;
  for (int round = 0; round < 200; ++round) {
    fill(scene, round % 2 ? 1.0f : 0.0f, round % 4 < 2, random);
    for (double t = 0.01; t < 1.5; t += 0.1) {
      const double numeric =
          (scene.field.sample(t + 1e-6, scratch).value - scene.field.sample(t - 1e-6, scratch).value) / 2e-6;
      const ValueAndSlope here = scene.field.sample(t, scratch);
      const double other =
          (scene.field.sample(t + 1e-6, scratch).slope + scene.field.sample(t - 1e-6, scratch).slope) / 2.0;
      if (std::abs(other - here.slope) > 1e-3) continue;  // another clique takes over here
      EXPECT_NEAR(here.slope, numeric, 1e-3);
    }
  }
}

}  // namespace
}  // namespace sinew
