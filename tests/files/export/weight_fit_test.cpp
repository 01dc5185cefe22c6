// tests/files/export/weight_fit_test.cpp: weights that produced a motion are recovered; the fit never increases the
// error.
#include "core/files/fit/weight_fit.h"

#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace sinew::exporting {
namespace {

constexpr int kBindings = 7;

std::vector<glm::dmat4> randomMatrices(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<glm::dmat4> matrices;
  for (int b = 0; b < kBindings; ++b) {
    const glm::dvec3 way(unit(random), unit(random), unit(random));
    const glm::dvec3 axis = glm::normalize(glm::dvec3(unit(random), unit(random), unit(random) + 2.0));
    matrices.push_back(glm::rotate(glm::translate(glm::dmat4(1.0), 0.2 * way), unit(random), axis));
  }
  return matrices;
}

FourWeights randomWeights(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.05, 1.0);
  std::vector<Share> shares;
  for (int b = 0; b < kBindings; ++b) shares.push_back({b, unit(random)});
  std::ranges::shuffle(shares, random);
  shares.resize(3);
  return fourLargest(std::move(shares));
}

struct Movement {
  std::vector<glm::vec3> rest;
  std::vector<FourWeights> truth;
  std::vector<std::vector<glm::dmat4>> poses;
};

Movement randomMovement(std::mt19937& random) {
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  Movement movement;
  for (int v = 0; v < 40; ++v) {
    movement.rest.emplace_back(unit(random), unit(random), unit(random));
    movement.truth.push_back(randomWeights(random));
  }
  for (int p = 0; p < 12; ++p) movement.poses.push_back(randomMatrices(random));
  return movement;
}

std::vector<glm::vec3> liveIn(const Movement& movement, const std::vector<glm::dmat4>& matrices, float bulge,
                              std::mt19937& random) {
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  std::vector<glm::vec3> live;
  for (std::size_t v = 0; v < movement.rest.size(); ++v) {
    const glm::vec3 off(unit(random), unit(random), unit(random));
    live.push_back(glm::vec3(skinPoint(matrices, movement.truth[v], glm::dvec3(movement.rest[v]))) + bulge * off);
  }
  return live;
}

const std::vector<std::vector<int>> kAll(40, {0, 1, 2, 3, 4, 5, 6});
const std::vector<FourWeights> kFirst(40, FourWeights{{0, -1, -1, -1}, {1.0f}});

TEST(WeightFit, RecoversTheWeightsOfAMovement) {
  std::mt19937 random(1);
  const Movement movement = randomMovement(random);
  WeightFit fit(movement.rest, kAll, kFirst);
  for (const auto& pose : movement.poses) fit.add(pose, liveIn(movement, pose, 0.0f, random), false);
  const std::vector<FourWeights> found = fit.solve({}, 1.0, 1e-6, StageProgress({}));
  for (std::size_t v = 0; v < found.size(); ++v) {
    for (const auto& pose : movement.poses) {
      const glm::dvec3 rest(movement.rest[v]);
      EXPECT_LT(glm::distance(skinPoint(pose, found[v], rest), skinPoint(pose, movement.truth[v], rest)), 2e-3);
    }
  }
}

TEST(WeightFit, NeverIncreasesAVertexsError) {
  std::mt19937 random(2);
  const Movement movement = randomMovement(random);
  // Starts with optimal weights up to noise, and with a pull from neighbors that differ.
  std::vector<std::array<int, 3>> triangles;
  for (int v = 0; v + 2 < 40; ++v) triangles.push_back({v, v + 1, v + 2});
  for (const float bulge : {0.0f, 0.01f, 0.3f}) {
    for (const auto& start : {kFirst, movement.truth}) {
      WeightFit fit(movement.rest, kAll, start);
      std::vector<std::vector<glm::vec3>> live;
      for (std::size_t p = 0; p < movement.poses.size(); ++p) {
        live.push_back(liveIn(movement, movement.poses[p], bulge, random));
        fit.add(movement.poses[p], live.back(), p % 3 == 0);
      }
      const std::vector<FourWeights> found = fit.solve(triangles, 0.1, 1e-6, StageProgress({}));
      const auto squares = [&](const FourWeights& weights, std::size_t v) {
        double sum = 0.0;
        for (std::size_t p = 0; p < live.size(); ++p) {
          const glm::dvec3 off =
              skinPoint(movement.poses[p], weights, glm::dvec3(movement.rest[v])) - glm::dvec3(live[p][v]);
          sum += glm::dot(off, off);
        }
        return sum;
      };
      for (std::size_t v = 0; v < found.size(); ++v) {
        const double before = squares(start[v], v);
        EXPECT_LE(squares(found[v], v), before + 1e-5 * before + 1e-9);
      }
    }
  }
}

TEST(WeightFit, GoodWeightsAreUnchangedBitForBit) {
  std::mt19937 random(3);
  const Movement movement = randomMovement(random);
  WeightFit fit(movement.rest, kAll, movement.truth);
  for (const auto& pose : movement.poses) fit.add(pose, liveIn(movement, pose, 0.0f, random), false);
  EXPECT_EQ(fit.solve({}, 1.0, 1e-5, StageProgress({})), movement.truth);
}

TEST(FourLargest, KeepsTheLargestAndSumsToOne) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int trial = 0; trial < 1000; ++trial) {
    std::vector<Share> shares;
    for (int b = 0; b < 1 + trial % 9; ++b) shares.push_back({b, unit(random)});
    std::vector<Share> sorted = shares;
    std::ranges::sort(sorted, std::ranges::greater{}, &Share::weight);
    const FourWeights four = fourLargest(shares);
    double sum = 0.0;
    for (std::size_t i = 0; i < kMostWeights; ++i) {
      EXPECT_GE(four.weight[i], 0.0f);
      sum += static_cast<double>(four.weight[i]);
      EXPECT_EQ(four.binding[i], i < sorted.size() ? sorted[i].binding : -1);
    }
    EXPECT_NEAR(sum, 1.0, 1e-6);
  }
}

}  // namespace
}  // namespace sinew::exporting
