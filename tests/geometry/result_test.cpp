// tests/geometry/result_test.cpp: error texts, and the helpers of sinew/geometry/geometry.h.
#include "sinew/geometry/result.h"

#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "sinew/geometry/geometry.h"

namespace sinew {
namespace {

TEST(Error, TextIsOneLineWithoutEmptyParts) {
  EXPECT_EQ((Error{"a.glb", "accessors[2]", "expected\nfloats"}.text()), "a.glb: accessors[2]: expected floats");
  EXPECT_EQ(errorAt("", "no mesh").text(), "no mesh");
}

TEST(Error, PlainTextNamesTheSubjectInsteadOfThePlace) {
  const Error error{"/home/ann/arm.rig.json", "primitives[2].reach", "expected a number > 1, got 0",
                    "muscle \"biceps L\", reach"};
  EXPECT_EQ(error.plainText(), "arm.rig.json: muscle \"biceps L\", reach: expected a number > 1, got 0");
  EXPECT_EQ(error.text(), "/home/ann/arm.rig.json: primitives[2].reach: expected a number > 1, got 0");
  EXPECT_EQ(errorAt("groups[0]", "is empty", "group 1").plainText(), "Group 1: is empty");
  EXPECT_EQ(errorAt("groups[0]", "is empty").plainText(), "groups[0]: is empty") << "without a subject all is shown";
  EXPECT_EQ(errorAt("", "two\nlines", "x").plainText(), "X: two lines");
  EXPECT_EQ(about("a muscle", errorAt("", "r", "reach")).subject, "a muscle, reach");
  EXPECT_EQ(about("a muscle", errorAt("", "r")).subject, "a muscle");
}

TEST(Result, HoldsValueOrError) {
  const Result<int> good = 3;
  const Result<int> bad = errorAt("x", "y");
  ASSERT_TRUE(good.ok());
  EXPECT_EQ(good.value(), 3);
  ASSERT_FALSE(bad.ok());
  EXPECT_EQ(bad.error().reason, "y");
}

TEST(Geometry, NormalMatrixKeepsNormalsPerpendicularAndOutward) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> entry(-1.0f, 1.0f);
  for (int round = 0; round < 1000; ++round) {
    glm::mat3 m;
    for (int c = 0; c < 3; ++c) m[c] = {entry(random), entry(random), entry(random)};
    if (std::abs(glm::determinant(m)) < 0.05f) continue;
    const glm::vec3 a(entry(random), entry(random), entry(random));
    const glm::vec3 b(entry(random), entry(random), entry(random));
    const glm::vec3 n = glm::cross(a, b);
    const glm::vec3 carried = normalMatrix(m) * n;
    EXPECT_NEAR(glm::dot(carried, m * a), 0.0f, 1e-4f);
    EXPECT_NEAR(glm::dot(carried, m * b), 0.0f, 1e-4f);
    EXPECT_GT(glm::dot(carried, m * n), 0.0f) << "outward stays outward, mirrored or not";
  }
}

TEST(Geometry, NormalizeOrSurvivesExtremes) {
  EXPECT_EQ(normalizeOr(glm::vec3(0.0f), {0, 1, 0}), glm::vec3(0, 1, 0));
  EXPECT_NEAR(glm::length(normalizeOr(glm::vec3(1e30f, 1e30f, 0.0f), {0, 1, 0})), 1.0f, 1e-6f);
  EXPECT_NEAR(glm::length(normalizeOr(glm::vec3(1e-30f, 0.0f, 1e-30f), {0, 1, 0})), 1.0f, 1e-6f);
  EXPECT_EQ(normalizeOr(glm::vec3(std::numeric_limits<float>::quiet_NaN(), 0, 0), {0, 1, 0}), glm::vec3(0, 1, 0));
}

}  // namespace
}  // namespace sinew
