// tests/files/export/fit_sample_test.cpp: sampled vertices are spread evenly over all parts.
#include "core/files/fit/joint_fit.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace sinew::exporting {
namespace {

constexpr std::size_t kMost = 100;

struct Sheets {
  std::vector<glm::vec3> rest;
  std::vector<std::array<int, 3>> triangles;

  /// Adds a separate square with this many vertices along each side.
  void add(int side, float height) {
    const int first = static_cast<int>(rest.size());
    const auto number = [&](int x, int y) { return first + y * side + x; };
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) rest.emplace_back(static_cast<float>(x), static_cast<float>(y), height);
    }
    for (int y = 0; y + 1 < side; ++y) {
      for (int x = 0; x + 1 < side; ++x) {
        triangles.push_back({number(x, y), number(x + 1, y), number(x, y + 1)});
        triangles.push_back({number(x + 1, y), number(x + 1, y + 1), number(x, y + 1)});
      }
    }
  }
};

FourWeights following(int binding) { return fourLargest({{binding, 1.0}}); }

TEST(FitSample, FewVerticesAreAllSampled) {
  Sheets sheets;
  sheets.add(10, 0.0f);
  const FitSample sample = sampleVertices(sheets.rest, sheets.triangles, kMost);
  EXPECT_TRUE(sample.isWhole());
  EXPECT_EQ(sample.vertices.size(), kMost);
  EXPECT_EQ(sample.cell, sample.vertices);
  EXPECT_EQ(sample.triangles, sheets.triangles);
}

TEST(FitSample, ManyVerticesAreSampledEvenly) {
  Sheets sheets;
  sheets.add(60, 0.0f);
  const FitSample sample = sampleVertices(sheets.rest, sheets.triangles, kMost);
  ASSERT_EQ(sample.vertices.size(), kMost);
  EXPECT_FALSE(sample.isWhole());
  EXPECT_TRUE(std::ranges::is_sorted(sample.vertices));
  std::vector<int> sizes(kMost, 0);
  for (const int cell : sample.cell) ++sizes.at(static_cast<std::size_t>(cell));
  EXPECT_GE(std::ranges::min(sizes), 5) << "36 are meant";
  EXPECT_LE(std::ranges::max(sizes), 100);
  for (std::size_t i = 0; i < kMost; ++i) {
    EXPECT_EQ(sample.cell[static_cast<std::size_t>(sample.vertices[i])], static_cast<int>(i));
  }
  EXPECT_GT(sample.triangles.size(), kMost) << "a net between the cells";
  for (const auto& [a, b, c] : sample.triangles) EXPECT_TRUE(a != b && b != c && c != a);
}

TEST(FitSample, EveryPartIsSampled) {
  Sheets sheets;
  sheets.add(60, 0.0f);
  for (int part = 0; part < 20; ++part) sheets.add(2, 100.0f);  // All in the same place.
  sheets.rest.emplace_back(0.0f);                               // Vertex without a triangle.
  const FitSample sample = sampleVertices(sheets.rest, sheets.triangles, kMost);
  EXPECT_GE(sample.vertices.size(), kMost + 15);
  const auto partOf = [](int vertex) { return vertex < 3600 ? -1 : (vertex - 3600) / 4; };
  for (std::size_t v = 0; v < sheets.rest.size(); ++v) {
    ASSERT_GE(sample.cell[v], 0);
    EXPECT_EQ(partOf(sample.vertices[static_cast<std::size_t>(sample.cell[v])]), partOf(static_cast<int>(v)));
  }
}

TEST(FitSample, CandidatesIncludeNeighbors) {
  Sheets sheets;
  sheets.add(60, 0.0f);
  const FitSample sample = sampleVertices(sheets.rest, sheets.triangles, kMost);
  std::vector<FourWeights> weights;
  for (const int v : sample.vertices) weights.push_back(following(v % 60 < 30 ? 1 : 2));
  const std::vector<FourWeights> own(sheets.rest.size(), following(7));
  const auto candidates = candidatesNear(sample, weights, own);
  ASSERT_EQ(candidates.size(), sheets.rest.size());
  EXPECT_EQ(candidates[0], (std::vector{7, 1}));
  EXPECT_EQ(candidates[59], (std::vector{7, 2}));
  EXPECT_EQ(candidates[30].size(), 3U);

  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = following(static_cast<int>(100 + i));
  const std::vector<Share> five{{0, 0.3}, {1, 0.3}, {2, 0.2}, {3, 0.1}, {4, 0.1}};
  const std::vector<FourWeights> four(own.size(), fourLargest(five));
  for (const std::vector<int>& list : candidatesNear(sample, weights, four)) {
    EXPECT_LE(list.size(), kMostNear);
    EXPECT_GT(list.size(), 5U);
    EXPECT_EQ(std::vector(list.begin(), list.begin() + 4), (std::vector{0, 1, 2, 3}));
  }
}

}  // namespace
}  // namespace sinew::exporting
