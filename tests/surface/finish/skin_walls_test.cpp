// tests/surface/finish/skin_walls_test.cpp: nearest skin above and below a place, compared with signed distances of
// balls.
#include "core/surface/finish/skin_walls.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace sinew {
namespace {

constexpr float kRadius = 1.0f;

/// Two balls side by side as fine meshes that face outwards.
struct TwoBalls {
  Refinement refinement;
  std::vector<glm::vec3> positions;
  std::vector<int> triangles;
  std::vector<SkinLayer> layers;

  explicit TwoBalls(float apart) {
    for (const float side : {-0.5f, 0.5f}) addBall(glm::vec3(side * apart, 0.0f, 0.0f));
    refinement.vertexCount = static_cast<int>(positions.size());
    refinement.trianglesAt.assign(positions.size(), 0);
    for (std::size_t t = 0; t < refinement.triangles.size(); ++t) {
      refinement.controlOf.push_back(static_cast<int>(t));
      triangles.push_back(static_cast<int>(t));
      layers.push_back(SkinLayer::kSkin);
      for (const int v : refinement.triangles[t]) ++refinement.trianglesAt[static_cast<std::size_t>(v)];
    }
  }

  void addBall(const glm::vec3& center) {
    constexpr int kAround = 48;
    constexpr int kRings = 24;
    const int first = static_cast<int>(positions.size());
    for (int ring = 0; ring <= kRings; ++ring) {
      const float polar = 3.14159265f * static_cast<float>(ring) / kRings;
      const bool isPole = ring == 0 || ring == kRings;
      for (int i = 0; i < (isPole ? 1 : kAround); ++i) {
        const float turn = 6.2831853f * static_cast<float>(i) / kAround;
        positions.push_back(center + kRadius * glm::vec3(std::sin(polar) * std::cos(turn), std::cos(polar),
                                                         -std::sin(polar) * std::sin(turn)));
      }
    }
    const auto at = [&](int ring, int i) {
      if (ring == 0) return first;
      if (ring == kRings) return first + 1 + (kRings - 1) * kAround;
      return first + 1 + (ring - 1) * kAround + i % kAround;
    };
    for (int ring = 0; ring < kRings; ++ring) {
      for (int i = 0; i < kAround; ++i) {
        if (ring < kRings - 1) refinement.triangles.push_back({at(ring, i), at(ring + 1, i), at(ring + 1, i + 1)});
        if (ring > 0) refinement.triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring, i + 1)});
      }
    }
  }
};

/// Finds walls above and below whatever the bind pose was.
constexpr WallsUnder kAllWalls{glm::vec3(0.0f), glm::vec3(0.0f, 1.0f, 0.0f)};

class SkinWallsOfTwoBalls : public ::testing::TestWithParam<float> {};

TEST_P(SkinWallsOfTwoBalls, MatchSignedDistances) {
  const float apart = GetParam();
  const TwoBalls balls(apart);
  WallTree tree = wallTree(balls.refinement, balls.triangles, balls.positions);
  for (glm::vec3& face : tree.bindFaces) face = kAllWalls.bindFace;
  const VertexRings rings = vertexRings(balls.refinement);
  std::vector<WallNode> nodes;
  const SkinWalls walls(tree, balls.refinement, rings, balls.layers, balls.positions, 100.0f, nodes);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> anywhere(-1.6f, 1.6f);
  constexpr float kFlat = 0.01f;  // Distance of flat triangles to the ball's surface.
  int both = 0;
  for (int i = 0; i < 4'000; ++i) {
    const glm::vec3 p(anywhere(random), anywhere(random), anywhere(random));
    float above = INFINITY;
    float below = INFINITY;
    bool isPlain = true;
    for (const float side : {-0.5f, 0.5f}) {
      const float distance = glm::length(p - glm::vec3(side * apart, 0.0f, 0.0f)) - kRadius;
      isPlain = isPlain && std::abs(distance) > 2.0f * kFlat && distance > -0.5f * kRadius;
      float& nearest = distance > 0.0f ? above : below;
      nearest = std::min(nearest, std::abs(distance));
    }
    if (!isPlain) continue;
    const Walls found = walls.around(p, kAllWalls, 1.0f);
    const float within = SkinWalls::kWallsApart * std::min(above, below);
    const auto expectIs = [&](float expected, float seen) {
      if (expected < std::min(within, 1.0f) - 4.0f * kFlat) {
        EXPECT_NEAR(seen, expected, kFlat);
      } else if (expected > within + 4.0f * kFlat) {
        EXPECT_GT(seen, within - 4.0f * kFlat);
      }
    };
    expectIs(above, found.above);
    expectIs(below, found.below);
    both += std::isfinite(found.above) && std::isfinite(found.below) ? 1 : 0;
    // The fast query gives the same answer.
    SkinWalls::NearNodes memory;
    Bounds box;
    box.add(p - glm::vec3(0.1f));
    box.add(p + glm::vec3(0.1f));
    const float near = std::min(0.4f, SkinWalls::kWallsApart * above);  // Farther skin shows its edge.
    if (std::abs(below - near) < 4.0f * kFlat) continue;
    EXPECT_EQ(walls.isBelowAny(p, kAllWalls, near, walls.nearTo(box, near, memory)), below < near);
  }
  EXPECT_GT(both, 20) << "the balls do not cross where places were tried";
}

INSTANTIATE_TEST_SUITE_P(Apart, SkinWallsOfTwoBalls, ::testing::Values(1.2f, 1.6f, 1.9f));

TEST(SkinWalls, IncludeOnlySkinNearAndAlikeInTheBindPose) {
  const TwoBalls balls(4.0f);
  const WallTree tree = wallTree(balls.refinement, balls.triangles, balls.positions);
  const VertexRings rings = vertexRings(balls.refinement);
  std::vector<WallNode> nodes;
  const SkinWalls walls(tree, balls.refinement, rings, balls.layers, balls.positions, 0.5f, nodes);
  const glm::vec3 inside(2.0f, 0.9f, 0.0f);  // Inside the right ball, below its top.
  const glm::vec3 top(2.0f, 1.0f, 0.0f);
  const glm::vec3 up(0.0f, 1.0f, 0.0f);
  EXPECT_NEAR(walls.around(inside, {top, up}, 1.0f).below, 0.1f, 0.01f);
  EXPECT_EQ(walls.around(inside, {top, -up}, 1.0f).triangle, -1) << "it faced the other way";
  EXPECT_EQ(walls.around(inside, {top + 2.0f * up, up}, 1.0f).triangle, -1) << "it was far away";
  EXPECT_EQ(walls.nearest(glm::vec3(0.0f), 0.9f), -1);
  EXPECT_GE(walls.nearest(top + 0.5f * up, 0.9f), 0);
}

TEST(SkinWalls, FastQueryFindsEveryWallNearTheLimit) {
  TwoBalls balls(4.0f);
  for (glm::vec3& place : balls.positions) {  // Dented.
    place *= 1.0f + 0.08f * std::sin(9.0f * place.x) * std::sin(11.0f * place.y + 2.0f) * std::sin(10.0f * place.z);
  }
  const WallTree tree = wallTree(balls.refinement, balls.triangles, balls.positions);
  const VertexRings rings = vertexRings(balls.refinement);
  std::vector<WallNode> nodes;
  const SkinWalls walls(tree, balls.refinement, rings, balls.layers, balls.positions, 0.6f, nodes);
  std::mt19937 random(11);
  std::normal_distribution<float> spread;
  constexpr float kWithin = 0.3f;
  int below = 0;
  for (int i = 0; i < 300'000; ++i) {
    // Braces: the evaluation order of function arguments is unspecified.
    const auto any = [&] { return glm::normalize(glm::vec3{spread(random), spread(random), spread(random)}); };
    const glm::vec3 way = any();
    const glm::vec3 p = glm::vec3(2.0f, 0.0f, 0.0f) + (1.0f + 0.08f * spread(random)) * way;
    const WallsUnder under{p + 0.3f * any(), any()};
    const Walls found = walls.around(p, under, kWithin);
    // Whether walls behind a much nearer one are found depends on the order.
    if (!(found.below < std::min(kWithin, SkinWalls::kWallsApart * found.above))) continue;
    ++below;
    SkinWalls::NearNodes memory;
    Bounds box;
    box.add(p);
    EXPECT_TRUE(walls.isBelowAny(p, under, kWithin, walls.nearTo(box, kWithin, memory))) << i;
  }
  EXPECT_GT(below, 30'000);
}

}  // namespace
}  // namespace sinew
