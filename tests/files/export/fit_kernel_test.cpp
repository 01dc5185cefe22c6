// tests/files/export/fit_kernel_test.cpp: sums of every instruction set equal those of plain loops, bit for bit.

#include "core/files/fit/weight_fit.h"

#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace sinew::exporting {
namespace {

constexpr std::size_t kVertices = 50;
constexpr std::size_t kBindings = 20;
constexpr std::size_t kFirstHelper = 7;  // 13 helpers: one full group and part of another.
constexpr std::size_t kHelpers = kBindings - kFirstHelper;
constexpr std::size_t kPoses = 5;

struct Sums {
  std::mt19937 random{20};
  std::vector<glm::vec3> rest;
  std::vector<std::vector<int>> lists;
  std::vector<std::size_t> begin{0};
  std::vector<FourWeights> weights;
  std::vector<std::vector<glm::dmat4>> matrices;
  std::vector<std::vector<glm::vec3>> live;
  std::vector<PoseToFit> poses;

  Sums() {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto point = [&] { return glm::vec3(glm::dvec3(unit(random), unit(random), unit(random))); };
    for (std::size_t v = 0; v < kVertices; ++v) {
      rest.push_back(point());
      lists.emplace_back();
      for (std::size_t i = 0; i < 1 + v % kMostCandidates; ++i) {
        lists.back().push_back(static_cast<int>((3 * v + i) % kBindings));
      }
      begin.push_back(begin.back() + lists.back().size() * (lists.back().size() + 1) / 2);
      weights.push_back(
          {{static_cast<int>(v % kBindings), static_cast<int>((v + 1) % kBindings), -1, -1}, {0.7f, 0.3f}});
    }
    for (std::size_t f = 0; f < kPoses; ++f) {
      matrices.emplace_back(kBindings);
      for (glm::dmat4& matrix : matrices.back()) {
        for (int c = 0; c < 4; ++c) matrix[c] = {unit(random), unit(random), unit(random), c == 3 ? 1.0 : 0.0};
      }
      live.emplace_back();
      for (std::size_t v = 0; v < kVertices; ++v) live.back().push_back(point());
    }
    for (std::size_t f = 0; f < kPoses; ++f) poses.push_back({matrices[f], live[f], f % 3 == 1});
  }
};

TEST(FitKernel, GramsMatchPlainLoops) {
  const Sums sums;
  std::vector<double> wanted[2] = {std::vector<double>(sums.begin.back(), 0.5),
                                   std::vector<double>(sums.begin.back(), 0.0)};
  for (const PoseToFit& pose : sums.poses) {
    for (std::size_t v = 0; v < kVertices; ++v) {
      double* sum = wanted[pose.further ? 1 : 0].data() + sums.begin[v];
      const auto way = [&](int binding) {
        return glm::dvec3(pose.matrices[static_cast<std::size_t>(binding)] *
                          glm::dvec4(glm::dvec3(sums.rest[v]), 1.0)) -
               glm::dvec3(pose.live[v]);
      };
      for (std::size_t i = 0; i < sums.lists[v].size(); ++i) {
        for (std::size_t k = 0; k <= i; ++k) *sum++ += glm::dot(way(sums.lists[v][i]), way(sums.lists[v][k]));
      }
    }
  }
  for (const InstructionSet set : availableInstructionSets()) {
    if (set == InstructionSet::kScalar) continue;
    // Added to existing sums, and in parts as threads do.
    std::vector<double> own(sums.begin.back(), 0.5);
    std::vector<double> further(sums.begin.back(), 0.0);
    const GramSums task{sums.rest, sums.lists, sums.begin, own.data(), further.data(), sums.poses};
    fitKernels(set).addGrams(task, 0, 17);
    fitKernels(set).addGrams(task, 17, kVertices);
    EXPECT_EQ(own, wanted[0]) << nameOf(set);
    EXPECT_EQ(further, wanted[1]) << nameOf(set);
  }
}

TEST(FitKernel, GainsMatchPlainLoops) {
  const Sums sums;
  constexpr std::size_t kStride = 2 * kHelperGroup;
  std::vector<double> numbers(kPoses * 12 * kStride, 0.0);
  for (std::size_t f = 0; f < kPoses; ++f) {
    for (std::size_t h = 0; h < kHelpers; ++h) {
      for (std::size_t n = 0; n < 12; ++n) {
        numbers[(12 * f + n) * kStride + h] =
            sums.matrices[f][kFirstHelper + h][static_cast<int>(n / 3)][static_cast<int>(n % 3)];
      }
    }
  }
  for (const InstructionSet set : availableInstructionSets()) {
    if (set == InstructionSet::kScalar) continue;
    std::vector<double> toward(kVertices * kStride, 0.0);
    std::vector<double> length(kVertices * kStride, 0.0);
    fitKernels(set).addGains(
        {sums.rest, sums.weights, sums.poses, kStride, numbers.data(), toward.data(), length.data()}, 0, kVertices);
    for (std::size_t v = 0; v < kVertices; ++v) {
      for (std::size_t h = 0; h < kHelpers; ++h) {
        double wantedToward = 0.0;
        double wantedLength = 0.0;
        for (const PoseToFit& pose : sums.poses) {
          if (pose.further) continue;
          const glm::dvec3 now = skinPoint(pose.matrices, sums.weights[v], glm::dvec3(sums.rest[v]));
          const glm::dvec3 way =
              glm::dvec3(pose.matrices[kFirstHelper + h] * glm::dvec4(glm::dvec3(sums.rest[v]), 1.0)) - now;
          wantedToward += glm::dot(glm::dvec3(pose.live[v]) - now, way);
          wantedLength += glm::dot(way, way);
        }
        EXPECT_EQ(toward[v * kStride + h], wantedToward) << nameOf(set);
        EXPECT_EQ(length[v * kStride + h], wantedLength) << nameOf(set);
      }
    }
  }
}

}  // namespace
}  // namespace sinew::exporting
