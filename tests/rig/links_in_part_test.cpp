// tests/rig/links_in_part_test.cpp: the field of groups that are linked in part, against the mean of whole graphs.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/rig/field.h"
#include "tests/support/rigs/random_rigs.h"

namespace sinew {
namespace {

using test::Random;

constexpr int kGroups = 5;

/// Overlapping balls of five groups, one of which carves.
struct Scene {
  std::vector<PosedPrimitive> primitives;
  std::vector<Candidate> candidates;
  std::vector<GroupLink> links;
};

Scene anyScene(Random& random, float groove) {
  Scene scene;
  for (int i = 0; i < 10; ++i) {
    Placement placement;
    placement.center = {random.uniform(-0.6f, 0.6f), random.uniform(-0.6f, 0.6f), random.uniform(-0.6f, 0.6f)};
    placement.radii = glm::vec3(random.uniform(0.4f, 0.8f));
    const float strength = i == 9 ? -0.5f : random.uniform(0.4f, 1.0f);
    scene.primitives.push_back({unitBallMap(placement, 1.5f, glm::mat4(1.0f)), strength, 0.5f, groove});
    scene.candidates.push_back({i, 1.0f, i % kGroups});
  }
  for (int a = 0; a < kGroups; ++a) {
    for (int b = 0; b < a; ++b) {
      if (random.chance(0.7f)) scene.links.push_back({b, a, random.chance(0.3f) ? 1.0f : random.uniform(0.05f, 1.0f)});
    }
  }
  return scene;
}

glm::vec3 anyPoint(Random& random) {
  return {random.uniform(-0.8f, 0.8f), random.uniform(-0.8f, 0.8f), random.uniform(-0.8f, 0.8f)};
}

CliqueLevels levelsOf(const std::vector<GroupLink>& links) {
  return cliquesAmong(makeBlendingGraph(kGroups, links).value(), std::array{0, 1, 2, 3, 4});
}

FieldSample fieldOf(const Scene& scene, const CliqueLevels& levels, const glm::vec3& point) {
  return sampleField(scene.primitives, scene.candidates, levels, point);
}

FieldSample fieldOf(const Scene& scene, const std::vector<GroupLink>& links, const glm::vec3& point) {
  return fieldOf(scene, levelsOf(links), point);
}

/// The links with at least an amount, whole.
std::vector<GroupLink> linksFrom(std::vector<GroupLink> links, float threshold) {
  std::erase_if(links, [&](const GroupLink& link) { return link.amount < threshold; });
  for (GroupLink& link : links) link.amount = 1.0f;
  return links;
}

constexpr std::array kGrooves{0.0f, 0.3f, 2.0f};

TEST(LinksInPart, TheFieldIsTheMeanOverAllThresholds) {
  constexpr int kThresholds = 2000;
  Random random(5);
  for (const float groove : kGrooves) {
    for (int round = 0; round < 12; ++round) {
      const Scene scene = anyScene(random, groove);
      std::vector<CliqueLevels> whole;
      for (int k = 0; k < kThresholds; ++k) {
        whole.push_back(levelsOf(linksFrom(scene.links, (static_cast<float>(k) + 0.5f) / kThresholds)));
      }
      for (int i = 0; i < 10; ++i) {
        const glm::vec3 point = anyPoint(random);
        double mean = 0.0;
        glm::dvec3 slope(0.0);
        for (const CliqueLevels& levels : whole) {
          const FieldSample here = fieldOf(scene, levels, point);
          mean += static_cast<double>(here.value) / kThresholds;
          slope += glm::dvec3(here.gradient) / static_cast<double>(kThresholds);
        }
        const FieldSample part = fieldOf(scene, scene.links, point);
        // Thresholds on the wrong side of an amount: at most one of each link's.
        EXPECT_NEAR(static_cast<double>(part.value), mean, 10.0 * 3.0 / kThresholds);
        EXPECT_LT(glm::distance(glm::dvec3(part.gradient), slope), 10.0 * 20.0 / kThresholds);
      }
    }
  }
}

TEST(LinksInPart, TwoGroupsHaveTheLargerAndThatPartOfTheSmaller) {
  Random random(6);
  for (int round = 0; round < 200; ++round) {
    Scene scene = anyScene(random, 0.0f);
    for (Candidate& candidate : scene.candidates) candidate.slot %= 2;
    const float amount = random.uniform(0.01f, 0.99f);
    const CliqueLevels levels =
        cliquesAmong(makeBlendingGraph(2, std::array{GroupLink{0, 1, amount}}).value(), std::array{0, 1});
    const glm::vec3 point = anyPoint(random);
    std::array<float, 2> sums{};
    float carved = 0.0f;
    for (const Candidate& candidate : scene.candidates) {
      const float part = sampleField(scene.primitives, std::span(&candidate, 1), {}, point).value;
      (part < 0.0f ? carved : sums[static_cast<std::size_t>(candidate.slot)]) += part;
    }
    EXPECT_NEAR(sampleField(scene.primitives, scene.candidates, levels, point).value,
                std::max(sums[0], sums[1]) + amount * std::min(sums[0], sums[1]) + carved, 1e-5f);
  }
}

TEST(LinksInPart, AnAmountOf1IsAWholeLinkBitForBitAndNearly0IsNone) {
  Random random(7);
  for (const float groove : kGrooves) {
    for (int round = 0; round < 100; ++round) {
      const Scene scene = anyScene(random, groove);
      const std::vector<GroupLink> whole = linksFrom(scene.links, 0.0f);
      ASSERT_LE(levelsOf(whole).size(), 1u);
      for (const CliqueLevel& level : levelsOf(whole)) EXPECT_EQ(level.weight, 1.0);
      std::vector<GroupLink> hardly = whole;
      for (GroupLink& link : hardly) link.amount = 1e-6f;
      const glm::vec3 point = anyPoint(random);
      EXPECT_NEAR(fieldOf(scene, hardly, point).value, fieldOf(scene, std::vector<GroupLink>(), point).value, 1e-4f);
    }
  }
}

TEST(LinksInPart, TheFieldRisesContinuouslyWithEveryAmount) {
  Random random(8);
  for (const float groove : kGrooves) {
    for (int round = 0; round < 60; ++round) {
      Scene scene = anyScene(random, groove);
      if (scene.links.empty()) continue;
      GroupLink& link = scene.links[static_cast<std::size_t>(random.below(static_cast<int>(scene.links.size())))];
      const glm::vec3 point = anyPoint(random);
      constexpr int kSteps = 100;
      link.amount = 1.0f / kSteps;
      float before = fieldOf(scene, scene.links, point).value;
      for (int i = 2; i <= kSteps; ++i) {
        link.amount = static_cast<float>(i) / kSteps;
        const float now = fieldOf(scene, scene.links, point).value;
        EXPECT_GE(now, before - 1e-5f) << "amount " << link.amount;
        EXPECT_LE(now, before + 5.0f / kSteps) << "amount " << link.amount;
        before = now;
      }
    }
  }
}

TEST(LinksInPart, GroupsThatDoNotReachAPointCanBeLeftOut) {
  Random random(9);
  for (const float groove : kGrooves) {
    for (int round = 0; round < 200; ++round) {
      const Scene scene = anyScene(random, groove);
      const BlendingGraph graph = makeBlendingGraph(kGroups, scene.links).value();
      const glm::vec3 point = 2.0f * anyPoint(random);
      std::vector<int> present;
      std::vector<Candidate> seen;
      for (const Candidate& candidate : scene.candidates) {
        const FieldSample alone = sampleField(scene.primitives, std::span(&candidate, 1), {}, point);
        if (alone.value == 0.0f) continue;
        seen.push_back(candidate);
        present.push_back(candidate.slot);
      }
      std::ranges::sort(present);
      present.erase(std::unique(present.begin(), present.end()), present.end());
      for (Candidate& candidate : seen) {
        candidate.slot = static_cast<int>(std::ranges::lower_bound(present, candidate.slot) - present.begin());
      }
      const FieldSample few = sampleField(scene.primitives, seen, cliquesAmong(graph, present), point);
      const FieldSample all = fieldOf(scene, scene.links, point);
      EXPECT_NEAR(few.value, all.value, 2e-6f);
      EXPECT_LT(glm::distance(few.gradient, all.gradient), 1e-3f * (1.0f + glm::length(all.gradient)));
    }
  }
}

TEST(LinksInPart, TwiceThePotentialsGiveTwiceTheField) {
  Random random(10);
  for (const float groove : kGrooves) {
    for (int round = 0; round < 200; ++round) {
      const Scene scene = anyScene(random, groove);
      Scene twice = scene;
      for (PosedPrimitive& primitive : twice.primitives) primitive.strength *= 2.0f;
      const glm::vec3 point = anyPoint(random);
      EXPECT_NEAR(fieldOf(twice, twice.links, point).value, 2.0f * fieldOf(scene, scene.links, point).value, 1e-5f);
    }
  }
}

}  // namespace
}  // namespace sinew
