// tests/rig/reparent_test.cpp: a muscle moved to another bone stays in place.

#include "core/rig/line_edit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include <glm/gtc/matrix_transform.hpp>

namespace sinew {
namespace {

glm::quat randomRotation(std::mt19937& random) {
  std::normal_distribution<float> normal;
  return glm::normalize(glm::quat(normal(random), normal(random), normal(random), normal(random)));
}

glm::mat4 randomBone(std::mt19937& random, float scale) {
  std::uniform_real_distribution<float> place(-2.0f, 2.0f);
  const glm::vec3 offset(place(random), place(random), place(random));
  return glm::scale(glm::translate(glm::mat4(1.0f), offset) * glm::mat4_cast(randomRotation(random)), glm::vec3(scale));
}

Placement randomPlacement(std::mt19937& random) {
  std::uniform_real_distribution<float> place(-1.0f, 1.0f);
  std::uniform_real_distribution<float> radius(0.1f, 1.0f);
  return {{place(random), place(random), place(random)},
          randomRotation(random),
          {radius(random), radius(random), radius(random)}};
}

/// Largest difference of the two ellipsoids' quadrics, which do not depend on order or sign of axes.
float difference(const glm::mat4& a, const glm::mat4& b) {
  const glm::mat3 qa = glm::mat3(a) * glm::transpose(glm::mat3(a));
  const glm::mat3 qb = glm::mat3(b) * glm::transpose(glm::mat3(b));
  float most = glm::length(glm::vec3(a[3]) - glm::vec3(b[3]));
  for (int i = 0; i < 3; ++i) most = std::max(most, glm::length(qa[i] - qb[i]));
  return most;
}

TEST(CarriedToBone, LooksTheSameUnderRotationAndUniformScale) {
  std::mt19937 random(3);
  for (int i = 0; i < 500; ++i) {
    const glm::mat4 from = randomBone(random, i % 2 == 0 ? 1.0f : 3.0f);
    const glm::mat4 to = randomBone(random, i % 3 == 0 ? 1.0f : 0.5f);
    const Placement before = randomPlacement(random);
    const Placement after = carryToBone(before, from, to);
    EXPECT_LT(difference(shapeInWorld(before, 1.0f, from), shapeInWorld(after, 1.0f, to)), 2e-4f);
    EXPECT_NEAR(glm::length(after.rotation), 1.0f, 1e-5f);
  }
}

glm::mat4 sheared(const glm::mat4& bone, std::mt19937& random) {
  std::uniform_real_distribution<float> slant(-0.7f, 0.7f);
  glm::mat4 shear(1.0f);
  shear[1][0] = slant(random);
  shear[2][0] = slant(random);
  shear[2][1] = slant(random);
  return bone * shear;
}

TEST(CarriedToBone, KeepsItsPositionUnderNonuniformScaleAndShear) {
  std::mt19937 random(4);
  const glm::vec3 uneven(1.0f, 2.5f, 0.4f);
  for (int i = 0; i < 500; ++i) {
    glm::mat4 from = randomBone(random, 1.0f);
    glm::mat4 to = randomBone(random, 1.0f);
    if (i % 2 == 0) from = glm::scale(from, uneven);
    if (i % 3 == 0) to = glm::scale(to, 1.0f / uneven);
    if (i % 5 == 0) from = sheared(from, random);
    if (i % 7 == 0) to = sheared(to, random);
    if (i % 11 == 0) to = glm::scale(to, {-1.0f, 1.0f, 1.0f});
    const Placement before = randomPlacement(random);
    const Placement after = carryToBone(before, from, to);
    EXPECT_LT(difference(shapeInWorld(before, 1.0f, from), shapeInWorld(after, 1.0f, to)), 1e-4f) << i;
    EXPECT_NEAR(glm::length(after.rotation), 1.0f, 1e-5f);
    EXPECT_GT(std::min({after.radii.x, after.radii.y, after.radii.z}), 0.0f);
  }
}

TEST(CarriedToBone, FlattenedBoneChangesNothing) {
  std::mt19937 random(5);
  const Placement before = randomPlacement(random);
  const glm::mat4 flat = glm::scale(glm::mat4(1.0f), {1.0f, 0.0f, 1.0f});
  const Placement after = carryToBone(before, randomBone(random, 1.0f), flat);
  EXPECT_EQ(after.center, before.center);
  EXPECT_EQ(after.radii, before.radii);
}

}  // namespace
}  // namespace sinew
