// tests/rig/field_test.cpp: sums, maxima, carves, gradients.
#include "core/rig/field.h"

#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/geometry/potential.h"

namespace sinew {
namespace {

PosedPrimitive sphere(const glm::vec3& center, float radius, float strength = 1.0f) {
  Placement placement;
  placement.center = center;
  placement.radii = glm::vec3(radius);
  return {unitBallMap(placement, 1.4142135f, glm::mat4(1.0f)), strength};
}

TEST(Field, LoneSphereHasTheIsoValueOnItsVisibleSurface) {
  const std::vector<PosedPrimitive> one{sphere({1, 2, 3}, 0.5f)};
  const std::vector<Candidate> all{{0, 1.0f, 0}};
  EXPECT_NEAR(sampleField(one, all, {}, {1.5f, 2, 3}).value, 0.25f, 1e-5f);
  EXPECT_EQ(sampleField(one, all, {}, {1.0f, 2, 3.8f}).value, 0.0f);
}

TEST(Field, ChainBlendsWithTheMiddleOnly) {
  const std::vector<PosedPrimitive> three{sphere({0, 0, 0}, 1), sphere({0.2f, 0, 0}, 1), sphere({0.4f, 0, 0}, 1)};
  const std::vector<Candidate> all{{0, 1.0f, 0}, {1, 1.0f, 1}, {2, 1.0f, 2}};
  const glm::vec3 x(0.3f, 0.5f, 0.1f);
  std::array<float, 3> f{};
  for (std::size_t i = 0; i < 3; ++i) f[i] = sampleField(three, std::span(all).subspan(i, 1), {}, x).value;
  const CliqueLevels chain{{1.0, {{0, 1}, {1, 2}}}};
  EXPECT_NEAR(sampleField(three, all, chain, x).value, f[1] + std::max(f[0], f[2]), 1e-6f);
  EXPECT_NEAR(sampleField(three, all, {}, x).value, f[0] + f[1] + f[2], 1e-6f);
}

TEST(Field, CarveIgnoresUnlinkedGroups) {
  const std::vector<PosedPrimitive> two{sphere({0, 0, 0}, 1, -1.0f), sphere({9, 0, 0}, 1)};
  const std::vector<Candidate> all{{0, 1.0f, 0}, {1, 1.0f, 1}};
  const CliqueLevels unlinked{{1.0, {{0}, {1}}}};
  const glm::vec3 x(0.2f, 0.1f, 0);
  const float alone = sampleField(two, std::span(all).first(1), {}, x).value;
  EXPECT_LT(alone, 0.0f);
  EXPECT_EQ(sampleField(two, all, unlinked, x).value, alone) << "a far, unlinked group must not undo a carve";
}

TEST(Field, GradientMatchesDifferences) {
  std::mt19937 random(17);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  std::vector<PosedPrimitive> some;
  std::vector<Candidate> all;
  for (int i = 0; i < 6; ++i) {
    some.push_back(sphere({unit(random), unit(random), unit(random)}, 0.6f, i == 5 ? -0.7f : 1.0f));
    all.push_back({i, 0.5f + 0.5f * unit(random), i % 3});
  }
  const CliqueLevels cliques{{1.0, {{0, 1}, {1, 2}}}};
  int compared = 0;
  for (int round = 0; round < 2000; ++round) {
    const glm::vec3 x(unit(random), unit(random), unit(random));
    const FieldSample here = sampleField(some, all, cliques, x);
    glm::vec3 numeric;
    float curvature = 0.0f;
    constexpr float kStep = 2e-3f;
    for (int axis = 0; axis < 3; ++axis) {
      glm::vec3 step(0.0f);
      step[axis] = kStep;
      const float up = sampleField(some, all, cliques, x + step).value;
      const float down = sampleField(some, all, cliques, x - step).value;
      numeric[axis] = (up - down) / (2 * kStep);
      curvature = std::max(curvature, std::abs(up + down - 2 * here.value) / (kStep * kStep));
    }
    if (curvature > 30.0f) continue;  // a crease between cliques runs through the stencil
    ++compared;
    EXPECT_NEAR(glm::distance(here.gradient, numeric), 0.0f, 0.02f) << "round " << round;
  }
  EXPECT_GT(compared, 1500);
}

// Between a muscle and its mirror image both sums are equal: the gradient leans to neither side.
TEST(Field, GradientBetweenMirroredMusclesLiesInThePlane) {
  const std::vector<PosedPrimitive> two{sphere({-0.4f, 0, 0}, 0.8f), sphere({0.4f, 0, 0}, 0.8f)};
  const std::vector<Candidate> all{{0, 1.0f, 0}, {1, 1.0f, 1}, {1, 0.0f, 2}, {1, 1e-6f, 3}};
  // The second one is in three cliques, next to a group that adds nothing here and one that adds almost nothing: they
  // must not count as another one.
  const CliqueLevels unlinked{{1.0, {{0}, {1, 2}, {1}, {1, 3}}}};
  const auto gradientAt = [&](float x) { return sampleField(two, all, unlinked, {x, 0.5f, 0.1f}).gradient; };
  const glm::vec3 between = gradientAt(0.0f);
  const glm::vec3 beside = gradientAt(0.01f);
  EXPECT_GT(std::abs(beside.x), 0.3f * glm::length(beside)) << "a crease runs here";
  EXPECT_NEAR(between.x, 0.0f, 4e-3f * glm::length(between));
  EXPECT_NEAR(between.y, beside.y, 0.05f * std::abs(beside.y));
  const std::span<const Candidate> right = std::span(all).subspan(1, 1);
  const glm::vec3 alone = sampleField(two, right, {}, {0.01f, 0.5f, 0.1f}).gradient;
  EXPECT_LT(glm::distance(beside, alone), 1e-5f * glm::length(alone)) << "away from the tie: of one alone";
  glm::vec3 before = gradientAt(-1e-4f);
  for (float x = -1e-4f; x <= 1e-4f; x += 1e-7f) {
    const glm::vec3 now = gradientAt(x);
    EXPECT_LT(glm::distance(now, before), 0.02f * glm::length(now)) << x;
    before = now;
  }
}

// An empty clique ties with one that is nearly empty, and must not count.
TEST(Field, GradientNearARimIgnoresDistantMuscles) {
  const std::vector<PosedPrimitive> two{sphere({0, 0, 0}, 1), sphere({100, 0, 0}, 1)};
  const std::vector<Candidate> all{{0, 1.0f, 0}, {1, 1.0f, 1}};
  const CliqueLevels unlinked{{1.0, {{0}, {1}}}};
  for (const float x : {1.0f, 1.40f, 1.409f, 1.413f, 1.4141f}) {
    const glm::vec3 point(x, 0, 0);
    EXPECT_EQ(sampleField(two, all, unlinked, point).gradient,
              sampleField(two, std::span(all).first(1), {}, point).gradient)
        << x;
  }
}

TEST(Field, SharesAreDerivativesByEachMuscle) {
  std::mt19937 random(23);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  const CliqueLevels chain{{1.0, {{0, 1}, {1, 2}}}};
  const CliqueLevels inPart{{0.3, {{0, 1}, {1, 2}}}, {0.7, {{0}, {1}, {2}}}};
  int compared = 0;
  int shared = 0;
  int apart = 0;
  for (int round = 0; round < 2000; ++round) {
    std::vector<PosedPrimitive> some;
    std::vector<Candidate> all;
    for (int i = 0; i < 6; ++i) {
      some.push_back(sphere({unit(random), unit(random), unit(random)}, 0.6f, i == 5 ? -0.7f : 1.0f));
      some.back().groove = round % 2 == 0 ? 0.0f : 0.8f;
      all.push_back({i, 0.6f + 0.4f * unit(random), i % 3});
    }
    const CliqueLevelsView levels = round % 3 == 0 ? CliqueLevelsView() : round % 3 == 1 ? chain : inPart;
    const glm::vec3 x = 0.8f * glm::vec3(unit(random), unit(random), unit(random));
    FieldScratch scratch;
    std::vector<float> shares;
    fieldShares(some, all, levels, x, scratch, shares);
    ASSERT_EQ(shares.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::array<float, 2> values{};
      std::array<float, 2> own{};
      for (std::size_t side = 0; side < 2; ++side) {
        std::vector<Candidate> changed = all;
        changed[i].weight *= side == 0 ? 0.98f : 1.02f;
        values[side] = sampleField(some, changed, levels, x).value;
        own[side] = sampleField(some, std::span(changed).subspan(i, 1), {}, x).value;
      }
      if (std::abs(own[1] - own[0]) < 1e-3f) continue;
      const float measured = (values[1] - values[0]) / (own[1] - own[0]);
      if (measured > 0.02f && measured < 0.98f) ++shared;
      if (std::abs(shares[i] - measured) > 0.03f) ++apart;  // A difference may span a crease.
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
  EXPECT_GT(shared, 100);
  EXPECT_LT(100 * apart, compared);
}

}  // namespace
}  // namespace sinew
