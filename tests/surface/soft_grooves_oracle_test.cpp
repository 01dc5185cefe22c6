// tests/surface/soft_grooves_oracle_test.cpp: the brute-force field's own blend of cliques, by grids, bounds and closed
// forms.

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/oracle/field.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew::test {
namespace {

using oracle::Blended;
using oracle::Clique;
using oracle::holds;
using oracle::kMostGroups;
using oracle::PerGroup;
using oracle::sumOver;
using oracle::Vec;

struct Case {
  std::vector<Clique> cliques;
  PerGroup x{};
  PerGroup y{};

  [[nodiscard]] Blended blended() const { return oracle::blended(cliques, x, y); }
  [[nodiscard]] double scale() const { return sumOver(~0u, x); }
  [[nodiscard]] double largestSum() const {
    double out = 0.0;
    for (const Clique clique : cliques) out = std::max(out, sumOver(clique, x));
    return out;
  }
  /// m_j of shares of the cliques.
  [[nodiscard]] PerGroup sharesOf(const std::vector<double>& lambda) const {
    PerGroup out{};
    for (std::size_t k = 0; k < cliques.size(); ++k) {
      for (std::size_t j = 0; j < kMostGroups; ++j) out[j] += holds(cliques[k], j) ? lambda[k] : 0.0;
    }
    return out;
  }
  [[nodiscard]] double valueOf(const PerGroup& m) const {
    double out = 0.0;
    for (std::size_t j = 0; j < kMostGroups; ++j) out += m[j] * x[j] + 0.5 * m[j] * (1.0 - m[j]) * y[j];
    return out;
  }
  /// Slope of each clique's share.
  [[nodiscard]] std::vector<double> slopesOf(const PerGroup& m) const {
    PerGroup slopes{};
    for (std::size_t j = 0; j < kMostGroups; ++j) slopes[j] = x[j] + (0.5 - m[j]) * y[j];
    std::vector<double> out;
    for (const Clique clique : cliques) out.push_back(sumOver(clique, slopes));
    return out;
  }
  /// The function is concave, so that it nowhere exceeds its value at m plus what the best slope gains on the mean one.
  [[nodiscard]] double boundAt(const PerGroup& m) const {
    const std::vector<double> slopes = slopesOf(m);
    double out = *std::ranges::max_element(slopes);
    for (std::size_t j = 0; j < kMostGroups; ++j) out += 0.5 * m[j] * m[j] * y[j];
    return out;
  }
};

double uniform(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random.uniform(0.0f, 1.0f));
}

/// Groups of which a part counts.
std::ptrdiff_t mixedOf(const PerGroup& shares) {
  return std::ranges::count_if(shares, [](double m) { return m > 1e-6 && m < 1.0 - 1e-6; });
}

void drawPotentials(Random& random, int groups, Case& drawn) {
  const double kappa = std::exp(uniform(random, std::log(0.01), std::log(2.0)));
  for (std::size_t j = 0; j < static_cast<std::size_t>(groups); ++j) {
    drawn.x[j] = random.chance(0.1f) ? 0.0 : uniform(random, 0.0, 1.0);
    // Alike, so that several cliques share.
    if (random.chance(0.5f)) drawn.x[j] = 0.5 + uniform(random, -0.2, 0.2) * kappa;
    drawn.y[j] = std::min(2.0, kappa * uniform(random, 0.5, 1.5)) * drawn.x[j];
  }
}

/// All maximal cliques of a random graph.
Case randomCase(Random& random, int groups) {
  Case out;
  std::vector<Clique> linked(static_cast<std::size_t>(groups));
  const float chance = random.uniform(0.1f, 0.9f);
  for (std::size_t a = 0; a < linked.size(); ++a) {
    linked[a] |= 1u << a;
    for (std::size_t b = 0; b < a; ++b) {
      if (!random.chance(chance)) continue;
      linked[a] |= 1u << b;
      linked[b] |= 1u << a;
    }
  }
  for (Clique set = 1; set < (1u << groups); ++set) {
    Clique linkedToAll = ~0u;
    for (std::size_t j = 0; j < linked.size(); ++j) linkedToAll &= holds(set, j) ? linked[j] : ~0u;
    if ((linkedToAll & ((1u << groups) - 1)) == set) out.cliques.push_back(set);
  }
  drawPotentials(random, groups, out);
  return out;
}

// Any of the grid's points is reachable, and one of them is near the best.
TEST(SoftGroovesOracle, MatchesAFineGridOfThreeCliques) {
  Random random(1);
  int mixed = 0;
  for (int i = 0; i < 60; ++i) {
    Case drawn = randomCase(random, 3 + random.below(4));
    while (drawn.cliques.size() != 3) drawn = randomCase(random, 3 + random.below(4));
    constexpr int kSteps = 200;
    double best = 0.0;
    for (int a = 0; a <= kSteps; ++a) {
      for (int b = 0; a + b <= kSteps; ++b) {
        const std::vector<double> lambda{a / 200.0, b / 200.0, (kSteps - a - b) / 200.0};
        best = std::max(best, drawn.valueOf(drawn.sharesOf(lambda)));
      }
    }
    const Blended seen = drawn.blended();
    EXPECT_GE(seen.value, best - 1e-12) << i;
    // Slopes of shares are alike at the best, so that a step aside costs its square.
    const double coarse = 0.5 * std::pow(2.0 / kSteps, 2.0) * sumOver(~0u, drawn.y);
    EXPECT_LE(seen.value, best + coarse + 1e-12) << i;
    mixed += mixedOf(seen.shares) > 0 ? 1 : 0;
  }
  EXPECT_GT(mixed, 20);
}

// Steps towards the best clique, each as long as is best, rise to the value from below.
double climbed(const Case& drawn, int steps) {
  std::vector<double> lambda(drawn.cliques.size(), 1.0 / static_cast<double>(drawn.cliques.size()));
  for (int i = 0; i < steps; ++i) {
    const PerGroup m = drawn.sharesOf(lambda);
    const std::vector<double> slopes = drawn.slopesOf(m);
    const auto best = static_cast<std::size_t>(std::ranges::max_element(slopes) - slopes.begin());
    double slope = 0.0;
    double bend = 0.0;
    for (std::size_t k = 0; k < lambda.size(); ++k) slope -= lambda[k] * slopes[k];
    slope += slopes[best];
    for (std::size_t j = 0; j < kMostGroups; ++j) {
      const double step = (holds(drawn.cliques[best], j) ? 1.0 : 0.0) - m[j];
      bend += drawn.y[j] * step * step;
    }
    if (slope <= 0.0 || bend <= 0.0) break;
    const double step = std::min(1.0, slope / bend);
    for (std::size_t k = 0; k < lambda.size(); ++k) lambda[k] += step * ((k == best ? 1.0 : 0.0) - lambda[k]);
  }
  return drawn.valueOf(drawn.sharesOf(lambda));
}

TEST(SoftGroovesOracle, NothingExceedsItAndClimbingReachesIt) {
  Random random(2);
  std::size_t most = 0;
  int mixed = 0;
  for (int i = 0; i < 4000; ++i) {
    const Case drawn = randomCase(random, 1 + random.below(6));
    const Blended seen = drawn.blended();
    EXPECT_LE(drawn.boundAt(seen.shares), seen.value + 1e-12 * drawn.scale()) << i;
    if (i % 4 == 0) {
      EXPECT_NEAR(climbed(drawn, 1000), seen.value, 1e-3 * drawn.scale()) << i;
    }
    most = std::max(most, drawn.cliques.size());
    mixed += mixedOf(seen.shares) > 2 ? 1 : 0;
  }
  EXPECT_GE(most, 7u);
  EXPECT_GT(mixed, 500);
}

// Three times two groups of which no two are linked, all alike: nine cliques of which many mixtures are the best.
TEST(SoftGroovesOracle, ManyTyingCliquesShareEvenly) {
  Case even;
  for (Clique set = 0; set < 64; ++set) {
    bool one = true;
    for (std::size_t pair = 0; pair < 3; ++pair) one = one && holds(set, 2 * pair) != holds(set, 2 * pair + 1);
    if (one) even.cliques.push_back(set);
  }
  ASSERT_EQ(even.cliques.size(), 8u);
  for (std::size_t j = 0; j < 6; ++j) {
    even.x[j] = 0.3;
    even.y[j] = 0.1;
  }
  const Blended seen = even.blended();
  EXPECT_NEAR(seen.value, 6 * (0.5 * 0.3 + 0.125 * 0.1), 1e-13);
  for (std::size_t j = 0; j < 6; ++j) EXPECT_NEAR(seen.shares[j], 0.5, 1e-12);
  even.x[1] = 0.31;
  EXPECT_NEAR(even.boundAt(even.blended().shares), even.blended().value, 1e-13);
}

TEST(SoftGroovesOracle, TwoUnlinkedGroupsHaveAClosedForm) {
  Random random(3);
  int inside = 0;
  for (int i = 0; i < 500; ++i) {
    const double kappa = uniform(random, 0.001, 2.0);
    const double a = uniform(random, 0.1, 1.0);
    const double b = a * (1.0 + uniform(random, -1.5, 1.5) * std::min(kappa, 0.6));
    const double c = uniform(random, 0.0, 1.0);
    const Case drawn{{0b101, 0b110}, {a, b, c}, {kappa * a, kappa * b, kappa * c}};
    const bool apart = std::abs(a - b) >= 0.5 * kappa * (a + b);
    const double blend = 0.5 * (a + b) + 0.125 * kappa * (a + b) + 0.5 * (a - b) * (a - b) / (kappa * (a + b));
    EXPECT_NEAR(drawn.blended().value, c + (apart ? std::max(a, b) : blend), 1e-13) << i;
    inside += apart ? 0 : 1;
  }
  EXPECT_GT(inside, 100);
}

TEST(SoftGroovesOracle, LiesBetweenTheMaximumAndAnEighthOfY) {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const Case drawn = randomCase(random, 1 + random.below(6));
    const double value = drawn.blended().value;
    EXPECT_GE(value, drawn.largestSum() - 1e-12) << i;
    EXPECT_LE(value, drawn.largestSum() + sumOver(~0u, drawn.y) / 8.0 + 1e-12) << i;
  }
}

TEST(SoftGroovesOracle, ScalesWithThePotentials) {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const Case drawn = randomCase(random, 1 + random.below(6));
    for (const double times : {1e-9, 0.3, 1e6}) {
      Case scaled = drawn;
      for (std::size_t j = 0; j < kMostGroups; ++j) {
        scaled.x[j] *= times;
        scaled.y[j] *= times;
      }
      EXPECT_NEAR(scaled.blended().value / times, drawn.blended().value, 1e-11 * drawn.scale()) << i;
    }
  }
}

TEST(SoftGroovesOracle, WithoutKappaItIsTheMaximum) {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    Case drawn = randomCase(random, 1 + random.below(6));
    drawn.y = {};
    EXPECT_NEAR(drawn.blended().value, drawn.largestSum(), 1e-14) << i;
  }
}

TEST(SoftGroovesOracle, AGroupInEveryCliqueIsAddedWhole) {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const Case drawn = randomCase(random, 1 + random.below(6));
    Case more = drawn;
    for (Clique& clique : more.cliques) clique |= 1u << 9;
    more.x[9] = uniform(random, 0.0, 2.0);
    more.y[9] = uniform(random, 0.0, 2.0) * more.x[9];
    const Blended with = more.blended();
    const Blended without = drawn.blended();
    EXPECT_NEAR(with.value, without.value + more.x[9], 1e-12) << i;
    for (std::size_t j = 0; j < 6; ++j) EXPECT_NEAR(with.shares[j], without.shares[j], 1e-9) << i;
  }
}

TEST(SoftGroovesOracle, AFarGroupChangesNothing) {
  Random random(8);
  for (int i = 0; i < 200; ++i) {
    const Case drawn = randomCase(random, 1 + random.below(6));
    Case alone = drawn;
    alone.cliques.push_back(1u << 9);
    EXPECT_EQ(alone.blended().value, drawn.blended().value) << i;
    // Linked to some: cliques that it joins stand beside what is left of others.
    Case linked = drawn;
    linked.cliques.front() |= 1u << 9;
    linked.cliques.push_back((drawn.cliques.back() & drawn.cliques.front()) | 1u << 9);
    EXPECT_NEAR(linked.blended().value, drawn.blended().value, 1e-13 * drawn.scale()) << i;
  }
}

/// Crowded muscles of groups of which about half are linked, with carves and shapes.
Rig groovedRig(const Character& character, float grooves, std::uint64_t seed) {
  const RigRecipe recipe{.primitives = 24, .groups = 6, .linkChance = 0.5f, .radiusHigh = 0.15f, .shapedChance = 0.2f};
  Rig rig = randomRig(character, recipe, seed);
  rig.surface.grooves = grooves;
  return rig;
}

struct Probe {
  Vec point;
  std::vector<double> weights;
};

/// A point near the skin, with the territories of the vertex there.
Probe probeNear(const Character& character, const oracle::Field& field, Random& random) {
  const int vertex = random.below(static_cast<int>(character.mesh.positions.size()));
  const double around = 0.05 * static_cast<double>(character.height);
  const Vec off{uniform(random, -around, around), uniform(random, -around, around), uniform(random, -around, around)};
  return {oracle::vec(character.mesh.positions[static_cast<std::size_t>(vertex)]) + off,
          field.territoryWeights(vertex)};
}

TEST(SoftGroovesOracle, GradientMatchesDifferences) {
  const auto character = makeTwoLegged();
  const Pose pose = bindPose(character->skeleton);
  int mixed = 0;
  for (const float grooves : {0.004f, 0.03f, 0.3f}) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      oracle::Field field(*character, groovedRig(*character, grooves, seed));
      field.pose(pose);
      Random random(seed);
      for (int i = 0; i < 100; ++i) {
        const auto [point, weights] = probeNear(*character, field, random);
        const Vec gradient = field.gradient(point, weights);
        const double size = std::max(1.0, oracle::length(gradient));
        const auto slope = [&](const Vec& axis) {
          constexpr double kStep = 1e-6;
          return (field.value(point + kStep * axis, weights) - field.value(point - kStep * axis, weights)) /
                 (2.0 * kStep);
        };
        EXPECT_NEAR(slope({1, 0, 0}), gradient.x, 1e-3 * size);
        EXPECT_NEAR(slope({0, 1, 0}), gradient.y, 1e-3 * size);
        EXPECT_NEAR(slope({0, 0, 1}), gradient.z, 1e-3 * size);
        mixed += field.groupsInPart(point, weights) > 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(mixed, 100);
}

TEST(SoftGroovesOracle, RaysHaveTheValuesOfTheirPoints) {
  const auto character = makeTwoLegged();
  const Pose pose = randomPose(character->skeleton, 0.5f, 0.3f, 1);
  for (const float grooves : {0.0f, 0.03f, 0.3f}) {
    oracle::Field field(*character, groovedRig(*character, grooves, 3));
    field.pose(pose);
    Random random(3);
    for (int i = 0; i < 40; ++i) {
      const auto [point, weights] = probeNear(*character, field, random);
      const Vec along = oracle::unitOr({uniform(random, -1, 1), uniform(random, -1, 1), 0.5}, {0, 0, 1});
      const oracle::Field::Ray ray = field.along(point, along, weights);
      for (const double t : {0.0, 0.01, 0.1}) {
        EXPECT_NEAR(ray.value(t), field.value(point + t * along, weights), 1e-12);
      }
    }
  }
}

TEST(SoftGroovesOracle, WidensWithTheirWidthFromTheMaximumOn) {
  const auto character = makeTwoLegged();
  const Pose pose = bindPose(character->skeleton);
  double risen = 0.0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    std::vector<oracle::Field> fields;
    for (const float grooves : {0.0f, 1e-7f, 0.01f, 0.1f, 1.0f}) {
      fields.emplace_back(*character, groovedRig(*character, grooves, seed)).pose(pose);
    }
    Random random(seed);
    for (int i = 0; i < 60; ++i) {
      const auto [point, weights] = probeNear(*character, fields.front(), random);
      EXPECT_NEAR(fields[1].value(point, weights), fields[0].value(point, weights), 1e-4);
      for (std::size_t k = 1; k < fields.size(); ++k) {
        EXPECT_GE(fields[k].value(point, weights), fields[k - 1].value(point, weights) - 1e-12) << k;
      }
      risen += fields.back().value(point, weights) - fields.front().value(point, weights);
    }
  }
  EXPECT_GT(risen, 1.0);
}

// Midway between two balls of one size the field rises by kappa/4 of one's potential.
TEST(SoftGroovesOracle, KappaIsOfThePosedMeanRadius) {
  const auto character = makeLimb();
  for (const float times : {1.0f, 0.5f}) {
    Rig rig;
    rig.groups = {{"a", {}}, {"b", {}}};
    const glm::vec3 middle(0.0f, 1.0f, 0.0f);
    const glm::vec3 side(0.1f, 0.0f, 0.0f);
    rig.primitives.push_back(ellipsoidAt(*character, "one", "middle", "a", middle - side, glm::vec3(0.2f)));
    rig.primitives.push_back(ellipsoidAt(*character, "two", "middle", "b", middle + side, glm::vec3(0.2f)));
    rig.surface.grooves = 0.02f;
    Pose pose = bindPose(character->skeleton);
    for (glm::mat4& bone : pose.boneInWorld) {
      for (int column = 0; column < 3; ++column) bone[column] *= times;
    }
    oracle::Field soft(*character, rig);
    soft.pose(pose);
    rig.surface.grooves = 0.0f;
    oracle::Field hard(*character, rig);
    hard.pose(pose);
    const auto bone = static_cast<std::size_t>(oracle::boneNamed(character->skeleton, "middle"));
    const glm::vec3 inBone = 0.5f * (rig.primitives[0].placement.center + rig.primitives[1].placement.center);
    const Vec at = oracle::vec(glm::vec3(pose.boneInWorld[bone] * glm::vec4(inBone, 1.0f)));
    const std::vector<double> weights(2, 1.0);
    const double reach = static_cast<double>(rig.primitives[0].reach);
    const double radius = 0.2 * static_cast<double>(times);
    const double kappa = 2.0 * 0.02 * static_cast<double>(character->height) / (radius * (reach * reach - 1.0));
    ASSERT_LT(kappa, 2.0);
    EXPECT_NEAR(soft.value(at, weights), hard.value(at, weights) * (1.0 + 0.25 * kappa), 1e-5);
    EXPECT_GT(hard.value(at, weights), 0.1);
  }
}

}  // namespace
}  // namespace sinew::test
