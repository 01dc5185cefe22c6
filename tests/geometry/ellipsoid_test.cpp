// tests/geometry/ellipsoid_test.cpp: properties of the potential and the unit-ball map.
#include "sinew/geometry/ellipsoid.h"

#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/geometry/potential.h"

namespace sinew {
namespace {

TEST(Potential, HasTheDefinedValuesAndDerivative) {
  EXPECT_EQ(potential(0.0f), 1.0f);
  EXPECT_EQ(potential(1.0f), 0.0f);
  EXPECT_EQ(potential(4.0f), 0.0f);
  for (float q = 0.0f; q < 1.2f; q += 0.01f) {
    const float numeric =
        (potential(q + 1e-3f) - potential(std::max(q - 1e-3f, 0.0f))) / (q < 1e-3f ? 1e-3f + q : 2e-3f);
    EXPECT_NEAR(potentialSlope(q), numeric, 5e-3f) << q;
  }
}

TEST(Potential, StrengthPutsTheIsoValueOnTheVisibleSurface) {
  for (const float iso : {0.05f, 0.25f, 0.9f}) {
    const auto radius = static_cast<float>(isoRadius(static_cast<double>(iso)));
    EXPECT_NEAR(potential(radius * radius), iso, 1e-6f);
    for (const float reach : {1.05f, 1.4142135f, 3.0f}) {
      EXPECT_NEAR(strengthFor(iso, reach) * potential(1.0f / (reach * reach)), iso, 1e-5f);
    }
  }
  EXPECT_NEAR(strengthFor(0.25f, std::sqrt(2.0f)), 1.0f, 1e-5f) << "docs/design.md: default reach, default iso";
}

TEST(UnitBallMap, MapsTheInfluenceSurfaceToTheUnitSphere) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  for (int round = 0; round < 500; ++round) {
    Placement placement;
    placement.center = 50.0f * glm::vec3(unit(random), unit(random), unit(random));
    placement.rotation = glm::normalize(glm::quat(unit(random), unit(random), unit(random), 1.1f));
    placement.radii = glm::vec3(1.5f) + glm::vec3(unit(random), unit(random), unit(random));
    glm::mat4 bone = glm::translate(glm::mat4(1.0f), 20.0f * glm::vec3(unit(random), unit(random), unit(random)));
    bone = glm::scale(glm::rotate(bone, 3.0f * unit(random), glm::vec3(1, 2, 3)),
                      {0.1f, 2.0f, 1.0f + unit(random) * 0.9f});
    const UnitBallMap map = unitBallMap(placement, 1.7f, bone);
    const glm::mat4 shape = shapeInWorld(placement, 1.7f, bone);
    for (int i = 0; i < 10; ++i) {
      const glm::vec3 onBall = glm::normalize(glm::vec3(unit(random), unit(random), unit(random) + 1e-3f));
      const glm::vec3 inWorld(shape * glm::vec4(onBall, 1.0f));
      EXPECT_NEAR(glm::length(map.toUnit * (inWorld - map.center)), 1.0f, 1e-3f);
      EXPECT_LE(glm::distance(inWorld, map.center), map.boundingRadius * 1.0001f);
    }
  }
}

TEST(UnitBallMap, DerivativesAndRaysMatchItsValues) {
  std::mt19937 random(12);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  for (int round = 0; round < 500; ++round) {
    Placement placement;
    placement.center = {unit(random), unit(random), unit(random)};
    placement.rotation = glm::normalize(glm::quat(unit(random), unit(random), unit(random), 1.1f));
    placement.radii = glm::vec3(0.9f);
    if (round % 2 == 0) placement.radii += 0.4f * glm::vec3(unit(random), unit(random), unit(random));
    const UnitBallMap map = unitBallMap(placement, 1.5f, glm::mat4(1.0f));
    ASSERT_EQ(map.inverseRadius > 0.0f, round % 2 == 1) << "spheres and ellipsoids in turn";
    const glm::vec3 origin(unit(random), unit(random), unit(random));
    const glm::vec3 direction = glm::normalize(glm::vec3(unit(random), unit(random), 1.5f + unit(random)));
    const RayQuadratic ray = map.alongRay(origin, direction);
    for (const double t : {-1.0, 0.0, 0.3, 2.0}) {
      const glm::vec3 point = origin + static_cast<float>(t) * direction;
      const double rSquared = (ray.a * t + 2.0 * ray.b) * t + ray.c;
      EXPECT_NEAR(static_cast<double>(map.rSquared(point)), rSquared, 1e-5 * (1.0 + rSquared)) << round;
      const double slope = 2.0 * (ray.a * t + ray.b);
      EXPECT_NEAR(static_cast<double>(glm::dot(map.rSquaredSlope(point), direction)), slope,
                  1e-5 * (1.0 + std::abs(slope)))
          << round;
    }
  }
}

TEST(UnitBallMap, FlattenedBoneHasNoReach) {
  const glm::mat4 flat = glm::scale(glm::mat4(1.0f), {1.0f, 0.0f, 1.0f});
  EXPECT_EQ(unitBallMap({}, 2.0f, flat).boundingRadius, 0.0f);
}

TEST(UnitBallMap, SphereStaysASphereUnderRotationAndUniformScale) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  for (int round = 0; round < 300; ++round) {
    Placement ball;
    ball.center = glm::vec3(unit(random), unit(random), unit(random));
    ball.rotation = glm::normalize(glm::quat(unit(random), unit(random), unit(random), 1.1f));
    ball.radii = glm::vec3(0.3f + 0.2f * unit(random));
    Placement nearly = ball;
    nearly.radii.y *= 1.0001f;  // barely an ellipsoid
    const glm::vec3 axis = glm::normalize(glm::vec3(unit(random), unit(random), 1.2f));
    glm::mat4 bone = glm::translate(glm::mat4(1.0f), 5.0f * glm::vec3(unit(random), unit(random), unit(random)));
    bone = glm::scale(glm::rotate(bone, 3.0f * unit(random), axis), glm::vec3(1.0f + 0.9f * unit(random)));
    const UnitBallMap sphere = unitBallMap(ball, 1.4f, bone);
    const UnitBallMap ellipsoid = unitBallMap(nearly, 1.4f, bone);
    ASSERT_GT(sphere.inverseRadius, 0.0f) << round;
    ASSERT_EQ(ellipsoid.inverseRadius, 0.0f) << round;
    for (int i = 0; i < 10; ++i) {
      const glm::vec3 point = sphere.center + 0.8f * glm::vec3(unit(random), unit(random), unit(random));
      EXPECT_NEAR(sphere.rSquared(point), ellipsoid.rSquared(point), 1e-3f * (1.0f + sphere.rSquared(point)));
      const glm::vec3 y = sphere.toUnit * (point - sphere.center);
      EXPECT_FLOAT_EQ(sphere.rSquared(point), glm::dot(y, y));
    }
    const glm::mat4 uneven = glm::scale(bone, {1.0f, 1.01f, 1.0f});
    EXPECT_EQ(unitBallMap(ball, 1.4f, uneven).inverseRadius, 0.0f) << "an uneven bone makes an ellipsoid of it";
  }
}

}  // namespace
}  // namespace sinew
