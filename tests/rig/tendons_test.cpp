// tests/rig/tendons_test.cpp: tendons leave their belly tangentially, pass the via point smoothly and end at the
// anchors.
#include "core/rig/line_rest.h"

#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace sinew::test {
namespace {

/// A spindle from y = -0.5 to 0.5 on a line from y = -1 to 1.
const glm::mat4 kBelly = glm::scale(glm::mat4(1), glm::vec3(0.2f, 0.5f, 0.1f));
const LinePath kLine{{0.1f, -1.0f, 0.0f}, std::nullopt, {0.0f, 1.0f, 0.1f}};

glm::vec3 beginning(const Tendon& tendon) { return tendon.parts.front().curve[0]; }
glm::vec3 ending(const Tendon& tendon) { return tendon.parts.back().curve[3]; }

TEST(Tendons, RunFromInsideTheBellyToBothAnchors) {
  for (const float flip : {1.0f, -1.0f}) {  // The belly's y may point either way along the line.
    const std::vector<Tendon> tendons = tendonsOf(glm::scale(kBelly, glm::vec3(1, flip, 1)), kLine);
    ASSERT_EQ(tendons.size(), 2u);
    EXPECT_EQ(ending(tendons[0]), kLine.origin);
    EXPECT_EQ(ending(tendons[1]), kLine.insertion);
    EXPECT_EQ(tendons[0].side, -flip);
    EXPECT_EQ(tendons[1].side, flip);
    for (const Tendon& tendon : tendons) {
      EXPECT_NEAR(beginning(tendon).y, tendon.side * flip * 0.5f * kTendonStart, 1e-6f);
      EXPECT_NEAR(tendon.length, glm::distance(beginning(tendon), ending(tendon)), 1e-6f);
      const glm::vec3 leaves = tendon.parts[0].curve[1] - tendon.parts[0].curve[0];
      EXPECT_NEAR(glm::dot(glm::normalize(leaves), glm::vec3(0, tendon.side * flip, 0)), 1.0f, 1e-6f);
    }
  }
}

TEST(Tendons, PassSmoothlyThroughTheViaPoint) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> aside(-0.4f, 0.4f), along(0.55f, 0.95f);
  for (int i = 0; i < 100; ++i) {
    LinePath line = kLine;
    line.via = glm::vec3(aside(random), (i % 2 == 0 ? 1.0f : -1.0f) * along(random), aside(random));
    const std::vector<Tendon> tendons = tendonsOf(kBelly, line);
    ASSERT_EQ(tendons.size(), 2u);
    const auto with = static_cast<std::size_t>(i % 2 == 0 ? 1 : 0);
    EXPECT_EQ(tendons[1 - with].parts.size(), 1u);
    const std::vector<TendonPart>& parts = tendons[with].parts;
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].curve[3], *line.via);
    EXPECT_EQ(parts[1].curve[0], *line.via);
    const glm::vec3 before = glm::normalize(parts[0].curve[3] - parts[0].curve[2]);
    const glm::vec3 after = glm::normalize(parts[1].curve[1] - parts[1].curve[0]);
    EXPECT_LT(glm::distance(before, after), 1e-4f);
    EXPECT_EQ(parts[0].share, glm::vec2(0.0f, parts[1].share.x));
    EXPECT_EQ(parts[1].share.y, 1.0f);
    EXPECT_NEAR(parts[1].share.x * tendons[with].length, glm::distance(parts[0].curve[0], *line.via), 1e-5f);
  }
}

TEST(Tendons, LeaveABentBellyAlongItsAxis) {
  const glm::vec2 bend(0.8f, -0.5f);
  const auto axis = [&](float y) {
    return glm::vec3(kBelly * glm::vec4(bend.x * (1 - y * y), y, bend.y * (1 - y * y), 1));
  };
  for (const Tendon& tendon : tendonsOf(kBelly, kLine, bend)) {
    const float y = kTendonStart * tendon.side;
    EXPECT_LT(glm::distance(beginning(tendon), axis(y)), 1e-6f);
    const glm::vec3 along = glm::normalize(axis(y + 1e-3f * tendon.side) - axis(y - 1e-3f * tendon.side));
    EXPECT_GT(glm::dot(glm::normalize(tendon.parts[0].curve[1] - beginning(tendon)), along), 0.9999f);
  }
}

TEST(Tendons, AreOmittedForAnchorsInsideTheBelly) {
  LinePath line = kLine;
  line.insertion = {0.0f, 0.3f, 0.0f};
  const std::vector<Tendon> tendons = tendonsOf(kBelly, line);
  ASSERT_EQ(tendons.size(), 1u);
  EXPECT_EQ(ending(tendons[0]), line.origin);
  EXPECT_TRUE(tendonsOf(glm::scale(kBelly, glm::vec3(1, 0, 1)), kLine).empty()) << "a flat belly has no ends";
}

TEST(Tendons, PointsAlongALineMatchItsAnchors) {
  EXPECT_EQ(pointsAlong(kLine).front(), kLine.origin);
  EXPECT_LT(glm::distance(pointsAlong(kLine).back(), kLine.insertion), 1e-6f);
  LinePath bent = kLine;
  bent.via = glm::vec3(0.4f, 0.2f, -0.1f);
  const std::vector<glm::vec3> points = pointsAlong(bent);
  EXPECT_LT(glm::distance(points[points.size() / 2], *bent.via), 1e-6f);
  for (std::size_t i = 2; i < points.size(); ++i) {
    const glm::vec3 before = glm::normalize(points[i - 1] - points[i - 2]);
    EXPECT_GT(glm::dot(before, glm::normalize(points[i] - points[i - 1])), 0.95f) << "a corner at " << i;
  }
}

}  // namespace
}  // namespace sinew::test
