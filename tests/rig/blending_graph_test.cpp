// tests/rig/blending_graph_test.cpp: cliques match brute force over all subsets.
#include "core/rig/field.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace sinew {
namespace {

using Links = std::vector<std::array<int, 2>>;

std::vector<std::vector<int>> cliquesByBruteForce(int count, const Links& links) {
  const auto linked = [&](int a, int b) {
    return std::ranges::any_of(links,
                               [&](const auto& l) { return (l[0] == a && l[1] == b) || (l[0] == b && l[1] == a); });
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
  std::ranges::sort(maximal);
  return maximal;
}

TEST(BlendingGraph, FindsExactlyTheMaximalCliques) {
  std::mt19937 random(3);
  for (int round = 0; round < 300; ++round) {
    const int count = 1 + static_cast<int>(random() % 9);
    Links links;
    for (int a = 0; a < count; ++a) {
      for (int b = a; b < count; ++b) {
        if (random() % 3 != 0) links.push_back(random() % 2 ? std::array{a, b} : std::array{b, a});
      }
    }
    const Result<BlendingGraph> graph = makeBlendingGraph(count, links);
    ASSERT_TRUE(graph.ok());
    EXPECT_EQ(graph->cliques, cliquesByBruteForce(count, links)) << "round " << round;
  }
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

TEST(CliquesAmong, MatchesTheCliquesOfTheInducedGraph) {
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round) {
    Links links;
    for (int a = 0; a < 8; ++a) {
      for (int b = a + 1; b < 8; ++b) {
        if (random() % 2) links.push_back({a, b});
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
    for (const auto& [a, b] : links) {
      if (std::ranges::count(present, a) && std::ranges::count(present, b)) inner.push_back({position(a), position(b)});
    }
    std::vector<std::vector<int>> expected = cliquesByBruteForce(static_cast<int>(present.size()), inner);
    for (auto& clique : expected) {
      for (int& member : clique) member = present[static_cast<std::size_t>(member)];
    }
    std::ranges::sort(expected);
    const Result<BlendingGraph> graph = makeBlendingGraph(8, links);
    ASSERT_TRUE(graph.ok());
    std::vector<std::vector<int>> found = cliquesAmong(graph.value(), present);
    std::ranges::sort(found);
    EXPECT_EQ(found, expected) << "round " << round;
  }
}

TEST(BlendingGraphMemo, EnumeratesCliquesOnlyIfGroupsOrLinksChange) {
  BlendingGraphMemo memo;
  const auto cliques = [&](int groups, const Links& links) {
    return memo.graph(groups, links).value()->cliques.data();
  };
  const auto* const first = cliques(4, {{0, 1}, {1, 2}});
  EXPECT_EQ(cliques(4, {{0, 1}, {1, 2}}), first);
  const auto* const linked = cliques(4, {{0, 1}, {1, 2}, {0, 2}});
  EXPECT_NE(linked, first);
  EXPECT_NE(cliques(5, {{0, 1}, {1, 2}, {0, 2}}), linked);
  EXPECT_EQ(memo.graph(5, Links{{0, 1}, {1, 2}, {0, 2}}).value()->cliques,
            cliquesByBruteForce(5, {{0, 1}, {1, 2}, {0, 2}}));
}

}  // namespace
}  // namespace sinew
