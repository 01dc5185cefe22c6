// tests/surface/patches/refinement_test.cpp: numbering, tiling and wedges of the N-adic refinement.

#include "sinew/surface/refinement.h"

#include <cmath>
#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "sinew/rig/rig.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/oracle/oracle.h"
#include "tests/support/surface/mesh_checks.h"

namespace sinew::test {
namespace {

using CharacterPtr = std::shared_ptr<const Character>;

std::vector<CharacterPtr> refinedCharacters() { return {makeLimb(), makeTwoLegged(), makeStrip(), makeTube()}; }

/// Barycentric coordinates of a refined vertex in a control triangle, times the depth, rounded; {-1,..} if outside.
std::array<int, 3> latticeIn(const ControlMesh& mesh, const Refinement& refinement, const ControlTriangle& parent,
                             int vertex) {
  const oracle::Site site = oracle::siteOf(mesh, refinement, vertex);
  std::array<int, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (site.barycentric[i] == 0.0) continue;
    const auto at = std::find(parent.vertices.begin(), parent.vertices.end(), site.vertices[i]);
    if (at == parent.vertices.end()) return {-1, -1, -1};
    out[static_cast<std::size_t>(at - parent.vertices.begin())] +=
        static_cast<int>(std::lround(site.barycentric[i] * refinement.depth));
  }
  return out;
}

// Independent of rig and pose: no muscle can open a closed mesh.
TEST(Refinement, ClosedMeshesStayClosed) {
  for (const CharacterPtr& character : {makeLimb(), makeTwoLegged(), makeTube()}) {
    for (int n = 1; n <= kMaxDepth; ++n) EXPECT_TRUE(isClosed(refine(character->mesh, n).triangles)) << n;
  }
  EXPECT_FALSE(isClosed(refine(makeStrip()->mesh, 3).triangles));
}

TEST(Refinement, CountsAndNumberingAreConsistent) {
  for (const CharacterPtr& character : refinedCharacters()) {
    const ControlMesh& mesh = character->mesh;
    const int v = static_cast<int>(mesh.positions.size());
    const int e = static_cast<int>(mesh.edges.size());
    const int t = static_cast<int>(mesh.triangles.size());
    for (int n = 1; n <= kMaxDepth; ++n) {
      const Refinement refinement = refine(mesh, n);
      EXPECT_EQ(refinement.vertexCount, v + e * (n - 1) + t * (n - 1) * (n - 2) / 2);
      EXPECT_EQ(refinedVertexCount(mesh, n), refinement.vertexCount);
      EXPECT_EQ(static_cast<int>(refinement.triangles.size()), t * n * n);
      EXPECT_EQ(refinement.drawTriangles.size(), refinement.triangles.size());
      EXPECT_EQ(refinement.drawUv.size(), refinement.drawVertex.size());
      EXPECT_EQ(static_cast<int>(refinement.inside.size()), t * (n - 1) * (n - 2) / 2);
      EXPECT_TRUE(refinement.isUniform);
      if (n > 1) {
        EXPECT_EQ(refinement.edgeVertex(0, 1), v);
        EXPECT_EQ(refinement.edgeVertex(e - 1, n - 1), v + e * (n - 1) - 1);
      }
      if (n > 2) {
        EXPECT_EQ(refinement.insideBegin.back(), refinement.vertexCount);
      }
    }
  }
}

// n^2 small triangles, each with 1/n^2 of the parent's area and its orientation, all different: they tile it.
TEST(Refinement, SmallTrianglesTileTheirParent) {
  for (const CharacterPtr& character : refinedCharacters()) {
    const ControlMesh& mesh = character->mesh;
    for (const int n : {1, 2, 3, 4, 7, 16}) {
      const Refinement refinement = refine(mesh, n);
      const auto perTriangle = static_cast<std::size_t>(n * n);
      for (std::size_t t = 0; t<mesh.triangles.size(); t += n> 4 ? 11 : 1) {
        std::set<std::array<std::array<int, 3>, 3>> seen;
        for (std::size_t k = 0; k < perTriangle; ++k) {
          std::array<std::array<int, 3>, 3> corner{};
          for (std::size_t i = 0; i < 3; ++i) {
            corner[i] = latticeIn(mesh, refinement, mesh.triangles[t], refinement.triangles[t * perTriangle + k][i]);
            ASSERT_EQ(corner[i][0] + corner[i][1] + corner[i][2], n) << "depth " << n << ", triangle " << t;
          }
          const int area = (corner[1][1] - corner[0][1]) * (corner[2][2] - corner[0][2]) -
                           (corner[2][1] - corner[0][1]) * (corner[1][2] - corner[0][2]);
          ASSERT_EQ(area, 1) << "depth " << n << ", triangle " << t << ", small triangle " << k;
          std::sort(corner.begin(), corner.end());
          ASSERT_TRUE(seen.insert(corner).second);
        }
      }
    }
  }
}

TEST(Refinement, DrawnVerticesCarryBarycentricTextureCoordinates) {
  for (const CharacterPtr& character : refinedCharacters()) {
    const ControlMesh& mesh = character->mesh;
    for (const int n : {1, 2, 3, 5}) {
      const Refinement refinement = refine(mesh, n);
      const auto perTriangle = static_cast<std::size_t>(n * n);
      for (std::size_t k = 0; k < refinement.triangles.size(); ++k) {
        const ControlTriangle& parent = mesh.triangles[k / perTriangle];
        for (std::size_t i = 0; i < 3; ++i) {
          const auto drawn = static_cast<std::size_t>(refinement.drawTriangles[k][i]);
          ASSERT_LT(drawn, refinement.drawVertex.size());
          ASSERT_EQ(refinement.drawVertex[drawn], refinement.triangles[k][i]);
          const auto lattice = latticeIn(mesh, refinement, parent, refinement.triangles[k][i]);
          glm::vec2 uv(0.0f);
          for (std::size_t c = 0; c < 3; ++c) {
            const Wedge& wedge = mesh.wedges[static_cast<std::size_t>(parent.wedges[c])];
            uv += static_cast<float>(lattice[c]) / static_cast<float>(n) * wedge.uv;
          }
          ASSERT_LT(glm::distance(uv, refinement.drawUv[drawn]), 1e-5f) << character->name << ", depth " << n;
        }
      }
    }
  }
}

// Drawn vertices split at seams only: never more than one for each refined vertex and texture coordinate.
TEST(Refinement, DrawnVerticesAreNotRepeated) {
  for (const CharacterPtr& character : refinedCharacters()) {
    for (const int n : {1, 3, 6}) {
      const Refinement refinement = refine(character->mesh, n);
      std::map<int, std::vector<glm::vec2>> seen;
      int repeats = 0;
      for (std::size_t d = 0; d < refinement.drawVertex.size(); ++d) {
        auto& uvs = seen[refinement.drawVertex[d]];
        for (const glm::vec2& uv : uvs) repeats += glm::distance(uv, refinement.drawUv[d]) < 1e-7f ? 1 : 0;
        uvs.push_back(refinement.drawUv[d]);
      }
      EXPECT_EQ(repeats, 0) << character->name << ", depth " << n;
      EXPECT_EQ(static_cast<int>(seen.size()), refinement.vertexCount);
    }
  }
}

/// Gives every wedge a color, including the extremes.
ControlMesh painted(ControlMesh mesh) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> level(0, 8);
  for (Wedge& wedge : mesh.wedges) {
    for (int channel = 0; channel < 4; ++channel) wedge.color[channel] = static_cast<float>(level(random)) / 8.0f;
  }
  return mesh;
}

TEST(Refinement, DrawnVerticesCarryBarycentricColors) {
  for (const CharacterPtr& character : refinedCharacters()) {
    EXPECT_TRUE(refine(character->mesh, 3).drawColor.empty()) << "no memory for meshes without colors";
    const ControlMesh mesh = painted(character->mesh);
    for (const int n : {1, 2, 3, 5}) {
      const Refinement refinement = refine(mesh, n);
      ASSERT_EQ(refinement.drawColor.size(), refinement.drawVertex.size());
      const auto perTriangle = static_cast<std::size_t>(n * n);
      for (std::size_t k = 0; k < refinement.triangles.size(); ++k) {
        const ControlTriangle& parent = mesh.triangles[k / perTriangle];
        for (std::size_t i = 0; i < 3; ++i) {
          const glm::vec4 color = refinement.drawColor[refinement.drawTriangles[k][i]];
          const auto lattice = latticeIn(mesh, refinement, parent, refinement.triangles[k][i]);
          for (int channel = 0; channel < 4; ++channel) {
            double expected = 0.0;
            for (std::size_t c = 0; c < 3; ++c) {
              const Wedge& wedge = mesh.wedges[static_cast<std::size_t>(parent.wedges[c])];
              expected += static_cast<double>(lattice[c]) / n * static_cast<double>(wedge.color[channel]);
            }
            ASSERT_NEAR(static_cast<double>(color[channel]), expected, 1e-6) << character->name << ", depth " << n;
            ASSERT_TRUE(color[channel] >= 0.0f && color[channel] <= 1.0f);
          }
        }
      }
    }
  }
}

// Colors affect nothing else: mesh, drawn vertices and texture coordinates stay, bit for bit.
TEST(Refinement, ColorsChangeNothingElse) {
  for (const CharacterPtr& character : refinedCharacters()) {
    const Refinement plain = refine(character->mesh, 4);
    const Refinement colored = refine(painted(character->mesh), 4);
    EXPECT_EQ(colored.triangles, plain.triangles);
    EXPECT_EQ(colored.drawTriangles, plain.drawTriangles);
    EXPECT_EQ(colored.drawVertex, plain.drawVertex);
    EXPECT_EQ(colored.drawUv, plain.drawUv);
  }
}

}  // namespace
}  // namespace sinew::test
