// tests/rig/blending_graph_test.cpp: cliques match brute force over all subsets.
#include "core/rig/blending_graph.h"

#include <algorithm>
#include <array>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace sinew {
namespace {

using Links = std::vector<GroupLink>;

CliqueLists sorted(std::vector<std::vector<int>> cliques) {
  std::ranges::sort(cliques);
  CliqueLists lists;
  for (const std::vector<int>& clique : cliques) lists.add(clique);
  return lists;
}

CliqueLists sorted(const CliqueLists& cliques) {
  std::vector<std::vector<int>> all;
  for (const std::span<const int> clique : cliques) all.emplace_back(clique.begin(), clique.end());
  return sorted(all);
}

/// @param amount  the least that a link counts with
CliqueLists cliquesByBruteForce(int count, const Links& links, float amount = 1.0f) {
  const auto linked = [&](int a, int b) {
    return std::ranges::any_of(links, [&](const GroupLink& l) {
      return l.amount >= amount && ((l.a == a && l.b == b) || (l.a == b && l.b == a));
    });
  };
  const auto isClique = [&](unsigned set) {
    for (int a = 0; a < count; ++a) {
      for (int b = a + 1; b < count; ++b) {
        if ((set >> a & 1u) && (set >> b & 1u) && !linked(a, b)) return false;
      }
    }
    return set != 0;
  };
  std::vector<std::vector<int>> maximal;
  for (unsigned set = 1; set < 1u << count; ++set) {
    if (!isClique(set)) continue;
    bool extendable = false;
    for (int a = 0; a < count; ++a) extendable = extendable || (!(set >> a & 1u) && isClique(set | 1u << a));
    if (extendable) continue;
    std::vector<int> members;
    for (int a = 0; a < count; ++a) {
      if (set >> a & 1u) members.push_back(a);
    }
    maximal.push_back(members);
  }
  return sorted(maximal);
}

TEST(BlendingGraph, FindsExactlyTheMaximalCliques) {
  std::mt19937 random(3);
  for (int round = 0; round < 300; ++round) {
    const int count = 1 + static_cast<int>(random() % 9);
    Links links;
    for (int a = 0; a < count; ++a) {
      for (int b = a; b < count; ++b) {
        if (random() % 3 != 0) links.push_back(random() % 2 ? GroupLink{a, b} : GroupLink{b, a});
      }
    }
    const Result<BlendingGraph> graph = makeBlendingGraph(count, links);
    ASSERT_TRUE(graph.ok());
    ASSERT_EQ(graph->levels.size(), 1u);
    EXPECT_EQ(graph->levels[0].cliques, cliquesByBruteForce(count, links)) << "round " << round;
  }
}

/// An amount below 1 for about half of the links.
float anyAmount(std::mt19937& random) { return random() % 2 ? 1.0f : 0.125f * static_cast<float>(1 + random() % 7); }

TEST(BlendingGraph, HasALevelForEveryAmountAndFor1) {
  std::mt19937 random(4);
  for (int round = 0; round < 200; ++round) {
    const int count = 1 + static_cast<int>(random() % 8);
    Links links;
    for (int a = 0; a < count; ++a) {
      for (int b = a + 1; b < count; ++b) {
        if (random() % 3 != 0) links.push_back({a, b, anyAmount(random)});
      }
    }
    std::set<float> amounts{1.0f};
    for (const GroupLink& link : links) amounts.insert(link.amount);
    const Result<BlendingGraph> graph = makeBlendingGraph(count, links);
    ASSERT_TRUE(graph.ok());
    ASSERT_EQ(graph->levels.size(), amounts.size());
    for (std::size_t i = 0; const float amount : amounts) {
      EXPECT_EQ(graph->levels[i].amount, amount);
      EXPECT_EQ(graph->levels[i].cliques, cliquesByBruteForce(count, links, amount)) << "round " << round;
      ++i;
    }
  }
}

TEST(BlendingGraph, TheLargestAmountOfALinkThatIsTwiceInTheFileCounts) {
  const Result<BlendingGraph> graph = makeBlendingGraph(2, Links{{0, 1, 0.25f}, {1, 0, 0.75f}});
  const CliqueLevels levels = cliquesAmong(graph.value(), std::array{0, 1});
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_EQ(levels[0].weight, 0.75);
  EXPECT_EQ(levels[0].cliques, (CliqueLists{{0, 1}}));
  EXPECT_EQ(levels[1].weight, 0.25);
  EXPECT_EQ(levels[1].cliques, (CliqueLists{{0}, {1}}));
}

TEST(BlendingGraph, RefusesMoreThanTheLimitWithAReason) {
  // A cocktail-party graph of 13 pairs has 2^13 maximal cliques.
  Links links;
  for (int a = 0; a < 26; ++a) {
    for (int b = a + 1; b < 26; ++b) {
      if (b != a + 1 || a % 2 == 1) links.push_back({a, b});
    }
  }
  const Result<BlendingGraph> graph = makeBlendingGraph(26, links);
  ASSERT_FALSE(graph.ok());
  EXPECT_NE(graph.error().text().find("4096"), std::string::npos);
}

TEST(BlendingGraph, ThousandsOfUnlinkedGroupsAreRefusedQuickly) {
  EXPECT_TRUE(makeBlendingGraph(kMaxCliques, {}).ok());
  EXPECT_FALSE(makeBlendingGraph(kMaxCliques + 1, {}).ok());
}

/// As cliquesAmong() has them.
CliqueLevels levelsByBruteForce(int count, const Links& links) {
  std::set<float> amounts{1.0f};
  for (const GroupLink& link : links) amounts.insert(link.amount);
  CliqueLevels levels;
  double before = 0.0;
  for (const float amount : amounts) {
    const CliqueLists cliques = cliquesByBruteForce(count, links, amount);
    const double end = static_cast<double>(amount);
    if (!levels.empty() && levels.back().cliques == cliques) levels.back().weight += end - before;
    else levels.push_back({end - before, cliques});
    before = end;
  }
  return levels;
}

TEST(CliquesAmong, MatchesTheCliquesOfTheInducedGraph) {
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round) {
    Links links;
    for (int a = 0; a < 8; ++a) {
      for (int b = a + 1; b < 8; ++b) {
        if (random() % 2) links.push_back({a, b, round % 2 ? 1.0f : anyAmount(random)});
      }
    }
    std::vector<int> present;
    for (int a = 0; a < 8; ++a) {
      if (random() % 2) present.push_back(a);
    }
    Links inner;
    const auto position = [&](int group) {
      return static_cast<int>(std::ranges::find(present, group) - present.begin());
    };
    for (const GroupLink& link : links) {
      if (std::ranges::count(present, link.a) && std::ranges::count(present, link.b))
        inner.push_back({position(link.a), position(link.b), link.amount});
    }
    const CliqueLevels expected = levelsByBruteForce(static_cast<int>(present.size()), inner);
    const Result<BlendingGraph> graph = makeBlendingGraph(8, links);
    ASSERT_TRUE(graph.ok());
    CliqueLevels found = cliquesAmong(graph.value(), present);
    if (expected.size() == 1 && expected.front().cliques.size() < 2) {
      EXPECT_TRUE(found.empty()) << "all add up, round " << round;
      continue;
    }
    double whole = 0.0;
    ASSERT_EQ(found.size(), expected.size()) << "round " << round;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(sorted(found[i].cliques), expected[i].cliques) << "round " << round;
      EXPECT_EQ(found[i].weight, expected[i].weight) << "round " << round;
      whole += found[i].weight;
    }
    EXPECT_EQ(whole, 1.0) << "round " << round;
  }
}

TEST(BlendingGraphMemo, EnumeratesCliquesOnlyIfGroupsOrLinksChange) {
  BlendingGraphMemo memo;
  const auto cliques = [&](int groups, const Links& links) {
    return memo.graph(groups, links).value()->levels.front().cliques.slots().data();
  };
  const auto* const first = cliques(4, {{0, 1}, {1, 2}});
  EXPECT_EQ(cliques(4, {{0, 1}, {1, 2}}), first);
  const auto* const linked = cliques(4, {{0, 1}, {1, 2}, {0, 2}});
  EXPECT_NE(linked, first);
  EXPECT_NE(cliques(5, {{0, 1}, {1, 2}, {0, 2}}), linked);
  EXPECT_EQ(memo.graph(5, Links{{0, 1}, {1, 2}, {0, 2}}).value()->levels.front().cliques,
            cliquesByBruteForce(5, {{0, 1}, {1, 2}, {0, 2}}));
  EXPECT_EQ(memo.graph(5, Links{{0, 1}, {1, 2}, {0, 2, 0.5f}}).value()->levels.size(), 2u) << "amounts are seen";
}

}  // namespace
}  // namespace sinew
