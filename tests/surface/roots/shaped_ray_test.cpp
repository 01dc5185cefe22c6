// tests/surface/roots/shaped_ray_test.cpp: shaped muscles along rays: intervals, polynomials, smoothness, first roots.

#include "core/surface/roots/shaped_ray.h"

#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/geometry/potential.h"
#include "core/surface/roots/isolation.h"
#include "core/surface/roots/ray_field.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/marched_rays.h"

namespace sinew {
namespace {

using test::Random;

/// SINEW_SHAPED_RAYS overrides the number.
int raysWanted(int usual) {
  const char* asked = std::getenv("SINEW_SHAPED_RAYS");
  return asked ? std::atoi(asked) : usual;
}

glm::vec3 anyPoint(Random& random) { return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}; }

PosedPrimitive anyShaped(Random& random) {
  Placement placement;
  const float reach = random.uniform(1.1f, 2.2f);
  placement.center = 0.6f * anyPoint(random);
  placement.rotation = random.rotation();
  placement.radii = {random.uniform(0.1f, 0.4f), random.uniform(0.2f, 0.6f), random.uniform(0.1f, 0.4f)};
  placement.shape = test::randomShape(random, reach);
  const float sign = random.chance(0.15f) ? -1.0f : 1.0f;
  return {unitBallMap(placement, reach, glm::mat4(1.0f)), sign * strengthFor(0.25f, reach)};
}

PosedPrimitive anyUnplain(Random& random) {
  for (;;) {
    const PosedPrimitive made = anyShaped(random);
    if (!made.influence.isPlain()) return made;
  }
}

ShapedRay anyRay(Random& random, const PosedPrimitive& primitive) {
  const glm::vec3 origin = 1.2f * anyPoint(random);
  const glm::vec3 aim = primitive.influence.center + 0.4f * anyPoint(random);
  glm::vec3 direction = glm::normalize(aim - origin);
  if (random.chance(0.05f)) direction = glm::vec3(0, 1, 0);
  return {primitive.influence, origin, direction};
}

TEST(ShapedRay, IntervalsAreInsideTheInfluence) {
  Random random(21);
  int twice = 0;
  int checked = 0;
  for (int i = 0; i < raysWanted(4000); ++i) {
    const ShapedRay ray = anyRay(random, anyUnplain(random));
    const ShapedStretches stretches = ray.stretches();
    int apart = 0;
    double last = 0.0;
    for (const ShapedStretch& stretch : stretches.items()) {
      EXPECT_GE(stretch.enter, last);
      EXPECT_LT(stretch.enter, stretch.leave);
      apart += stretch.goesOn ? 0 : 1;
      last = stretch.leave;
    }
    twice += apart > 1 ? 1 : 0;
    for (int k = 0; k < 40; ++k) {
      const auto t = static_cast<double>(random.uniform(0.0f, 3.0f));
      const double rSquared = ray.shape.rSquared(ray.at(t));
      if (std::abs(rSquared - 1.0) < 1e-7) continue;
      int holders = 0;
      for (const ShapedStretch& s : stretches.items()) holders += t >= s.enter && t <= s.leave ? 1 : 0;
      EXPECT_EQ(holders, rSquared < 1.0 ? 1 : 0) << i << ", t " << t << ", r^2 " << rSquared;
      ++checked;
    }
  }
  EXPECT_GT(checked, 1000);
  EXPECT_GT(twice, 0) << "a bent influence can be entered twice";
}

TEST(ShapedRay, PolynomialsEqualRSquared) {
  Random random(22);
  for (int i = 0; i < raysWanted(2000); ++i) {
    const ShapedRay ray = anyRay(random, anyUnplain(random));
    const ShapedStretches stretches = ray.stretches();
    for (const ShapedStretch& stretch : stretches.items()) {
      const Bernstein w = ray.insideness(stretch.enter, stretch.leave);
      for (const double u : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        const double t = stretch.enter + u * (stretch.leave - stretch.enter);
        EXPECT_NEAR(w.at(u), 1.0 - ray.shape.rSquared(ray.at(t)), 1e-9);
        if (ray.isQuadratic()) {
          const auto [a, b, c] = ray.quadraticAround(0.5 * (stretch.enter + stretch.leave));
          EXPECT_NEAR((a * t + 2.0 * b) * t + c, ray.shape.rSquared(ray.at(t)), 1e-9);
        }
      }
      const std::size_t bends = ray.shape.curve == glm::vec2(0.0f) ? 0 : 2;
      EXPECT_LE(w.degree, 2 + bends + (ray.shape.taper == 0.0f ? 0 : 1));
    }
  }
}

TEST(ShapedRay, FieldIsContinuouslyDifferentiableWherePartsMeet) {
  Random random(23);
  RayScratch scratch;
  const CliqueLevels oneSum;
  RayField field;
  int meets = 0;
  for (int i = 0; i < raysWanted(10000); ++i) {
    const PosedPrimitive primitive = anyUnplain(random);
    const glm::vec3 origin = 1.2f * anyPoint(random);
    const glm::vec3 direction = glm::normalize(primitive.influence.center + 0.3f * anyPoint(random) - origin);
    field.reset(0.25, oneSum);
    field.addPrimitive(primitive, 1.0f, 0, origin, direction);
    for (const RayTerm& term : field.terms()) {
      for (const double t : {term.enter, term.leave}) {
        if (t <= 0.0) continue;
        const ValueAndSlope before = field.sample(t - 1e-10, scratch);
        const ValueAndSlope here = field.sample(t, scratch);
        const ValueAndSlope after = field.sample(t + 1e-10, scratch);
        const double scale = 1.0 + std::abs(here.slope);
        EXPECT_NEAR(before.value, after.value, 1e-6 * scale) << i;
        EXPECT_NEAR(here.value, after.value, 1e-6 * scale) << "two parts own one place, " << i;
        EXPECT_NEAR(before.slope, after.slope, 1e-5 * scale * scale) << i;
        ++meets;
      }
    }
  }
  EXPECT_GT(meets, 100);
}

TEST(ShapedRay, SamplesMatchTheFieldInSpace) {
  Random random(24);
  RayScratch scratch;
  const CliqueLevels oneSum;
  RayField field;
  for (int i = 0; i < raysWanted(500); ++i) {
    std::vector<PosedPrimitive> primitives;
    std::vector<Candidate> candidates;
    const glm::vec3 origin = anyPoint(random);
    const glm::vec3 direction = glm::normalize(anyPoint(random) - 0.5f * origin);
    field.reset(0.25, oneSum);
    for (int k = 0; k < 8; ++k) {
      primitives.push_back(anyShaped(random));
      candidates.push_back({k, 0.9f, 0});
      field.addPrimitive(primitives.back(), 0.9f, 0, origin, direction);
    }
    for (double t = 0.01; t < 2.0; t += 0.2) {
      const glm::vec3 p = origin + static_cast<float>(t) * direction;
      const FieldSample inSpace = sampleField(primitives, candidates, oneSum, p);
      const ValueAndSlope onRay = field.sample(t, scratch);
      EXPECT_NEAR(onRay.value + 0.25, static_cast<double>(inSpace.value), 2e-4);
      const auto slope = static_cast<double>(glm::dot(inSpace.gradient, direction));
      EXPECT_NEAR(onRay.slope, slope, 2e-3 * (1.0 + std::abs(slope)));
    }
  }
}

TEST(ShapedRay, AllMethodsMatchMarching) {
  Random random(25);
  RayScratch scratch;
  RayField field;
  const std::array methods{ProjectionKind::kNewton, ProjectionKind::kAnalytic, ProjectionKind::kBisection};
  std::array<int, 3> wrong{};
  const int rays = raysWanted(1500);
  int roots = 0;
  for (int i = 0; i < rays; ++i) {
    const CliqueLevels levels = random.chance(0.5f) ? CliqueLevels{} : CliqueLevels{{1.0, {{0, 1}, {1, 2}, {3}}}};
    field.reset(0.25, levels);
    const glm::vec3 origin = anyPoint(random);
    const glm::vec3 direction = glm::normalize(0.5f * anyPoint(random) - origin);
    for (int k = 0; k < 8; ++k) field.addPrimitive(anyShaped(random), 0.9f, k % 4, origin, direction);
    const std::optional<double> expected = test::firstChangeByMarching(field, 3.0, 6000);
    roots += expected ? 1 : 0;
    const bool positive = field.sample(0.0, scratch).value > 0.0;
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const std::optional<double> found = firstChange(field, 0.0, 3.0, positive, methods[m], 1e-9, scratch);
      const bool same = found.has_value() == expected.has_value() && (!found || std::abs(*found - *expected) < 1e-4);
      wrong[m] += same ? 0 : 1;
    }
  }
  std::printf("  %d rays, %d roots; off by more than 1e-4: newton %d, analytic %d, bisection %d\n", rays, roots,
              wrong[0], wrong[1], wrong[2]);
  EXPECT_GT(roots, rays / 3);
  for (const int count : wrong) EXPECT_LE(count, 1 + rays / 1000) << "a touch may differ";
}

TEST(Bernstein, ProductsSumsAndPartsMatchTheirValues) {
  Random random(26);
  const auto any = [&](std::size_t degree) {
    Bernstein q;
    q.degree = degree;
    for (std::size_t i = 0; i <= degree; ++i) q.b[i] = static_cast<double>(random.uniform(-1, 1));
    return q;
  };
  for (int i = 0; i < 300; ++i) {
    const Bernstein x = any(static_cast<std::size_t>(1 + random.below(5)));
    const Bernstein y = any(static_cast<std::size_t>(1 + random.below(5)));
    const Bernstein product = x * y;
    Bernstein sum = x;
    sum.addScaled(y, -0.7);
    Bernstein left, right;
    product.split(0.3, left, right);
    for (const double u : {0.0, 0.15, 0.5, 0.77, 1.0}) {
      EXPECT_NEAR(product.at(u), x.at(u) * y.at(u), 1e-12);
      EXPECT_NEAR(sum.at(u), x.at(u) - 0.7 * y.at(u), 1e-12);
      EXPECT_NEAR(left.at(u), product.at(0.3 * u), 1e-12);
      EXPECT_NEAR(right.at(u), product.at(0.3 + 0.7 * u), 1e-12);
      const ValueAndSlope here = Bernstein::Evaluator(product)(u);
      EXPECT_NEAR(here.value, product.at(u), 1e-12);
      EXPECT_NEAR(here.slope, (product.at(u + 1e-6) - product.at(u - 1e-6)) / 2e-6, 1e-6);
    }
  }
}

TEST(Bernstein, EverySignChangeIsFound) {
  Random random(27);
  for (int i = 0; i < 500; ++i) {
    Bernstein q;
    q.degree = 5;
    for (double& value : q.b) value = static_cast<double>(random.uniform(-1, 1));
    isolation::Roots roots;
    isolation::allRoots(q, 0.0, 1.0, 1e-12, roots);
    int changes = 0;
    for (int k = 0; k < 2000; ++k) changes += (q.at(k / 2000.0) > 0.0) != (q.at((k + 1) / 2000.0) > 0.0) ? 1 : 0;
    EXPECT_GE(static_cast<int>(roots.count), changes);
    EXPECT_LE(static_cast<int>(roots.count), changes + 2) << "two within a step of each other";
    for (std::size_t k = 0; k < roots.count; ++k) EXPECT_NEAR(q.at(roots.at[k]), 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace sinew
