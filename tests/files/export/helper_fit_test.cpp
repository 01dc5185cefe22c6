// tests/files/export/helper_fit_test.cpp: hidden joints are recovered; helpers never increase the error.
#include "core/files/fit/helper_fit.h"

#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace sinew::exporting {
namespace {

constexpr int kSide = 24;  ///< Vertices along each side of a square sheet.

/// One bone that only rotates, and a sheet on it with independently moving patches.
struct Sheet {
  Skeleton skeleton;
  std::vector<glm::vec3> rest;
  std::vector<std::array<int, 3>> triangles;
  std::vector<FitPose> poses;
  std::vector<FourWeights> start;

  [[nodiscard]] HelperTask task(double furtherShare = 1.0) const {
    return {skeleton, rest, triangles, poses, {}, furtherShare, 1.0};
  }
  /// Root mean square over poses that are not further ones; [helpers] their motions are solved for.
  [[nodiscard]] double error(const HelperResult& result) const {
    const HelperMotion motion(skeleton, rest, result.weights, result.helpers, 1);
    double sum = 0.0;
    double count = 0.0;
    for (const FitPose& pose : poses) {
      if (pose.further) continue;
      std::vector<Trs> locals;
      for (const HelperJoint& helper : result.helpers) locals.push_back(helper.rest);
      motion.solve(pose.pose, pose.matrices, pose.live, 8, locals);
      std::vector<glm::dmat4> matrices = pose.matrices;
      for (std::size_t h = 0; h < locals.size(); ++h) {
        matrices.push_back(helperMatrix(result.helpers[h], pose.pose, locals[h]));
      }
      for (std::size_t v = 0; v < rest.size(); ++v) {
        const glm::dvec3 off = skinPoint(matrices, result.weights[v], glm::dvec3(rest[v])) - glm::dvec3(pose.live[v]);
        sum += glm::dot(off, off);
        count += 1.0;
      }
    }
    return std::sqrt(sum / count);
  }
};

double bump(const glm::vec3& point, const glm::dvec3& middle) {
  const double distance = glm::distance(glm::dvec3(point), middle) / 0.2;
  return distance < 1.0 ? (1.0 - distance * distance) * (1.0 - distance * distance) : 0.0;
}

Sheet movingSheet(const std::vector<glm::dvec3>& middles, bool withFurther = false) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  Sheet sheet;
  Bone bone;
  bone.name = "bone";
  sheet.skeleton.nodes.push_back({"bone", -1, {}});
  sheet.skeleton.bones.push_back(bone);
  sheet.skeleton.bindings.push_back({0, glm::mat4(1.0f)});
  finishBones(sheet.skeleton);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      sheet.rest.emplace_back(static_cast<float>(x) / (kSide - 1), static_cast<float>(y) / (kSide - 1), 0.0f);
      sheet.start.push_back({{0, -1, -1, -1}, {1.0f, 0.0f, 0.0f, 0.0f}});
      if (x + 1 == kSide || y + 1 == kSide) continue;
      const int corner = y * kSide + x;
      sheet.triangles.push_back({corner, corner + 1, corner + kSide});
      sheet.triangles.push_back({corner + 1, corner + kSide + 1, corner + kSide});
    }
  }
  for (int p = 0; p < 24; ++p) {
    FitPose pose;
    pose.further = withFurther && p % 3 == 0;
    const glm::dvec3 axis = glm::normalize(glm::dvec3(unit(random), unit(random), 1.5));
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), unit(random), axis);
    pose.pose.boneInWorld = {glm::mat4(turn)};
    pose.matrices = {glm::dmat4(glm::mat4(turn))};
    std::vector<glm::dmat4> hidden;
    for (const glm::dvec3& middle : middles) {
      const glm::dvec3 way = 0.1 * glm::dvec3(unit(random), unit(random), unit(random));
      const glm::dmat4 around = glm::translate(glm::dmat4(1.0), middle + way);
      hidden.push_back(pose.matrices[0] * glm::rotate(around, 0.5 * unit(random), axis) *
                       glm::translate(glm::dmat4(1.0), -middle));
    }
    for (const glm::vec3& point : sheet.rest) {
      glm::dvec3 live(pose.matrices[0] * glm::dvec4(glm::dvec3(point), 1.0));
      for (std::size_t h = 0; h < middles.size(); ++h) {
        const double share = pose.further ? 0.0 : bump(point, middles[h]);
        live += share * (glm::dvec3(hidden[h] * glm::dvec4(glm::dvec3(point), 1.0)) - live);
      }
      pose.live.emplace_back(live);
    }
    sheet.poses.push_back(std::move(pose));
  }
  return sheet;
}

const std::vector<glm::dvec3> kMiddles{{0.25, 0.25, 0.0}, {0.75, 0.3, 0.0}, {0.5, 0.75, 0.0}};

TEST(HelperFit, RestsIfAPoseFlattensTheBone) {
  Sheet sheet = movingSheet(kMiddles);
  for (const double thin : {0.0, 1e-7}) {
    FitPose& pose = sheet.poses[4];
    const glm::dmat4 flat =
        glm::scale(glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(0.0, 1.0, 0.0)), glm::dvec3(thin, 1.0, 1.0));
    pose.pose.boneInWorld = {glm::mat4(flat)};
    pose.matrices = {glm::dmat4(glm::mat4(flat))};
    EXPECT_FALSE(fromWorld(pose.pose, 0).has_value());
    const HelperResult result = fitHelpers(sheet.task(), sheet.start, 3, StageProgress({}));
    ASSERT_EQ(result.helpers.size(), 3u);
    const HelperMotion motion(sheet.skeleton, sheet.rest, result.weights, result.helpers, 1);
    std::vector<Trs> locals(3);
    motion.solve(pose.pose, pose.matrices, pose.live, 2, locals);
    for (std::size_t h = 0; h < 3; ++h) EXPECT_EQ(locals[h].translation, result.helpers[h].rest.translation);
  }
}

/// Uneven and small scale, but not flat.
TEST(HelperFit, ThinBonesCanCarryHelpers) {
  Pose pose;
  pose.boneInWorld = {glm::scale(glm::mat4(1.0f), glm::vec3(1e-3f, 1.0f, 1.0f)),
                      glm::scale(glm::mat4(1.0f), glm::vec3(1e-4f)), glm::mat4(0.0f)};
  EXPECT_TRUE(fromWorld(pose, 0).has_value());
  EXPECT_TRUE(fromWorld(pose, 1).has_value());
  EXPECT_FALSE(fromWorld(pose, 2).has_value());
}

TEST(HelperFit, RecoversHiddenJoints) {
  const Sheet sheet = movingSheet(kMiddles);
  const double before = sheet.error({{}, {}, sheet.start});
  const HelperResult result = fitHelpers(sheet.task(), sheet.start, 3, StageProgress({}));
  ASSERT_EQ(result.helpers.size(), 3u);
  EXPECT_LT(sheet.error(result), 0.1 * before);
  for (const glm::dvec3& middle : kMiddles) {
    double nearest = 1.0;
    for (const HelperJoint& helper : result.helpers) {
      nearest = std::min(nearest, glm::distance(helper.rest.translation, middle));
    }
    EXPECT_LT(nearest, 0.1);
  }
}

TEST(HelperFit, MoreHelpersReduceTheError) {
  const Sheet sheet = movingSheet({{0.2, 0.2, 0.0}, {0.8, 0.2, 0.0}, {0.2, 0.8, 0.0}, {0.8, 0.8, 0.0}});
  double last = sheet.error(fitHelpers(sheet.task(), sheet.start, 0, StageProgress({})));
  EXPECT_NEAR(last, sheet.error({{}, {}, sheet.start}), 1e-9);
  for (const int helpers : {1, 2, 4}) {
    const HelperResult result = fitHelpers(sheet.task(), sheet.start, helpers, StageProgress({}));
    EXPECT_EQ(result.helpers.size(), static_cast<std::size_t>(helpers));
    const double now = sheet.error(result);
    EXPECT_LT(now, last);
    last = now;
  }
}

TEST(HelperFit, WeightsAreValid) {
  const Sheet sheet = movingSheet(kMiddles);
  const HelperResult result = fitHelpers(sheet.task(), sheet.start, 5, StageProgress({}));
  for (const FourWeights& weights : result.weights) {
    float sum = 0.0f;
    for (std::size_t i = 0; i < kMostWeights; ++i) {
      EXPECT_GE(weights.weight[i], 0.0f);
      EXPECT_LT(weights.binding[i], 1 + static_cast<int>(result.helpers.size()));
      EXPECT_EQ(weights.binding[i] < 0, weights.weight[i] == 0.0f);
      sum += weights.weight[i];
    }
    EXPECT_NEAR(sum, 1.0f, 1e-6f);
  }
}

/// Where a helper is at rest, its vertices follow their bone.
TEST(HelperFit, ExcludedPosesAreUnchanged) {
  const Sheet sheet = movingSheet(kMiddles, true);
  const HelperResult result = fitHelpers(sheet.task(), sheet.start, 3, StageProgress({}));
  for (const FitPose& pose : sheet.poses) {
    if (!pose.further) continue;
    std::vector<glm::dmat4> matrices = pose.matrices;
    for (const HelperJoint& helper : result.helpers) matrices.push_back(helperMatrix(helper, pose.pose, helper.rest));
    for (std::size_t v = 0; v < sheet.rest.size(); ++v) {
      const glm::dvec3 point = skinPoint(matrices, result.weights[v], glm::dvec3(sheet.rest[v]));
      EXPECT_LT(glm::distance(point, glm::dvec3(pose.live[v])), 1e-5);
    }
  }
}

TEST(HelperFit, NothingIsAddedIfNothingMoves) {
  const Sheet sheet = movingSheet({});
  const HelperResult result = fitHelpers(sheet.task(), sheet.start, 4, StageProgress({}));
  EXPECT_TRUE(result.helpers.empty());
  EXPECT_EQ(result.weights, sheet.start);
}

}  // namespace
}  // namespace sinew::exporting
