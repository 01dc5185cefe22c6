// tests/surface/finish/crease_lift_test.cpp: heights are lowered where a pose folds the control mesh, and nowhere else.

#include "core/surface/finish/crease_lift.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/surface/sheets.h"

namespace sinew::test {
namespace {

/// A flat sheet with its skin lifted by 1, at some detail.
struct CreasedSheet {
  ControlMesh mesh;
  Refinement refinement;
  std::vector<glm::vec3> posed;
  MovedTriangles moved;

  explicit CreasedSheet(const std::function<Refinement(const ControlMesh&)>& refined, float stretch = 1.0f)
      : mesh(sheet(stretch)), refinement(refined(mesh)), posed(mesh.positions) {
    moved.isControl.assign(mesh.triangles.size(), 1);
  }

  /// Folds the middle columns over by the fraction: they run back towards where they came from, normals as in the bind
  /// pose. 0 is flat, 1 completely folded.
  std::vector<float> lowered(float share) {
    posed = mesh.positions;
    for (glm::vec3& p : posed) p.x -= 2.0f * share * std::clamp(p.x, -0.1f, 0.1f);
    std::vector<float> heights(static_cast<std::size_t>(refinement.vertexCount), 1.0f);
    crease_.lower({mesh, bindFrontInverses(mesh), posed, mesh.normals, refinement, vertexRings(refinement)}, moved,
                  heights);
    return heights;
  }

  /// Definition, by vertex and triangle, in double precision.
  [[nodiscard]] std::vector<double> asDefined() const {
    std::vector<double> rho(mesh.positions.size(), 1.0);
    for (const ControlTriangle& t : mesh.triangles) {
      const auto front = [&](const std::vector<glm::vec3>& at) {
        const auto corner = [&](std::size_t i) { return glm::dvec3(at[static_cast<std::size_t>(t.vertices[i])]); };
        const glm::dvec3 u = corner(1) - corner(0);
        const glm::dvec3 v = corner(2) - corner(0);
        return glm::cross(u, v).z / (glm::dot(u, u) + glm::dot(v, v) + glm::dot(u - v, u - v));
      };
      if (front(mesh.positions) <= 0.05) continue;
      for (const int v : t.vertices) {
        double& least = rho[static_cast<std::size_t>(v)];
        least = std::min(least, std::max(-1.0, front(posed) / front(mesh.positions)));
      }
    }
    std::vector<double> out(static_cast<std::size_t>(refinement.vertexCount), 1.0);
    for (std::size_t i = 0; i < refinement.triangles.size(); ++i) {
      const int control = refinement.controlOf[i];
      for (const int v : refinement.triangles[i]) {
        const glm::dvec3 place = controlCoordinates(mesh, refinement, control, v);
        double at = 0.0;
        for (int k = 0; k < 3; ++k) {
          const int corner = mesh.triangles[static_cast<std::size_t>(control)].vertices[static_cast<std::size_t>(k)];
          at += place[k] * rho[static_cast<std::size_t>(corner)];
        }
        const double t = std::clamp((at + 0.3) / 0.7, 0.0, 1.0);
        out[static_cast<std::size_t>(v)] = 0.4 + 0.6 * t * t * (3.0 - 2.0 * t);
      }
    }
    return out;
  }

 private:
  static ControlMesh sheet(float stretch) {
    Sheet out = sheetOf(20, [](float, float) { return 0.0f; });
    for (glm::vec3& p : out.positions) p.y *= stretch;
    return meshOf(out.positions, out.triangles);
  }

  CreaseLift crease_;
};

Refinement coarse(const ControlMesh& mesh) { return refine(mesh, 1); }

/// Arbitrary levels for edges and interiors.
Refinement uneven(const ControlMesh& mesh) {
  RefinementLevels levels = uniformLevels(mesh, 1);
  std::mt19937 random(5);
  for (std::uint8_t& level : levels.edges) level = static_cast<std::uint8_t>(1 + random() % 5);
  for (std::uint8_t& level : levels.triangles) level = static_cast<std::uint8_t>(1 + random() % 5);
  return refine(mesh, levels);
}

TEST(CreaseLift, RemovesThreeFifthsWhereTheSkinFoldsOver) {
  CreasedSheet sheet(coarse);
  const std::vector<float> heights = sheet.lowered(1.0f);
  int creased = 0;
  for (std::size_t v = 0; v < heights.size(); ++v) {
    if (std::abs(sheet.mesh.positions[v].x) < 0.11f) {
      EXPECT_NEAR(heights[v], 0.4f, 1e-6f) << v;
      ++creased;
    } else {
      EXPECT_EQ(heights[v], 1.0f) << v;
    }
  }
  EXPECT_GT(creased, 40);
}

TEST(CreaseLift, MatchesItsDefinitionAtAnyDetail) {
  for (const auto& refined : {std::function(coarse), std::function(uneven)}) {
    CreasedSheet sheet(refined);
    for (const float share : {0.35f, 0.5f, 0.7f, 1.0f}) {
      const std::vector<float> heights = sheet.lowered(share);
      const std::vector<double> wanted = sheet.asDefined();
      for (std::size_t v = 0; v < heights.size(); ++v) {
        ASSERT_NEAR(static_cast<double>(heights[v]), wanted[v], 1e-5) << v << ", share " << share;
      }
    }
  }
}

TEST(CreaseLift, LeavesASlightlyCompressedSheetUnchanged) {
  CreasedSheet sheet(uneven);
  const std::vector<float> ones(static_cast<std::size_t>(sheet.refinement.vertexCount), 1.0f);
  EXPECT_EQ(sheet.lowered(0.0f), ones);
  EXPECT_EQ(sheet.lowered(0.1f), ones);
  EXPECT_NE(sheet.lowered(0.5f), ones);
  EXPECT_EQ(sheet.lowered(0.0f), ones) << "nothing is left from the call before";
}

TEST(CreaseLift, LeavesUnmovedSkinUnchanged) {
  CreasedSheet sheet(uneven);
  std::ranges::fill(sheet.moved.isControl, std::uint8_t{0});
  EXPECT_EQ(sheet.lowered(1.0f), std::vector<float>(static_cast<std::size_t>(sheet.refinement.vertexCount), 1.0f));
}

TEST(CreaseLift, IsContinuousWhereTheSkinFoldsOver) {
  CreasedSheet sheet(uneven);
  constexpr int kSteps = 1000;
  std::vector<float> before = sheet.lowered(0.0f);
  float worst = 0.0f;
  for (int i = 1; i <= kSteps; ++i) {
    const std::vector<float> now = sheet.lowered(static_cast<float>(i) / kSteps);
    for (std::size_t v = 0; v < now.size(); ++v) worst = std::max(worst, std::abs(now[v] - before[v]));
    before = now;
  }
  EXPECT_LT(worst, 10.0f / kSteps);
}

TEST(CreaseLift, IgnoresSliversOfTheBindPose) {
  CreasedSheet sheet(coarse, 30.0f);
  EXPECT_EQ(sheet.lowered(1.0f), std::vector<float>(sheet.mesh.positions.size(), 1.0f));
}

}  // namespace
}  // namespace sinew::test
