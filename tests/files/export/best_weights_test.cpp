// tests/files/export/best_weights_test.cpp: no other valid weights are better.

#include "core/files/fit/weight_fit.h"

#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace sinew::exporting {
namespace {

struct Problem {
  std::vector<std::vector<glm::dvec3>> ways;  // [candidates][poses] offset of each candidate from the target
  Gram gram{};
};

Problem randomProblem(std::mt19937& random, std::size_t candidates, std::size_t poses) {
  std::normal_distribution<double> normal;
  Problem problem;
  problem.ways.resize(candidates);
  for (auto& ways : problem.ways) {
    for (std::size_t p = 0; p < poses; ++p) ways.emplace_back(normal(random), normal(random), normal(random));
  }
  for (std::size_t i = 0; i < candidates; ++i) {
    for (std::size_t k = 0; k < candidates; ++k) {
      for (std::size_t p = 0; p < poses; ++p) problem.gram[i][k] += glm::dot(problem.ways[i][p], problem.ways[k][p]);
    }
  }
  return problem;
}

double squaredDistances(const Problem& problem, const CandidateWeights& weights) {
  double sum = 0.0;
  for (std::size_t p = 0; p < problem.ways.front().size(); ++p) {
    glm::dvec3 way(0.0);
    for (std::size_t i = 0; i < problem.ways.size(); ++i) way += weights[i] * problem.ways[i][p];
    sum += glm::dot(way, way);
  }
  return sum;
}

double costOf(const Problem& problem, const CandidateWeights& weights, double mu, const CandidateWeights& near) {
  double cost = squaredDistances(problem, weights);
  for (std::size_t i = 0; i < problem.ways.size(); ++i) cost += mu * (weights[i] - near[i]) * (weights[i] - near[i]);
  return cost;
}

/// At most four candidates, uniform over their simplex.
CandidateWeights randomWeights(std::mt19937& random, std::size_t candidates) {
  std::uniform_int_distribution<std::size_t> any(0, candidates - 1);
  std::exponential_distribution<double> share;
  CandidateWeights weights{};
  double sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    const double more = share(random);
    weights[any(random)] += more;
    sum += more;
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

TEST(BestWeights, AreValidAndBetterThanRandomWeights) {
  std::mt19937 random(7);
  for (std::size_t candidates = 1; candidates <= kMostCandidates; ++candidates) {
    const Problem problem = randomProblem(random, candidates, 5);
    const CandidateWeights near = randomWeights(random, candidates);
    for (const double mu : {1e-9, 1e-2, 10.0}) {
      const CandidateWeights best = bestWeights(problem.gram, candidates, mu, near);
      double sum = 0.0;
      int used = 0;
      for (const double weight : best) {
        EXPECT_GE(weight, 0.0);
        sum += weight;
        used += weight > 0.0 ? 1 : 0;
      }
      EXPECT_NEAR(sum, 1.0, 1e-12);
      EXPECT_LE(used, 4);
      const double cost = costOf(problem, best, mu, near);
      for (int i = 0; i < 2000; ++i) {
        ASSERT_LE(cost, costOf(problem, randomWeights(random, candidates), mu, near) + 1e-9);
      }
    }
  }
}

TEST(BestWeights, AreALocalMinimum) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 50; ++trial) {
    const Problem problem = randomProblem(random, 6, 8);
    const CandidateWeights near{};
    const CandidateWeights best = bestWeights(problem.gram, 6, 1e-9, near);
    const double cost = squaredDistances(problem, best);
    for (std::size_t from = 0; from < 6; ++from) {
      for (std::size_t to = 0; to < 6; ++to) {
        if (!(best[from] > 1e-3) || !(best[to] > 0.0) || from == to) continue;
        CandidateWeights other = best;
        other[from] -= 1e-3;
        other[to] += 1e-3;
        EXPECT_LT(cost, squaredDistances(problem, other));
      }
    }
  }
}

TEST(BestWeights, EnergyIsTheSumOfSquaredDistances) {
  std::mt19937 random(3);
  const Problem problem = randomProblem(random, 9, 12);
  for (int i = 0; i < 20; ++i) {
    const CandidateWeights weights = randomWeights(random, 9);
    EXPECT_NEAR(energyOf(problem.gram, weights, 9), squaredDistances(problem, weights), 1e-9);
  }
}

}  // namespace
}  // namespace sinew::exporting
