// tests/geometry/weld_pieces_test.cpp: pieces rounded apart by compression are joined to one skin.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "tests/geometry/soups.h"

namespace sinew {
namespace {

constexpr float kPieceTolerance = 1e-6f;

/// A torus in two pieces, positions and weights of each rounded to its own steps.
TriangleSoup inRoundedPieces(const TriangleSoup& whole, std::uint32_t trianglesInFirst, float step, float weightStep) {
  TriangleSoup soup;
  soup.pieces.assign(2, {0.87f * step, 2.5f * weightStep});
  for (int piece = 0; piece < 2; ++piece) {
    const float shift = 0.4f * static_cast<float>(piece);
    const auto rounded = [&](float value, float by) { return (std::round(value / by - shift) + shift) * by; };
    std::map<std::uint32_t, std::uint32_t> own;
    for (std::uint32_t t = 0; t < whole.triangles.size(); ++t) {
      if ((t < trianglesInFirst) != (piece == 0)) continue;
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = whole.triangles[t][k];
        const auto [found, isNew] = own.try_emplace(v, static_cast<std::uint32_t>(soup.positions.size()));
        corners[k] = found->second;
        if (!isNew) continue;
        glm::vec3 p = whole.positions[v];
        for (int axis = 0; axis < 3; ++axis) p[axis] = rounded(p[axis], step);
        std::vector<Influence> weights;
        float sum = 0.0f;
        for (const Influence& influence : influencesOf(whole, v)) {
          const float weight = std::max(rounded(influence.weight, weightStep), 0.0f);
          if (weight > 0.0f) weights.push_back({influence.binding, weight});
          sum += weight;
        }
        for (Influence& influence : weights) influence.weight /= sum;
        addVertex(soup, p, whole.uvs[v], weights);
        soup.pieceOf.push_back(piece);
      }
      addTriangle(soup, corners[0], corners[1], corners[2]);
    }
  }
  return soup;
}

TEST(Weld, PiecesSeparatedByRoundingAreJoined) {
  const TriangleSoup whole = torus(40, 23);
  const ControlMesh expected = weld(whole, kPieceTolerance);
  for (const float step : {1e-5f, 1e-4f, 1e-3f}) {
    for (const float weightStep : {1.0f / 4095.0f, 1.0f / 255.0f}) {
      TriangleSoup soup = inRoundedPieces(whole, 2 * 23 * 17, step, weightStep);
      const ControlMesh mesh = weld(soup, kPieceTolerance);
      EXPECT_EQ(mesh.positions.size(), expected.positions.size()) << step;
      EXPECT_EQ(mesh.edges.size(), expected.edges.size()) << step;
      EXPECT_EQ(mesh.trianglesDropped, 0);
      soup.pieces.clear();
      soup.pieceOf.clear();
      EXPECT_GT(weld(soup, kPieceTolerance).positions.size(), expected.positions.size()) << "that is what joins them";
    }
  }
}

TEST(Weld, RoundingToleranceAppliesOnlyBetweenPieces) {
  TriangleSoup soup = hinge({{0, 1.0f}}, {{0, 1.0f}});
  for (const std::size_t v : {3u, 4u}) soup.positions[v].z = 1e-4f;
  soup.pieces.assign(2, {1e-3f, 0.01f});
  soup.pieceOf = {0, 0, 0, 0, 0, 0};
  EXPECT_EQ(weld(soup, kPieceTolerance).positions.size(), 6u);
  soup.pieceOf = {0, 0, 0, 1, 1, 1};
  EXPECT_EQ(weld(soup, kPieceTolerance).positions.size(), 4u);
  soup.positions[3].z = 2.1e-3f;
  EXPECT_EQ(weld(soup, kPieceTolerance).positions.size(), 5u) << "farther than rounding goes";
}

}  // namespace
}  // namespace sinew
