// tests/geometry/shape_test.cpp: shapes match the formulas of docs/design.md, with their bounds and images.
#include "sinew/geometry/shape.h"

#include <cstdio>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/geometry/affine_image.h"
#include "sinew/geometry/ellipsoid.h"
#include "tests/support/oracle/shape.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew {
namespace {

using oracle::Vec;
using test::Random;

constexpr int kShapes = 1000;

Placement randomPlacement(Random& random, float& reach) {
  Placement placement;
  reach = random.uniform(1.05f, 3.0f);
  placement.center = 3.0f * glm::vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  placement.rotation = random.rotation();
  placement.radii = {random.uniform(0.2f, 1.5f), random.uniform(0.2f, 3.0f), random.uniform(0.2f, 1.5f)};
  placement.shape = test::randomShape(random, reach);
  return placement;
}

glm::mat4 randomBone(Random& random) {
  glm::mat4 bone = glm::translate(glm::mat4(1.0f), glm::vec3(random.uniform(-2, 2), 1.0f, random.uniform(-2, 2)));
  bone = bone * glm::mat4_cast(random.rotation());
  return glm::scale(bone, {random.uniform(0.5f, 2.0f), random.uniform(0.5f, 2.0f), random.uniform(0.5f, 2.0f)});
}

/// A point in the muscle's space divided by its radii.
glm::vec3 inRadii(const Placement& placement, const glm::mat4& bone, const glm::vec3& world) {
  return glm::vec3(glm::inverse(glm::dmat4(shapeInWorld(placement, 1.0f, bone))) * glm::dvec4(world, 1.0));
}

TEST(Shape, TableListsEveryMemberOnceInOrder) {
  Shape shape;
  for (std::size_t i = 0; i < kShapeNumbers; ++i) {
    const ShapeNumber& number = shapeNumbers()[i];
    EXPECT_EQ(&number.member(shape), &shapeNumbers()[0].member(shape) + i) << number.name;
    EXPECT_EQ(number.of(Shape{}), 0.0f) << number.name << ": an ellipsoid has none";
    EXPECT_TRUE(number.low <= 0.0f && number.high > 0.0f) << number.name;
    EXPECT_TRUE(std::string(number.name).starts_with(number.key)) << number.name;
  }
  std::size_t listed = 0;
  for (const std::span<const ShapeNumber> key : shapeKeys()) {
    listed += key.size();
    for (const ShapeNumber& number : key) EXPECT_STREQ(number.key, key.front().key);
  }
  EXPECT_EQ(listed, static_cast<std::size_t>(kShapeNumbers)) << "numbers of a key stand side by side";
}

TEST(Shape, MatchesTheDocumentedFormula) {
  Random random(3);
  int inside = 0;
  for (int i = 0; i < kShapes; ++i) {
    float reach = 0.0f;
    const Placement placement = randomPlacement(random, reach);
    const glm::mat4 bone = randomBone(random);
    const UnitBallMap map = unitBallMap(placement, reach, bone);
    for (int k = 0; k < 20; ++k) {
      const glm::vec3 world =
          map.center +
          map.boundingRadius * 0.6f * glm::vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      const double rho = oracle::rho(placement.shape, oracle::vec(inRadii(placement, bone, world)));
      const double r = rho / static_cast<double>(reach);
      if (std::abs(r - 1.0) > 1e-4) {
        EXPECT_EQ(map.holds(world), r < 1.0) << i;
      }
      if (r >= 1.0) continue;
      ++inside;
      EXPECT_NEAR(static_cast<double>(map.rSquared(world)), r * r, 2e-5) << i;
    }
  }
  EXPECT_GT(inside, 1500);
}

TEST(Shape, VisibleRadiiAreExact) {
  Random random(4);
  for (int i = 0; i < kShapes; ++i) {
    Shape shape = test::randomShape(random, random.uniform(1.05f, 3.0f));
    EXPECT_NEAR(oracle::widest(shape, 1.0), 1.0, 3e-5) << shape.core << ' ' << shape.belly;
    EXPECT_NEAR(oracle::rho(shape, {0, 1, 0}), 1.0, 1e-12);
    EXPECT_NEAR(oracle::rho(shape, {0, -1, 0}), 1.0, 1e-12);
    // Without a core the thickest place is at y = belly.
    shape.core = 0.0f;
    shape.belly = std::clamp(shape.belly, -0.5f, 0.5f);
    shape.bend = {};
    const auto p = static_cast<double>(shape.belly);
    EXPECT_NEAR(oracle::rho(shape, {1, p, 0}), 1.0, 1e-6);
    EXPECT_GT(oracle::rho(shape, {1, p + 0.01, 0}), 1.0);
    EXPECT_GT(oracle::rho(shape, {1, p - 0.01, 0}), 1.0);
  }
}

TEST(Shape, BendMovesTheAxisMiddleInUnitsOfRadii) {
  Shape shape;
  shape.bend = {0.5f, -0.25f};
  EXPECT_NEAR(oracle::rho(shape, {1.5, 0, -0.25}), 1.0, 1e-12) << "visible extent sideways: 1 + |bend|";
  EXPECT_NEAR(oracle::rho(shape, {0, 1, 0}), 1.0, 1e-12);
  const glm::vec3 pole = onShape(shape, 1.0f, {1, 0, 0});
  EXPECT_NEAR(pole.x, 1.5f, 1e-6f);
  EXPECT_NEAR(pole.z, -0.25f, 1e-6f);
}

TEST(Shape, SurfacePointsHaveRhoEqualToTheScale) {
  Random random(5);
  for (int i = 0; i < kShapes; ++i) {
    const float reach = random.uniform(1.05f, 3.0f);
    const Shape shape = test::randomShape(random, reach);
    for (const float scale : {1.0f, reach}) {
      const glm::vec3 p = onShape(shape, scale, random.rotation() * glm::vec3(0, 0, 1));
      EXPECT_NEAR(oracle::rho(shape, oracle::vec(p)), static_cast<double>(scale), 2e-4 * static_cast<double>(scale))
          << i;
    }
  }
}

TEST(Shape, BellyLimitKeepsSectionsFinite) {
  Random random(6);
  for (int i = 0; i < 20 * kShapes; ++i) {
    Shape shape;
    shape.core = random.uniform(0.0f, kMostCore);
    const float reach = random.chance(0.2f) ? 1.0f + random.uniform(1e-6f, 1e-3f) : random.uniform(1.0f, 40.0f);
    shape.belly = mostBelly(shape.core, reach);
    const double end =
        static_cast<double>(shape.core) + static_cast<double>(reach) * (1.0 - static_cast<double>(shape.core));
    const auto p = static_cast<double>(shape.belly);
    EXPECT_GT(1.0 - 2.0 * p * end + p * p, 0.0) << shape.core << ", reach " << reach;
    EXPECT_GT(shape.belly, 0.0f);
  }
  EXPECT_NEAR(mostBelly(0.0f, std::sqrt(2.0f)), 0.393f, 1e-3f);
  EXPECT_NEAR(mostBelly(0.0f, 1.2f), 0.51f, 5e-3f);
  EXPECT_NEAR(mostBelly(0.0f, 1.8f), 0.29f, 5e-3f);
  EXPECT_NEAR(mostBelly(0.9f, std::sqrt(2.0f)), 0.71f, 5e-3f);
}

TEST(Shape, LegalShapesAreKeptAndOthersClamped) {
  const Shape wild{3.0f, -7.0f, {std::nanf(""), -2.0f}};
  const Shape legal = legalShape(wild, 1.5f);
  EXPECT_EQ(legal.core, kMostCore);
  EXPECT_EQ(legal.belly, -mostBelly(kMostCore, 1.5f));
  EXPECT_EQ(legal.bend, glm::vec2(0.0f, -1.0f));
  EXPECT_EQ(legalShape(legal, 1.5f), legal);
}

TEST(Shape, VolumeGivesTheMeanRadius) {
  Random random(7);
  for (int i = 0; i < kShapes; ++i) {
    const float reach = random.uniform(1.2f, 3.0f);
    const Shape shape = test::randomShape(random, reach);
    EXPECT_NEAR(static_cast<double>(unitShape(shape, reach).meanRadius), std::cbrt(oracle::volume(shape)), 2e-3) << i;
  }
  EXPECT_NEAR(oracle::volume({0.0f, 0.4f, {}}), 0.9672, 1e-4);
  EXPECT_NEAR(oracle::volume({0.6f, 0.0f, {0.3f, 0.2f}}), (4.0 + 1.2) / 4.0, 1e-4);
}

TEST(Shape, DerivativesMatchDifferencesAndAreContinuous) {
  Random random(8);
  for (int i = 0; i < kShapes; ++i) {
    const float reach = random.uniform(1.1f, 2.5f);
    Shape shape = test::randomShape(random, reach);
    if (shape.isPlain()) shape.core = 0.4f;
    const UnitShape unit = unitShape(shape, reach);
    // Every second point lies at an end of the core.
    const double y =
        i % 2 ? static_cast<double>(unit.core) : static_cast<double>(random.uniform(unit.low.y, unit.high.y));
    const glm::dvec3 p(static_cast<double>(random.uniform(-1, 1)), y, static_cast<double>(random.uniform(-1, 1)));
    if (unit.rSquared(p) >= 0.99) continue;
    const glm::dvec3 slope = unit.rSquaredSlope(p);
    for (int axis = 0; axis < 3; ++axis) {
      for (const double step : {1e-7, -1e-7}) {
        glm::dvec3 moved = p;
        moved[axis] += step;
        EXPECT_NEAR((unit.rSquared(moved) - unit.rSquared(p)) / step, slope[axis], 1e-4 * (1.0 + glm::length(slope)));
      }
    }
  }
}

TEST(Shape, BoundsEncloseItTightly) {
  Random random(9);
  double loosest = 0.0;
  double meanLoose = 0.0;
  for (int i = 0; i < kShapes; ++i) {
    float reach = 0.0f;
    const Placement placement = randomPlacement(random, reach);
    const glm::mat4 bone = randomBone(random);
    const UnitBallMap map = unitBallMap(placement, reach, bone);
    const glm::mat4 shape = shapeInWorld(placement, 1.0f, bone);
    float farthest = 0.0f;
    for (int k = 0; k < 300; ++k) {
      const glm::vec3 p = onShape(placement.shape, reach, random.rotation() * glm::vec3(0, 0, 1));
      farthest = std::max(farthest, glm::distance(glm::vec3(shape * glm::vec4(p, 1.0f)), map.center));
      if (map.isPlain()) continue;
      const glm::vec3 unit = p / reach;
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(unit[axis], map.shape.low[axis] - 1e-5f) << i;
        EXPECT_LE(unit[axis], map.shape.high[axis] + 1e-5f) << i;
      }
    }
    EXPECT_LE(farthest, map.boundingRadius * 1.00001f) << i;
    loosest = std::max(loosest, static_cast<double>(map.boundingRadius / farthest));
    meanLoose += static_cast<double>(map.boundingRadius / farthest) / kShapes;
  }
  std::printf("  bounding radius over the farthest point: mean %.3f, most %.3f\n", meanLoose, loosest);
  EXPECT_LE(loosest, 2.2);
}

TEST(Shape, RotationsAndReflectionsAreExact) {
  Random random(10);
  for (int i = 0; i < kShapes; ++i) {
    float reach = 0.0f;
    const Placement placement = randomPlacement(random, reach);
    AffineMap map;
    map.linear = glm::dmat3(glm::mat3_cast(random.rotation())) * static_cast<double>(random.uniform(0.5f, 2.0f));
    if (i % 2) map.linear[0] = -map.linear[0];
    map.offset = {1.0, -2.0, 0.5};
    const Placement image = imageOf(placement, map);
    EXPECT_EQ(image.shape.core, placement.shape.core);
    const UnitBallMap before = unitBallMap(placement, reach, glm::mat4(1.0f));
    const UnitBallMap after = unitBallMap(image, reach, glm::mat4(1.0f));
    for (int k = 0; k < 10; ++k) {
      const glm::vec3 p =
          before.center +
          before.boundingRadius * 0.5f * glm::vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      if (!before.holds(p)) continue;
      const glm::vec3 moved(map.linear * glm::dvec3(p) + map.offset);
      EXPECT_NEAR(after.rSquared(moved), before.rSquared(p), 2e-4f) << i;
    }
  }
}

TEST(Shape, NonuniformScaleKeepsAxisAndVolume) {
  Random random(11);
  for (int i = 0; i < kShapes; ++i) {
    float reach = 0.0f;
    Placement placement = randomPlacement(random, reach);
    if (placement.shape.isPlain()) placement.shape.core = 0.5f;
    AffineMap map;
    map.linear = glm::dmat3(randomBone(random)) * glm::dmat3(randomBone(random));
    if (i % 2) map.linear[1] = -map.linear[1];
    const Placement image = imageOf(placement, map);
    const glm::dvec3 axis =
        map.linear * glm::dmat3(glm::mat3_cast(placement.rotation))[1] * static_cast<double>(placement.radii.y);
    const glm::dvec3 own = glm::dmat3(glm::mat3_cast(image.rotation))[1] * static_cast<double>(image.radii.y);
    const double turned = glm::dot(axis, own) < 0.0 ? -1.0 : 1.0;
    EXPECT_LT(glm::length(axis - turned * own), 1e-4 * glm::length(axis)) << i;
    EXPECT_NEAR(static_cast<double>(image.shape.belly), turned * static_cast<double>(placement.shape.belly), 1e-6);
    const auto size = [](const Placement& p) { return static_cast<double>(p.radii.x * p.radii.y * p.radii.z); };
    EXPECT_NEAR(size(image) / (size(placement) * std::abs(glm::determinant(map.linear))), 1.0, 1e-3) << i;
  }
}

TEST(Shape, DefaultShapeIsTheEllipsoidBitForBit) {
  Random random(12);
  for (int i = 0; i < kShapes; ++i) {
    float reach = 0.0f;
    Placement placement = randomPlacement(random, reach);
    placement.shape = {};
    const UnitBallMap map = unitBallMap(placement, reach, randomBone(random));
    EXPECT_TRUE(map.isPlain());
    const glm::vec3 p = map.center + glm::vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const glm::vec3 y = map.toUnit * (p - map.center);
    EXPECT_EQ(map.rSquared(p), glm::dot(y, y));
    EXPECT_EQ(map.rSquaredSlope(p), 2.0f * (glm::transpose(map.toUnit) * y));
  }
}

}  // namespace
}  // namespace sinew
