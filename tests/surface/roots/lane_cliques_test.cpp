// tests/surface/roots/lane_cliques_test.cpp: cliques cut to the slots that terms are in.

#include <vector>

#include <gtest/gtest.h>

#include "core/surface/roots/lane_cliques.h"

namespace sinew::test {
namespace {

/// Cliques of a level.
struct Level {
  std::vector<int> begin{0};
  std::vector<int> slots{};
  std::vector<int> owners{};

  explicit Level(const CliqueLists& cliques) {
    for (const std::span<const int> clique : cliques) {
      slots.insert(slots.end(), clique.begin(), clique.end());
      begin.push_back(static_cast<int>(slots.size()));
    }
    findOwners(cliques, owners);
  }
  LaneCliques lanes() const { return {begin, slots, owners, 8, true}; }
};

/// Cliques of a place, each level with half the weight of the one before.
struct Place {
  std::vector<Level> levels{};
  std::vector<LaneLevel> weighted{};
  LaneLevels all{};
  PresentCliques present{};

  explicit Place(const CliqueLists& cliques) { addLevel(cliques); }
  void addLevel(const CliqueLists& cliques) {
    levels.emplace_back(cliques);
    weighted.push_back({weighted.empty() ? 0.5f : 0.5f * weighted.back().weight, levels.back().lanes()});
    all.first = weighted.front().cliques;
    if (weighted.size() > 1) all.several = weighted;
    present.makeRoom(weighted.size(), 8, 16);
  }

  struct Term {
    int slot;
    float groove;
  };
  LaneLevels cutLevels(const std::vector<Term>& terms) {
    present.start(all);
    for (const Term& term : terms) present.add(term.slot, term.groove);
    return present.finish();
  }
  LaneCliques cut(const std::vector<Term>& terms) { return cutLevels(terms).first; }
};

CliqueLists listsOf(const LaneCliques& cliques) {
  CliqueLists out;
  for (std::size_t k = 0; k < cliques.count(); ++k) {
    out.add(cliques.slotsOf(k));
  }
  return out;
}

TEST(PresentCliques, DisjointOnesGetASlotEach) {
  Place place({{0, 2, 5}, {1, 5}, {3, 4, 5}});
  const LaneCliques cut = place.cut({{4, 0.5f}, {2, 0.25f}, {5, 2.0f}});
  EXPECT_TRUE(cut.disjoint);
  EXPECT_FALSE(cut.mixed);
  EXPECT_EQ(listsOf(cut), (CliqueLists{{0}, {1}}));
  EXPECT_EQ(place.present.numberOf(2), 0);
  EXPECT_EQ(place.present.numberOf(4), 1);
  EXPECT_EQ(place.present.numberOf(5), kInEveryClique);
  EXPECT_EQ(place.present.numberOf(kInEveryClique), kInEveryClique);
  EXPECT_EQ(cut.grooves[0], 0.25f);
  EXPECT_EQ(cut.grooves[1], 0.5f);
}

TEST(PresentCliques, OthersKeepTheSlotsThatAreThere) {
  Place place({{0, 1}, {1, 2}, {3, 4}});
  const LaneCliques cut = place.cut({{4, 1.0f}, {1, 1.0f}});
  EXPECT_FALSE(cut.disjoint);
  EXPECT_EQ(listsOf(cut), (CliqueLists{{0}, {0}, {1}}));
  EXPECT_EQ(cut.slotCount, 2u);
}

TEST(PresentCliques, OneSlotAddsUpUnlessAnotherSumIsBesideIt) {
  Place place({{0}, {1}});
  EXPECT_TRUE(place.cut({{1, 0.5f}, {1, 0.75f}}).empty());
  EXPECT_EQ(place.present.numberOf(1), kInEveryClique);
  EXPECT_TRUE(place.cut({{kInEveryClique, 0.0f}}).empty());
  EXPECT_EQ(place.cut({{kInEveryClique, 0.0f}, {1, 0.5f}}).count(), 1u);
  EXPECT_EQ(place.present.numberOf(1), 0);
}

TEST(PresentCliques, SumsOfSoftnessAreNeededUnlessTheyAreExactMultiples) {
  Place place({{0, 2}, {1}});
  EXPECT_TRUE(place.cut({{0, 0.5f}, {1, 0.5f}, {2, 0.5f}}).mixed);  // Rounding: k a + k b is not k (a + b).
  EXPECT_TRUE(place.cut({{0, 2.0f}, {1, 0.5f}, {2, 0.5f}}).mixed);
  EXPECT_FALSE(place.cut({{0, 2.0f}, {1, 0.5f}, {2, 2.0f}}).mixed);
  EXPECT_FALSE(place.cut({{0, 0.5f}, {1, 0.75f}}).mixed);
}

TEST(PresentCliques, SeveralLevelsHaveTheSameSlots) {
  Place place({{0, 1, 2, 5}, {3, 5}});
  place.addLevel({{0, 2}, {1, 2}, {3, 5}});
  place.addLevel({{0, 5}, {2, 3, 5}});
  const LaneLevels cut = place.cutLevels({{5, 2.0f}, {2, 0.5f}, {0, 1.0f}});
  ASSERT_EQ(cut.several.size(), 3u);
  EXPECT_EQ(place.present.numberOf(0), 0);
  EXPECT_EQ(place.present.numberOf(2), 1);
  EXPECT_EQ(place.present.numberOf(5), 2);
  const auto expectLevel = [&](std::size_t level, bool disjoint, const CliqueLists& lists,
                               const std::vector<int>& common) {
    const LaneCliques& cliques = cut.several[level].cliques;
    EXPECT_EQ(cut.several[level].weight, place.weighted[level].weight);
    EXPECT_EQ(cliques.disjoint, disjoint);
    EXPECT_EQ(listsOf(cliques), lists);
    EXPECT_EQ(std::vector<int>(cliques.common.begin(), cliques.common.end()), common);
    EXPECT_EQ(cliques.slotCount, 3u);
    EXPECT_EQ(cliques.grooves[2], 2.0f);
  };
  expectLevel(0, true, {{0, 1}}, {2});
  expectLevel(1, false, {{0, 1}, {1}, {2}}, {});
  expectLevel(2, true, {{0}, {1}}, {2});
}

TEST(PresentCliques, OneSlotOfSeveralLevelsKeepsItsWeights) {
  Place place(CliqueLists{{0, 1}});
  place.addLevel({{0}, {1}});
  const LaneLevels cut = place.cutLevels({{1, 0.5f}});
  ASSERT_EQ(cut.several.size(), 2u);
  EXPECT_FALSE(cut.first.empty());
  EXPECT_EQ(cut.several[0].cliques.count(), 0u);
  EXPECT_EQ(cut.several[0].cliques.common.size(), 1u);
  EXPECT_EQ(listsOf(cut.several[1].cliques), (CliqueLists{{0}}));
  EXPECT_TRUE(place.cutLevels({{kInEveryClique, 0.0f}}).first.empty());
}

TEST(PresentCliques, ForgetTheirLastPlace) {
  Place place({{0}, {1}, {2}});
  EXPECT_EQ(place.cut({{0, 0.5f}, {2, 0.5f}}).count(), 2u);
  EXPECT_EQ(place.cut({{1, 0.5f}, {2, 0.25f}}).count(), 2u);
  EXPECT_EQ(place.present.numberOf(1), 0);
  EXPECT_EQ(place.present.numberOf(2), 1);
}

}  // namespace
}  // namespace sinew::test
