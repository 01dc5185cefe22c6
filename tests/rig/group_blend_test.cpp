// tests/rig/group_blend_test.cpp: shares of cliques at a point match brute force, whatever groups the cliques have in
// common.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "core/rig/clique_lists.h"
#include "core/rig/group_blend.h"
#include "tests/support/oracle/grooves.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew::test {
namespace {

double uniform(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random.uniform(0.0f, 1.0f));
}

/// Cliques of up to three groups of their own, `common` groups that all have, and maybe one in two of them.
CliqueLists drawnCliques(Random& random, int common, bool overlap) {
  std::vector<std::vector<int>> out(static_cast<std::size_t>(2 + random.below(4)));
  int slots = 0;
  for (; slots < common; ++slots) {
    for (std::vector<int>& clique : out) clique.push_back(slots);
  }
  for (std::vector<int>& clique : out) {
    for (int own = 1 + random.below(2); own > 0; --own) clique.push_back(slots++);
  }
  if (overlap && out.size() > 2) {
    out[0].push_back(slots);
    out[1].push_back(slots);
  }
  CliqueLists lists;
  for (const std::vector<int>& clique : out) lists.add(clique);
  return lists;
}

/// @param tolerance  of shares; F errs by its square.
void expectMatches(const CliqueLists& cliques, double tolerance, Random& random, GroupBlend& blend) {
  std::vector<BlendedGroup>& groups = blend.start(cliques);
  ASSERT_LE(groups.size(), oracle::kMostGroups);
  oracle::PerGroup x{};
  oracle::PerGroup y{};
  double scale = 0.0;
  const double kappa = std::exp(uniform(random, std::log(0.01), std::log(2.0)));
  for (std::size_t j = 0; j < groups.size(); ++j) {
    // Alike, so that several cliques share.
    x[j] = random.chance(0.2f) ? 0.0 : 0.5 + uniform(random, -0.2, 0.2) * kappa;
    y[j] = std::min(2.0, kappa * uniform(random, 0.5, 1.5)) * x[j];
    groups[j].sum = x[j];
    groups[j].softness = y[j];
    scale += x[j];
  }
  std::vector<oracle::Clique> sets;
  for (const std::span<const int> clique : cliques) {
    oracle::Clique& set = sets.emplace_back(0);
    for (const int slot : clique) set |= 1u << slot;
  }
  const oracle::Blended best = oracle::blended(sets, x, y);
  EXPECT_NEAR(blend.settle(), best.value, 1e-10 * scale);
  for (std::size_t j = 0; j < groups.size(); ++j) {
    if (y[j] == 0.0) continue;
    EXPECT_NEAR(groups[j].share, best.shares[j], tolerance) << j;
  }
}

TEST(GroupBlend, MatchesBruteForceForDisjointCliques) {
  Random random(1);
  GroupBlend blend;
  for (int i = 0; i < 400; ++i) expectMatches(drawnCliques(random, 0, false), 1e-9, random, blend);
}

TEST(GroupBlend, MatchesBruteForceWithGroupsInEveryClique) {
  Random random(2);
  GroupBlend blend;
  for (int i = 0; i < 400; ++i) expectMatches(drawnCliques(random, 1 + random.below(3), false), 1e-9, random, blend);
}

TEST(GroupBlend, MatchesBruteForceWithGroupsInSeveralCliques) {
  Random random(3);
  GroupBlend blend;
  for (int i = 0; i < 400; ++i) expectMatches(drawnCliques(random, random.below(2), true), 1e-3, random, blend);
}

TEST(GroupBlend, OneCliqueHasAllOfItsGroups) {
  GroupBlend blend;
  const CliqueLists cliques{{0, 1}};
  std::vector<BlendedGroup>& groups = blend.start(cliques);
  groups[0] = {0.25, 0.5, 0.0};
  groups[1] = {0.5, 1.0, 0.0};
  EXPECT_EQ(blend.settle(), 0.75);
}

TEST(CliqueLists, OwnersAreTheOnlyCliquesOfSlots) {
  std::vector<int> owners{7};
  findOwners({{0, 2}, {1, 2, 3}}, owners);
  EXPECT_EQ(owners, (std::vector<int>{0, 1, kInEveryClique, 1}));
  findOwners({{0, 2}, {1, 2}, {3}}, owners);
  EXPECT_TRUE(owners.empty());
  findOwners({{0, 1}}, owners);
  EXPECT_EQ(owners, (std::vector<int>{kInEveryClique, kInEveryClique}));
}

TEST(CliqueLists, OwnSlotsAreThoseOfOneCliqueAlone) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    std::set<int> first;
    std::set<int> second;
    for (int n = random.below(6); n > 0; --n) first.insert(random.below(8));
    for (int n = random.below(6); n > 0; --n) second.insert(random.below(8));
    std::vector<int> expected;
    std::ranges::set_symmetric_difference(first, second, std::back_inserter(expected));
    std::vector<int> seen;
    const std::vector<int> a(first.begin(), first.end());
    const std::vector<int> b(second.begin(), second.end());
    for (OwnSlots own(a, b); own.next();) {
      seen.push_back(own.slot());
      EXPECT_EQ(own.ofFirst(), first.contains(own.slot()));
    }
    EXPECT_EQ(seen, expected);
  }
}

}  // namespace
}  // namespace sinew::test
