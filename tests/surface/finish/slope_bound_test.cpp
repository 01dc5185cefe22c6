// tests/surface/finish/slope_bound_test.cpp: heights are lowered to the bounded slope, and no further.

#include "core/surface/finish/lifted_heights.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/surface/sheets.h"

namespace sinew::test {
namespace {

constexpr int kBoundCells = 20;
constexpr float kBoundEdge = 2.0f / kBoundCells;

/// An uneven sheet with edges of any length, and heights over it.
struct Slopes {
  std::vector<glm::vec3> patch;
  std::vector<std::array<int, 3>> triangles;
  Refinement refinement;
  VertexRings rings;

  explicit Slopes(std::uint32_t seed = 3) {
    const Sheet sheet = sheetOf(kBoundCells, [](float, float) { return 0.0f; });
    const ControlMesh mesh = meshOf(sheet.positions, sheet.triangles);
    refinement = refine(mesh, 1);
    patch = mesh.positions;
    triangles = refinement.triangles;
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(-0.4f, 0.4f);
    for (glm::vec3& p : patch) p += kBoundEdge * glm::vec3(unit(random), unit(random), unit(random));
    for (int i = 0; i < 3; ++i) {  // And some of zero length.
      const auto& t = triangles[static_cast<std::size_t>(101 * i + 50)];
      patch[static_cast<std::size_t>(t[1])] = patch[static_cast<std::size_t>(t[0])];
    }
    rings = vertexRings(refinement);
  }

  [[nodiscard]] std::vector<float> bounded(const std::vector<float>& heights) {
    std::vector<glm::vec3> positions = patch;
    for (std::size_t v = 0; v < heights.size(); ++v) positions[v].z += heights[v];
    moved_.corners.resize(patch.size());
    std::iota(moved_.corners.begin(), moved_.corners.end(), 0);
    lifted_.start(rings, moved_, patch, positions, heights);
    lowered.clear();
    std::vector<float> out = heights;
    for (const int v : bound_.lower(lifted_)) {
      lowered.push_back(v);
      at(out, v) = lifted_.height(v);
    }
    return out;
  }

  /// Edges, and pairs of opposite corners across them: for any two triangles that share two vertices.
  [[nodiscard]] std::vector<std::array<int, 2>> steps() const {
    std::vector<std::array<int, 2>> out;
    for (const std::array<int, 3>& t : triangles) {
      for (const std::array<int, 3>& o : triangles) {
        std::vector<int> of;
        for (const int v : t) {
          if (std::ranges::find(o, v) == o.end()) of.push_back(v);
        }
        for (const int v : o) {
          if (std::ranges::find(t, v) == t.end()) of.push_back(v);
        }
        if (of.size() == 2) out.push_back({of[0], of[1]});
      }
      for (const int p : t) {
        for (const int q : t) {
          if (p != q) out.push_back({p, q});
        }
      }
    }
    return out;
  }

  /// Definition: every step, in double precision, until nothing changes.
  [[nodiscard]] std::vector<double> asDefined(const std::vector<float>& heights) const {
    std::vector<double> out(heights.begin(), heights.end());
    const std::vector<std::array<int, 2>> all = steps();
    for (bool changed = true; changed;) {
      changed = false;
      for (const auto& [p, q] : all) {
        const double sign = at(out, p) < 0.0 ? -1.0 : 1.0;
        const double most =
            std::max(0.0, sign * at(out, q)) + 1.5 * glm::distance(glm::dvec3(at(patch, p)), glm::dvec3(at(patch, q)));
        if (sign * at(out, p) <= most + 1e-14) continue;
        at(out, p) = sign * most;
        changed = true;
      }
    }
    return out;
  }

  std::vector<int> lowered;

 private:
  MovedTriangles moved_;
  LiftedHeights lifted_;
  SlopeBound bound_;
};

/// Hills and pits with cliffs, partly flat.
std::vector<float> cliffs(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  std::vector<float> out;
  for (std::size_t v = 0; v < count; ++v) {
    const float height = unit(random) < 0.3f ? 0.0f : 8.0f * kBoundEdge * (unit(random) - 0.3f);
    out.push_back(height);
  }
  return out;
}

TEST(SlopeBound, MatchesItsDefinition) {
  Slopes sheet;
  for (const std::uint32_t seed : {1u, 2u, 3u, 4u}) {
    std::vector<float> raw = cliffs(sheet.patch.size(), seed);
    if (seed > 2) {  // A wide plateau that the bound erodes from its rim.
      for (std::size_t v = 0; v < raw.size(); ++v)
        raw[v] = glm::length(sheet.patch[v]) < 0.7f ? 10.0f * kBoundEdge : 0.0f;
      if (seed > 3) std::ranges::transform(raw, raw.begin(), std::negate<>());
    }
    const std::vector<float> bounded = sheet.bounded(raw);
    const std::vector<double> wanted = sheet.asDefined(raw);
    int lower = 0;
    for (std::size_t v = 0; v < raw.size(); ++v) {
      ASSERT_NEAR(static_cast<double>(bounded[v]), wanted[v], 1e-6) << v;
      EXPECT_LE(std::abs(bounded[v]), std::abs(raw[v]));
      EXPECT_GE(bounded[v] * raw[v], 0.0f);
      lower += bounded[v] != raw[v] ? 1 : 0;
    }
    EXPECT_GT(lower, 50);
    std::ranges::sort(sheet.lowered);
    EXPECT_EQ(std::ranges::adjacent_find(sheet.lowered), sheet.lowered.end()) << "each once";
    EXPECT_EQ(static_cast<int>(sheet.lowered.size()), lower);
    EXPECT_EQ(sheet.bounded(bounded), bounded) << "what is bounded stays";
  }
}

TEST(SlopeBound, LeavesGentleSlopesUnchangedBitForBit) {
  Slopes sheet;
  std::vector<float> raw;
  for (const glm::vec3& p : sheet.patch) raw.push_back(std::max(0.0f, 0.6f - 1.2f * std::hypot(p.x, p.y)));
  EXPECT_EQ(sheet.bounded(raw), raw);
  EXPECT_TRUE(sheet.lowered.empty());
}

// A jump of one vertex may lower others, but by no more than its own height.
TEST(SlopeBound, AmplifiesNothing) {
  Slopes sheet;
  std::mt19937 random(9);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  for (const float noise : {1e-5f, 1e-3f, 0.3f}) {
    const std::vector<float> raw = cliffs(sheet.patch.size(), 5);
    std::vector<float> other = raw;
    float most = 0.0f;
    for (std::size_t v = 0; v < raw.size(); ++v) {
      if (raw[v] != 0.0f) other[v] += noise * unit(random);
      most = std::max(most, std::abs(other[v] - raw[v]));
    }
    const std::vector<float> a = sheet.bounded(raw);
    const std::vector<float> b = sheet.bounded(other);
    for (std::size_t v = 0; v < raw.size(); ++v) EXPECT_LE(std::abs(a[v] - b[v]), most + 2e-7f) << v;
  }
}

// Along edges alone a cone's rim would be a polygon, up to 15 % too high between the edge directions.
TEST(SlopeBound, IsNearlyIsotropic) {
  const Sheet flat = sheetOf(40, [](float, float) { return 0.0f; });
  Slopes sheet;
  const ControlMesh mesh = meshOf(flat.positions, flat.triangles);
  sheet.refinement = refine(mesh, 1);
  sheet.patch = mesh.positions;
  sheet.rings = vertexRings(sheet.refinement);
  std::vector<float> raw(sheet.patch.size(), 10.0f);
  const auto center = std::ranges::find_if(sheet.patch, [](const glm::vec3& p) { return glm::length(p) < 1e-3f; });
  ASSERT_NE(center, sheet.patch.end());
  raw[static_cast<std::size_t>(center - sheet.patch.begin())] = 0.0f;
  const std::vector<float> bounded = sheet.bounded(raw);
  for (std::size_t v = 0; v < raw.size(); ++v) {
    const float cone = SlopeBound::kSlope * glm::length(sheet.patch[v]);
    EXPECT_GE(bounded[v], cone * 0.9999f) << v;
    EXPECT_LE(bounded[v], cone * 1.09f) << v;
  }
}

// Randomly renumbered vertices: the same bits, though everything is found in another order.
TEST(SlopeBound, DoesNotDependOnVertexOrder) {
  Slopes sheet;
  const std::vector<float> raw = cliffs(sheet.patch.size(), 6);
  const std::vector<float> first = sheet.bounded(raw);
  std::vector<int> to(raw.size());
  std::iota(to.begin(), to.end(), 0);
  std::ranges::shuffle(to, std::mt19937(11));
  Slopes other;
  std::vector<float> moved(raw.size());
  for (std::size_t v = 0; v < raw.size(); ++v) {
    at(other.patch, to[v]) = sheet.patch[v];
    at(moved, to[v]) = raw[v];
  }
  for (std::array<int, 3>& t : other.refinement.triangles) {
    for (int& v : t) v = at(to, v);
  }
  std::ranges::reverse(other.refinement.triangles);
  std::ranges::fill(other.refinement.trianglesAt, 0);
  for (const std::array<int, 3>& t : other.refinement.triangles) {
    for (const int v : t) ++at(other.refinement.trianglesAt, v);
  }
  other.rings = vertexRings(other.refinement);
  const std::vector<float> second = other.bounded(moved);
  for (std::size_t v = 0; v < raw.size(); ++v) EXPECT_EQ(at(second, to[v]), first[v]) << v;
}

TEST(SlopeBound, GivesTheSameBitsOnEveryInstructionSet) {
  Slopes sheet;
  const std::vector<float> raw = cliffs(sheet.patch.size(), 7);
  const std::vector<float> first = sheet.bounded(raw);
  for (const InstructionSet set : availableInstructionSets()) {
    const InstructionSetScope scope(set);
    EXPECT_EQ(sheet.bounded(raw), first) << nameOf(set);
  }
}

}  // namespace
}  // namespace sinew::test
