// tests/surface/finish/lift_filter_test.cpp: heights that edges cannot follow are smoothed; all others stay.

#include "core/surface/finish/lifted_heights.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/surface/sheets.h"

namespace sinew::test {
namespace {

constexpr int kCells = 20;
constexpr float kEdge = 2.0f / kCells;

/// A flat sheet with heights along z.
struct Heights {
  ControlMesh mesh;
  Refinement refinement;
  std::vector<float> heights;
  std::vector<glm::vec3> positions;
  LiftFilter filter{};
  LiftedHeights lifted{};
  MovedTriangles moved{};
  VertexRings rings;

  Heights() : mesh(flat()), refinement(refine(mesh, 1)), rings(vertexRings(refinement)) {}

  /// @return weights; empty where the filter found nothing to do
  std::vector<float> filtered(const std::vector<float>& raw) {
    heights = raw;
    positions = mesh.positions;
    for (std::size_t v = 0; v < raw.size(); ++v) positions[v].z += raw[v];
    moved.find(refinement, mesh.positions, positions);
    lifted.start(rings, moved, mesh.positions, positions, heights);
    const auto weights = filter.apply(lifted, mesh.positions, positions, heights);
    return {weights.begin(), weights.end()};
  }

  /// A disc of constant height around a point, with a rim steeper than any edge.
  [[nodiscard]] std::vector<float> disc(float height, float radius) const {
    std::vector<float> out;
    for (const glm::vec3& p : mesh.positions) {
      out.push_back(std::hypot(p.x - 0.03f, p.y - 0.02f) < radius ? height : 0.0f);
    }
    return out;
  }

  /// Largest second difference of the heights along the rows, in edges: visible as teeth.
  [[nodiscard]] float roughness() const {
    float most = 0.0f;
    for (std::size_t a = 0; a < heights.size(); ++a) {
      for (std::size_t b = 0; b < heights.size(); ++b) {
        const glm::vec3 way = mesh.positions[b] - mesh.positions[a];
        if (std::abs(way.y) > 1e-4f || std::abs(way.x - kEdge) > 1e-4f) continue;
        const glm::vec3 beyond = mesh.positions[b] + way;
        const auto next = std::ranges::find_if(mesh.positions, [&](const glm::vec3& p) {
          return std::abs(p.x - beyond.x) + std::abs(p.y - beyond.y) < 1e-4f;
        });
        if (next == mesh.positions.end()) continue;
        const float third = heights[static_cast<std::size_t>(next - mesh.positions.begin())];
        most = std::max(most, std::abs(heights[a] - 2.0f * heights[b] + third) / kEdge);
      }
    }
    return most;
  }

 private:
  static ControlMesh flat() {
    const Sheet sheet = sheetOf(kCells, [](float, float) { return 0.0f; });
    return meshOf(sheet.positions, sheet.triangles);
  }
};

TEST(LiftFilter, LeavesResolvedHeightsUnchangedBitForBit) {
  Heights sheet;
  std::vector<float> raw;
  for (const glm::vec3& p : sheet.mesh.positions) {
    const float inside = std::max(0.0f, 1.0f - (p.x * p.x + p.y * p.y) / 0.7f);
    raw.push_back(0.2f * inside * inside);
  }
  EXPECT_TRUE(sheet.filtered(raw).empty());
  EXPECT_EQ(sheet.heights, raw);
}

TEST(LiftFilter, SmoothsARimNarrowerThanAnEdge) {
  Heights sheet;
  for (const float sign : {1.0f, -1.0f}) {
    const std::vector<float> raw = sheet.disc(sign * kEdge, 0.25f);
    sheet.heights = raw;
    const float before = sheet.roughness();
    const std::vector<float> weights = sheet.filtered(raw);
    ASSERT_FALSE(weights.empty());
    const float after = sheet.roughness();
    std::printf("  second differences up to %.2f edges, filtered %.2f\n", double{before}, double{after});
    EXPECT_LT(after, 0.6f * before);
    int changed = 0;
    for (std::size_t v = 0; v < raw.size(); ++v) {
      EXPECT_GE(sign * sheet.heights[v], 0.0f) << v;
      EXPECT_LE(sign * sheet.heights[v], sign * raw[v]) << v;
      EXPECT_FLOAT_EQ(sheet.positions[v].z, sheet.heights[v]) << v;
      if (sheet.heights[v] == raw[v]) continue;
      ++changed;
      EXPECT_GT(weights[v], 0.0f) << v;
    }
    EXPECT_GT(changed, 10);
  }
}

// A vertex that begins to move between high neighbors rises from 0.
TEST(LiftFilter, IsContinuousInTheHeights) {
  Heights sheet;
  constexpr int kSteps = 400;
  std::vector<float> before;
  float worst = 0.0f;
  for (int i = 0; i <= kSteps; ++i) {
    std::vector<float> raw = sheet.disc(kEdge, 0.25f);
    const std::vector<float> wider = sheet.disc(kEdge, 0.4f);
    const float share = static_cast<float>(i) / kSteps;
    for (std::size_t v = 0; v < raw.size(); ++v) raw[v] += share * (wider[v] - raw[v]);
    sheet.filtered(raw);
    for (std::size_t v = 0; v < before.size(); ++v) {
      worst = std::max(worst, std::abs(sheet.heights[v] - before[v]));
    }
    before = sheet.heights;
  }
  std::printf("  largest step %.4f of an edge, the heights' own %.4f\n", double{worst / kEdge}, 1.0 / kSteps);
  EXPECT_LT(worst, 4.0f * kEdge / kSteps);
}

/// Definition, by edge of every triangle and in double precision; fills `weights`.
std::vector<double> asDefined(const Refinement& refinement, const std::vector<glm::vec3>& patch,
                              const std::vector<float>& heights, std::vector<double>& weights) {
  const std::size_t n = heights.size();
  const auto sums = [&](const std::vector<double>& s, std::vector<double>& perLength, std::vector<double>& edges) {
    std::vector<double> difference(n, 0.0);
    perLength.assign(n, 0.0);
    edges.assign(n, 0.0);
    for (const std::array<int, 3>& t : refinement.triangles) {
      for (std::size_t i = 0; i < 9; ++i) {
        const auto a = static_cast<std::size_t>(t[i / 3]);
        const auto b = static_cast<std::size_t>(t[i % 3]);
        if (a == b) continue;
        const double length = glm::distance(glm::dvec3(patch[a]), glm::dvec3(patch[b]));
        edges[a] += 1.0;
        if (length == 0.0) continue;
        perLength[a] += 1.0 / length;
        difference[a] += (s[b] - s[a]) / length;
      }
    }
    return difference;
  };
  std::vector<double> now(heights.begin(), heights.end());
  std::vector<double> perLength;
  std::vector<double> edges;
  std::vector<double> difference = sums(now, perLength, edges);
  std::vector<double> own(n, 0.0);
  std::vector<double> passed(n, 0.0);
  for (std::size_t v = 0; v < n; ++v) {
    if (heights[v] == 0.0f) continue;
    const double t = std::clamp((std::abs(difference[v]) / edges[v] - 0.15) / 0.35, 0.0, 1.0);
    own[v] = t * t * (3.0 - 2.0 * t);
    const double risen = std::min(1.0, std::abs(static_cast<double>(heights[v])) * perLength[v] / edges[v] / 0.1);
    passed[v] = own[v] * risen * risen * (3.0 - 2.0 * risen);
  }
  weights = own;
  for (const std::array<int, 3>& t : refinement.triangles) {
    for (const int a : t) {
      for (const int b : t) {
        weights[static_cast<std::size_t>(a)] =
            std::max(weights[static_cast<std::size_t>(a)], passed[static_cast<std::size_t>(b)]);
      }
    }
  }
  for (int round = 0; round < 4; ++round) {
    difference = sums(now, perLength, edges);
    for (std::size_t v = 0; v < n; ++v) {
      if (weights[v] == 0.0 || heights[v] == 0.0f || perLength[v] == 0.0) continue;
      const auto height = static_cast<double>(heights[v]);
      now[v] = std::clamp(now[v] + 0.5 * weights[v] * difference[v] / perLength[v], std::min(0.0, height),
                          std::max(0.0, height));
    }
  }
  return now;
}

TEST(LiftFilter, MatchesItsDefinition) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  for (int trial = 0; trial < 6; ++trial) {
    Heights bent;
    // Uneven edges, some of zero length; scattered heights of both signs.
    for (glm::vec3& p : bent.mesh.positions) p.z = 0.03f * unit(random);
    for (int i = 0; i < 5; ++i) {
      const auto& t = bent.refinement.triangles[static_cast<std::size_t>(97 * i + trial)];
      bent.mesh.positions[static_cast<std::size_t>(t[1])] = bent.mesh.positions[static_cast<std::size_t>(t[0])];
    }
    const float share = 0.2f + 0.15f * static_cast<float>(trial);
    std::vector<float> raw;
    for (std::size_t v = 0; v < bent.mesh.positions.size(); ++v) {
      raw.push_back(unit(random) < share ? kEdge * (unit(random) - 0.4f) : 0.0f);
    }
    const std::vector<float> weights = bent.filtered(raw);
    ASSERT_FALSE(weights.empty());
    std::vector<double> wanted;
    const std::vector<double> heights = asDefined(bent.refinement, bent.mesh.positions, raw, wanted);
    for (std::size_t v = 0; v < raw.size(); ++v) {
      ASSERT_NEAR(static_cast<double>(bent.heights[v]), heights[v], 1e-6) << v;
      if (raw[v] == 0.0f) continue;
      ASSERT_NEAR(static_cast<double>(weights[v]), wanted[v], 1e-5) << v;
    }
  }
}

TEST(LiftFilter, GivesTheSameBitsOnEveryInstructionSet) {
  Heights sheet;
  const std::vector<float> raw = sheet.disc(kEdge, 0.25f);
  sheet.filtered(raw);
  const std::vector<float> first = sheet.heights;
  for (const InstructionSet set : availableInstructionSets()) {
    const InstructionSetScope scope(set);
    sheet.filtered(raw);
    EXPECT_EQ(sheet.heights, first) << nameOf(set);
  }
}

TEST(LiftFilter, DoesNotDependOnTheOrderOfTriangles) {
  Heights sheet;
  const std::vector<float> raw = sheet.disc(kEdge, 0.25f);
  sheet.filtered(raw);
  const std::vector<float> first = sheet.heights;
  std::ranges::reverse(sheet.mesh.triangles);
  std::ranges::reverse(sheet.refinement.triangles);
  sheet.rings = vertexRings(sheet.refinement);
  sheet.filtered(raw);
  for (std::size_t v = 0; v < first.size(); ++v) EXPECT_NEAR(sheet.heights[v], first[v], 1e-6f) << v;
}

}  // namespace
}  // namespace sinew::test
