// tests/rig/posed_cliques_test.cpp: the cliques for amounts of a moment match those of a graph drawn with them.
#include "core/rig/posed_cliques.h"

#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/allocations.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew::test {
namespace {

constexpr int kGroups = 8;

/// Few different ones, so that amounts of several links are often equal, or equal to one that does not move.
float anyAmount(Random& random) { return 0.25f * static_cast<float>(1 + random.below(4)); }

std::vector<GroupLink> anyLinks(Random& random) {
  std::vector<GroupLink> links;
  for (int a = 0; a < kGroups; ++a) {
    for (int b = a + 1; b < kGroups; ++b) {
      if (random.chance(0.6f)) links.push_back({b, a, anyAmount(random), random.chance(0.4f)});
      if (random.chance(0.1f)) links.push_back({a, b, anyAmount(random), random.chance(0.4f)});  // Files may.
    }
  }
  return links;
}

std::vector<int> anyGroups(Random& random) {
  std::vector<int> groups;
  const float share = random.uniform(0.1f, 0.9f);
  for (int i = 0; i < kGroups; ++i) {
    if (random.chance(share)) groups.push_back(i);
  }
  return groups;
}

/// What the links' amounts are at a moment; 0 among them.
std::vector<float> amountsOf(std::span<const GroupLink> links, Random& random) {
  std::vector<float> amounts;
  for (const GroupLink& link : links) {
    amounts.push_back(!link.isAnimated      ? link.amount
                      : random.chance(0.5f) ? 0.25f * static_cast<float>(random.below(5))
                                            : random.uniform(0.0f, 1.0f));
  }
  return amounts;
}

std::vector<GroupLink> drawnWith(std::vector<GroupLink> links, std::span<const float> amounts) {
  for (std::size_t i = 0; i < links.size(); ++i) links[i].amount = amounts[i];
  std::erase_if(links, [](const GroupLink& link) { return link.amount == 0.0f; });
  return links;
}

TEST(PosedCliques, AreThoseOfAGraphDrawnWithTheAmounts) {
  Random random(11);
  int several = 0;
  int together = 0;
  for (int round = 0; round < 300; ++round) {
    const std::vector<GroupLink> links = anyLinks(random);
    const std::vector<int> groups = anyGroups(random);
    const BlendingGraph graph = makeBlendingGraph(kGroups, links).value();
    const AnimatedCliques place = animatedAmong(graph, groups);
    if (place.isEmpty()) continue;
    PosedCliques posed;
    CliqueGrowth growth;
    // Moment after moment: the one before leaves nothing behind.
    for (int moment = 0; moment < 5; ++moment) {
      const std::vector<float> amounts = amountsOf(links, random);
      const CliqueLevels expected = cliquesAmong(makeBlendingGraph(kGroups, drawnWith(links, amounts)).value(), groups);
      const CliqueLevelsView found = posed.pose(place, amounts, {}, growth);
      ASSERT_EQ(found.size(), expected.size()) << round << ", " << moment;
      for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_EQ(found[i].weight, expected[i].weight) << round << ", " << moment;
        EXPECT_EQ(found[i].cliques, expected[i].cliques) << round << ", " << moment;
        EXPECT_EQ(found[i].owners, expected[i].owners) << round << ", " << moment;
      }
      several += found.size() > 1 ? 1 : 0;
      together += found.empty() ? 1 : 0;
    }
  }
  EXPECT_GT(several, 300);
  EXPECT_GT(together, 3);
}

TEST(PosedCliques, PlacesWithoutAnimatedLinksAreLeftOut) {
  const std::array links{GroupLink{0, 1, 0.5f, true}, GroupLink{1, 2, 0.5f, false}};
  const BlendingGraph graph = makeBlendingGraph(4, links).value();
  EXPECT_TRUE(animatedAmong(graph, std::array{1, 2, 3}).isEmpty());
  EXPECT_TRUE(animatedAmong(graph, std::array{0, 2}).isEmpty());
  EXPECT_FALSE(animatedAmong(graph, std::array{0, 1}).isEmpty());
}

TEST(PosedCliques, AllocateNothingOnceThereIsRoom) {
  Random random(12);
  for (int round = 0; round < 50; ++round) {
    const std::vector<GroupLink> links = anyLinks(random);
    std::vector<int> groups;
    for (int i = 0; i < kGroups; ++i) groups.push_back(i);
    const AnimatedCliques place = animatedAmong(makeBlendingGraph(kGroups, links).value(), groups);
    PosedCliques posed;
    CliqueGrowth growth;
    const CliqueSizes sizes = sizesOf(place);
    growth.reserve(sizes.cliques, sizes.slots);
    posed.reserve(sizes);
    for (int moment = 0; moment < 20; ++moment) {
      const std::vector<float> amounts = amountsOf(links, random);
      const std::int64_t before = allocations();
      const CliqueLevelsView found = posed.pose(place, amounts, {}, growth);
      EXPECT_EQ(allocations(), before) << "round " << round << ", moment " << moment;
      const CliqueSizes needed = sizesOf(found);
      EXPECT_LE(needed.levels, sizes.levels);
      EXPECT_LE(needed.cliques, sizes.cliques);
      EXPECT_LE(needed.inCliques, sizes.inCliques);
    }
  }
}

// A cocktail-party graph of 13 pairs has 2^13 maximal cliques; drawn with all links it has one.
TEST(PosedCliques, MoreThanTheLimitAreThoseDrawn) {
  std::vector<GroupLink> links;
  std::vector<float> amounts;
  std::vector<int> groups;
  for (int a = 0; a < 26; ++a) {
    groups.push_back(a);
    for (int b = a + 1; b < 26; ++b) {
      const bool pair = b == a + 1 && a % 2 == 0;
      links.push_back({a, b, 1.0f, true});
      amounts.push_back(pair ? 0.0f : 1.0f);
    }
  }
  const BlendingGraph graph = makeBlendingGraph(26, links).value();
  const AnimatedCliques place = animatedAmong(graph, groups);
  const CliqueLevels drawn{{1.0, {{0, 1}, {2}}}};
  PosedCliques posed;
  CliqueGrowth growth;
  EXPECT_EQ(posed.pose(place, amounts, drawn, growth).data(), drawn.data());
}

TEST(PosedCliques, AnimatedLinksAreValidWithoutAsWellAsDrawn) {
  // Without the links of 13 pairs as many cliques as above.
  std::vector<GroupLink> links;
  for (int a = 0; a < 26; ++a) {
    for (int b = a + 1; b < 26; ++b) links.push_back({a, b, 1.0f, b == a + 1 && a % 2 == 0});
  }
  EXPECT_FALSE(makeBlendingGraph(26, links).ok());
  for (GroupLink& link : links) link.isAnimated = false;
  EXPECT_TRUE(makeBlendingGraph(26, links).ok());
}

}  // namespace
}  // namespace sinew::test
