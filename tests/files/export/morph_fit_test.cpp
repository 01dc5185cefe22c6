// tests/files/export/morph_fit_test.cpp: smallest sufficient number of targets, for displacements of known rank.
#include "core/files/fit/morph_fit.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace sinew::exporting {
namespace {

constexpr int kFrames = 40;
constexpr int kVertices = 60;
constexpr double kHeight = 2.0;

/// Vertices of two mesh spaces on two joints; the live surface combines shapes with curves.
class MorphTargetFit : public ::testing::Test {
 protected:
  void SetUp() override {
    spaces_ = {glm::dmat3(1.0), glm::dmat3(glm::scale(glm::dmat4(1.0), glm::dvec3(-0.01, 0.02, 0.01)))};
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    for (int v = 0; v < kVertices; ++v) {
      const float share = static_cast<float>(v) / kVertices;
      vertices_.push_back(
          {v, v % 2, {place(random_), place(random_), place(random_)}, {{0, 1, -1, -1}, {1.0f - share, share}}});
    }
  }

  static std::vector<glm::dmat4> matricesAt(int frame) {
    return {glm::dmat4(1.0), glm::rotate(glm::dmat4(1.0), 0.02 * frame, glm::dvec3(0.0, 0.6, 0.8))};
  }

  /// @param shapes  of displacements in the bind pose  @param curve  weight of a shape in a frame
  template <class Curve>
  MorphFit fitOf(int shapes, Curve curve) {
    std::normal_distribution<double> way(0.0, 0.05);
    std::vector<std::vector<glm::dvec3>> moved(static_cast<std::size_t>(shapes));
    for (auto& shape : moved) {
      for (int v = 0; v < kVertices; ++v) shape.emplace_back(way(random_), way(random_), way(random_));
    }
    MorphFit fit(vertices_, spaces_, kHeight);
    for (int frame = 0; frame < kFrames; ++frame) {
      std::vector<glm::vec3> live;
      for (std::size_t v = 0; v < vertices_.size(); ++v) {
        glm::dvec3 point = vertices_[v].rest;
        for (std::size_t k = 0; k < moved.size(); ++k) point += curve(static_cast<int>(k), frame) * moved[k][v];
        live.emplace_back(skinPoint(matricesAt(frame), vertices_[v].weights, point));
      }
      live_.push_back(live);
      fit.add(matricesAt(frame), live);
    }
    return fit;
  }

  /// Largest distance with the file's contents.
  [[nodiscard]] double worst(const MorphTargets& targets) const {
    double worst = 0.0;
    for (std::size_t frame = 0; frame < live_.size(); ++frame) {
      for (std::size_t v = 0; v < vertices_.size(); ++v) {
        glm::dvec3 delta(0.0);
        for (std::size_t k = 0; k < targets.deltas.size(); ++k) {
          delta += static_cast<double>(targets.weights[frame * targets.deltas.size() + k]) *
                   glm::dvec3(targets.deltas[k][v]);
        }
        const glm::dvec3 point = vertices_[v].rest + spaces_[static_cast<std::size_t>(vertices_[v].space)] * delta;
        const glm::dvec3 shown = skinPoint(matricesAt(static_cast<int>(frame)), vertices_[v].weights, point);
        worst = std::max(worst, glm::distance(shown, glm::dvec3(live_[frame][v])));
      }
    }
    return worst;
  }

  std::mt19937 random_{5};
  std::vector<glm::dmat3> spaces_;
  std::vector<MorphVertex> vertices_;
  std::vector<std::vector<glm::vec3>> live_;
};

double wave(int shape, int frame) { return std::sin(0.11 * (shape + 1) * frame) / (1.0 + shape); }

TEST_F(MorphTargetFit, FindsAboutAsManyTargetsAsShapes) {
  const MorphFit fit = fitOf(4, wave);
  const auto targets = fit.solve(2e-4, StageProgress({}));
  ASSERT_TRUE(targets);
  EXPECT_GE(targets->count, 4);
  EXPECT_LE(targets->count, 5) << "one more at most, for weights from 0 to 1";
  EXPECT_LE(worst(*targets), 2e-4);
  EXPECT_NEAR(targets->figures.largest, 100.0 / kHeight * worst(*targets), 1e-4);
  for (const float weight : targets->weights) {
    EXPECT_GE(weight, 0.0f);
    EXPECT_LE(weight, 1.0f);
  }
}

TEST_F(MorphTargetFit, MeetsEveryBoundAndLooserBoundsNeedNoMoreTargets) {
  const MorphFit fit = fitOf(12, wave);
  int before = kFrames;
  for (const double bound : {1e-4, 1e-3, 1e-2, 0.1, 1.0}) {
    const auto targets = fit.solve(bound, StageProgress({}));
    ASSERT_TRUE(targets);
    EXPECT_LE(worst(*targets), bound);
    EXPECT_LE(targets->count, before) << bound;
    before = targets->count;
  }
  EXPECT_EQ(before, 0);
}

/// A few vertices with a large error vanish in a sum of squares: principal components alone would treat them last.
TEST_F(MorphTargetFit, BoundAppliesToTheFarthestVertex) {
  const auto curve = [](int shape, int frame) { return shape == 0 ? 1e-3 * (frame % 2) : wave(shape, frame); };
  const MorphFit fit = fitOf(3, curve);
  const auto targets = fit.solve(1.5e-5, StageProgress({}));
  ASSERT_TRUE(targets);
  EXPECT_LE(worst(*targets), 1.5e-5);
  EXPECT_GE(targets->count, 3);
}

TEST_F(MorphTargetFit, JointsThatFlattenVerticesFail) {
  MorphFit fit(vertices_, spaces_, kHeight);
  std::vector<glm::vec3> live;
  for (const MorphVertex& vertex : vertices_) live.emplace_back(0.1 * vertex.rest);
  fit.add({glm::dmat4(0.0), glm::dmat4(0.0)}, live);
  EXPECT_FALSE(fit.solve(1e-3, StageProgress({})));
  EXPECT_TRUE(fit.solve(1.0, StageProgress({})));
  // Nearly flat: the rest of a direction is used.
  MorphFit thin(vertices_, spaces_, kHeight);
  const glm::dmat4 flat = glm::scale(glm::dmat4(1.0), glm::dvec3(1.0, 1.0, 0.05));
  for (std::size_t v = 0; v < live.size(); ++v) live[v] = glm::vec3(vertices_[v].rest) * glm::vec3(1.1f, 0.9f, 0.05f);
  thin.add({flat, flat}, live);
  EXPECT_TRUE(thin.solve(1e-3, StageProgress({})));
}

}  // namespace
}  // namespace sinew::exporting
