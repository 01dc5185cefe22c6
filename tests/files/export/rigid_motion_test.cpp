// tests/files/export/rigid_motion_test.cpp: a known motion is recovered, with and without noise; matrices are
// decomposed into translation, rotation and scale.

#include "core/files/fit/helper_motion.h"

#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace sinew::exporting {
namespace {

using Random = std::mt19937;

glm::dvec3 randomPoint(Random& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  return {unit(random), unit(random), unit(random)};
}

glm::dquat randomTurn(Random& random) {
  std::normal_distribution<double> normal;
  return glm::normalize(glm::dquat(normal(random), normal(random), normal(random), normal(random)));
}

struct Pair {
  glm::dvec3 from;
  glm::dvec3 to;
  double weight;
};

double costOf(const std::vector<Pair>& pairs, const glm::dquat& turn, const glm::dvec3& way) {
  double cost = 0.0;
  for (const Pair& pair : pairs) {
    const glm::dvec3 off = turn * pair.from + way - pair.to;
    cost += pair.weight * glm::dot(off, off);
  }
  return cost;
}

TEST(RigidMotion, RecoversAMotion) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const glm::dquat turn = randomTurn(random);
    const glm::dvec3 way = 3.0 * randomPoint(random);
    RigidMotion motion;
    for (int k = 0; k < 4; ++k) {
      const glm::dvec3 from = randomPoint(random);
      motion.add(from, turn * from + way, 0.1 + std::abs(randomPoint(random).x));
    }
    const RigidMotion::Motion found = motion.best();
    EXPECT_NEAR(std::abs(glm::dot(found.rotation, turn)), 1.0, 1e-12);
    EXPECT_LT(glm::distance(found.translation, way), 1e-7);
  }
}

TEST(RigidMotion, IsALocalMinimumWithoutReflection) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    std::vector<Pair> pairs;
    RigidMotion motion;
    for (int k = 0; k < 12; ++k) {
      pairs.push_back({randomPoint(random), randomPoint(random), 0.1 + std::abs(randomPoint(random).x)});
      motion.add(pairs.back().from, pairs.back().to, pairs.back().weight);
    }
    const RigidMotion::Motion best = motion.best();
    EXPECT_NEAR(glm::length(best.rotation), 1.0, 1e-12);
    const double least = costOf(pairs, best.rotation, best.translation);
    for (int k = 0; k < 50; ++k) {
      const double size = k % 2 == 0 ? 1e-3 : 1.0;
      const glm::dvec3 axis = size * randomPoint(random);
      const glm::dquat turn = glm::normalize(best.rotation + glm::dquat(0.0, axis) * best.rotation);
      EXPECT_GE(costOf(pairs, turn, best.translation + size * randomPoint(random)), least * (1.0 - 1e-12));
    }
  }
}

TEST(RigidMotion, IsIdentityWithoutPoints) {
  const RigidMotion::Motion none = RigidMotion().best();
  EXPECT_EQ(none.rotation, glm::dquat(1.0, 0.0, 0.0, 0.0));
  EXPECT_EQ(none.translation, glm::dvec3(0.0));
  RigidMotion one;
  one.add(glm::dvec3(1.0, 2.0, 3.0), glm::dvec3(2.0, 2.0, 3.0), 1.0);
  const RigidMotion::Motion found = one.best();
  EXPECT_LT(glm::distance(found.rotation * glm::dvec3(1.0, 2.0, 3.0) + found.translation, glm::dvec3(2.0, 2.0, 3.0)),
            1e-12);
}

TEST(Trs, IsRecoveredFromItsMatrix) {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    Trs trs{randomPoint(random), randomTurn(random), glm::abs(randomPoint(random)) + 0.1};
    const Trs again = trsOf(trs.toMatrix());
    EXPECT_NEAR(std::abs(glm::dot(again.rotation, trs.rotation)), 1.0, 1e-12);
    EXPECT_LT(glm::distance(again.scale, trs.scale), 1e-12);
    EXPECT_EQ(again.translation, trs.translation);
    const glm::dvec3 point = randomPoint(random);
    const glm::dvec3 moved = trs.translation + trs.rotation * (trs.scale * point);
    EXPECT_LT(glm::distance(glm::dvec3(trs.toMatrix() * glm::dvec4(point, 1.0)), moved), 1e-12);
    EXPECT_LT(glm::distance(roundToFloats(trs).scale, trs.scale), 1e-6);
    EXPECT_EQ(roundToFloats(trs).scale, roundToFloats(roundToFloats(trs)).scale);
  }
  EXPECT_EQ(trsOf(glm::dmat4(0.0)).scale, glm::dvec3(0.0));
}

}  // namespace
}  // namespace sinew::exporting
