// tests/geometry/triangle_tree_test.cpp: rays compared with a test of all triangles.
#include "core/geometry/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace sinew {
namespace {

/// Whether the ray passes through a triangle, by signed volumes with its sides; nullopt: too close to an edge to
/// decide.
std::optional<bool> goesThrough(const TriangleCorners& triangle, const glm::dvec3& from, const glm::dvec3& direction) {
  const glm::dvec3 a = glm::dvec3(triangle[0]) - from;
  const glm::dvec3 b = glm::dvec3(triangle[1]) - from;
  const glm::dvec3 c = glm::dvec3(triangle[2]) - from;
  const double sides[] = {glm::dot(direction, glm::cross(a, b)), glm::dot(direction, glm::cross(b, c)),
                          glm::dot(direction, glm::cross(c, a))};
  bool positive = false;
  bool negative = false;
  for (const double side : sides) {
    if (std::abs(side) < 1e-5) return std::nullopt;
    positive = positive || side > 0.0;
    negative = negative || side < 0.0;
  }
  if (positive && negative) return false;
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double along = glm::dot(a, normal) / glm::dot(direction, normal);
  if (std::abs(along) < 1e-5) return std::nullopt;
  return along > 0.0;
}

TEST(TriangleTree, RayHitsMatchASearch) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> anywhere(-1.0f, 1.0f);
  const auto point = [&](float size) { return size * glm::vec3(anywhere(random), anywhere(random), anywhere(random)); };
  std::vector<TriangleCorners> triangles;
  std::vector<int> numbers;
  for (int i = 0; i < 60; ++i) {
    const glm::vec3 middle = point(1.0f);
    triangles.push_back({middle + point(0.3f), middle + point(0.3f), middle + point(0.3f)});
    numbers.push_back(i);
  }
  const TriangleTree tree(triangles, numbers);
  int met = 0;
  int missed = 0;
  for (int i = 0; i < 4'000; ++i) {
    const glm::vec3 from = point(1.5f);
    glm::vec3 direction = point(1.0f);
    if (i % 4 == 0) direction[i % 3] = 0.0f;
    if (i % 40 == 0) direction[(i + 1) % 3] = 0.0f;  // Along an axis.
    bool expected = false;
    bool isSure = true;
    for (const TriangleCorners& triangle : triangles) {
      const std::optional<bool> through = goesThrough(triangle, from, direction);
      expected = expected || through.value_or(false);
      isSure = isSure && through.has_value();
    }
    if (!isSure && !expected) continue;
    EXPECT_EQ(tree.isMetBy(from, direction), expected) << i;
    ++(expected ? met : missed);
  }
  EXPECT_GT(met, 200);
  EXPECT_GT(missed, 200);
  EXPECT_FALSE(TriangleTree({}, {}).isMetBy(glm::vec3(0.0f), glm::vec3(1.0f)));
}

TEST(TriangleTree, MeetingsOfALineAreAllThatASearchFinds) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> anywhere(-1.0f, 1.0f);
  const auto point = [&](float size) { return size * glm::vec3(anywhere(random), anywhere(random), anywhere(random)); };
  std::vector<TriangleCorners> triangles;
  std::vector<int> numbers;
  for (int i = 0; i < 50; ++i) {
    const glm::vec3 middle = point(1.0f);
    triangles.push_back({middle + point(0.4f), middle + point(0.4f), middle + point(0.4f)});
    numbers.push_back(100 + i);
  }
  const TriangleTree tree(triangles, numbers);
  std::vector<LineMeeting> meetings;
  int found = 0;
  for (int i = 0; i < 2'000; ++i) {
    const glm::vec3 from = point(1.0f);
    const glm::vec3 direction = glm::normalize(point(1.0f));
    tree.meetings(from, direction, -0.5f, 0.8f, meetings);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto& [a, b, c] = triangles[t];
      const glm::dvec3 normal = glm::cross(glm::dvec3(b - a), glm::dvec3(c - a));
      const double along = glm::dot(glm::dvec3(a - from), normal) / glm::dot(glm::dvec3(direction), normal);
      // Seen from far behind, the line is a ray.
      const auto through = goesThrough(triangles[t], glm::dvec3(from) - 9.0 * glm::dvec3(direction), direction);
      if (!through || std::abs(along + 0.5) < 1e-4 || std::abs(along - 0.8) < 1e-4) continue;
      const auto same = std::ranges::find(meetings, 100 + static_cast<int>(t), &LineMeeting::triangle);
      ASSERT_EQ(same != meetings.end(), *through && along > -0.5 && along < 0.8) << i << ' ' << t;
      if (same == meetings.end()) continue;
      EXPECT_NEAR(same->along, along, 1e-3);
      ++found;
    }
  }
  EXPECT_GT(found, 200);
}

}  // namespace
}  // namespace sinew
