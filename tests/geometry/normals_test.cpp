// tests/geometry/normals_test.cpp: vertex normals on shapes whose normals are known.

#include "core/geometry/normals.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace sinew {
namespace {

ControlTriangle triangle(int a, int b, int c) { return {.vertices = {a, b, c}}; }

struct Sphere {
  std::vector<glm::vec3> positions;
  std::vector<ControlTriangle> triangles;
};

Sphere sphere(int rings, int sectors) {
  Sphere s;
  s.positions.emplace_back(0.0f, 1.0f, 0.0f);
  for (int r = 1; r < rings; ++r) {
    for (int k = 0; k < sectors; ++k) {
      const double polar = std::numbers::pi * r / rings;
      const double around = 2.0 * std::numbers::pi * k / sectors;
      s.positions.emplace_back(std::sin(polar) * std::sin(around), std::cos(polar), std::sin(polar) * std::cos(around));
    }
  }
  s.positions.emplace_back(0.0f, -1.0f, 0.0f);
  const int last = static_cast<int>(s.positions.size()) - 1;
  const auto vertex = [&](int r, int k) {
    return r == 0 ? 0 : r == rings ? last : 1 + (r - 1) * sectors + k % sectors;
  };
  for (int r = 0; r < rings; ++r) {
    for (int k = 0; k < sectors; ++k) {
      if (r > 0) s.triangles.push_back(triangle(vertex(r, k), vertex(r + 1, k), vertex(r, k + 1)));
      if (r + 1 < rings) s.triangles.push_back(triangle(vertex(r + 1, k), vertex(r + 1, k + 1), vertex(r, k + 1)));
    }
  }
  return s;
}

TEST(Normals, PointOutwardsOnASphere) {
  const Sphere s = sphere(24, 36);
  const std::vector<glm::vec3> normals = vertexNormals(s.positions, s.triangles);
  ASSERT_EQ(normals.size(), s.positions.size());
  for (std::size_t v = 0; v < normals.size(); ++v) {
    EXPECT_NEAR(glm::length(normals[v]), 1.0f, 1e-6f);
    EXPECT_GT(glm::dot(normals[v], s.positions[v]), 0.999f) << v;
  }
}

std::vector<glm::vec3> cubeCorners() {
  return {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
}

/// Bit i of `cuts` chooses the diagonal of face i.
std::vector<ControlTriangle> cubeFaces(int cuts) {
  std::vector<ControlTriangle> triangles;
  int face = 0;
  for (const auto& [a, b, c, d] :
       {std::array{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}) {
    if ((cuts >> face++ & 1) != 0) {
      triangles.push_back(triangle(a, b, c));
      triangles.push_back(triangle(a, c, d));
    } else {
      triangles.push_back(triangle(b, c, d));
      triangles.push_back(triangle(b, d, a));
    }
  }
  return triangles;
}

TEST(Normals, DoNotDependOnTriangulation) {
  const std::vector<glm::vec3> corners = cubeCorners();
  for (int cuts = 0; cuts < 64; ++cuts) {
    const std::vector<glm::vec3> normals = vertexNormals(corners, cubeFaces(cuts));
    for (std::size_t v = 0; v < corners.size(); ++v) {
      EXPECT_LE(glm::distance(normals[v], corners[v] / std::sqrt(3.0f)), 1e-6f) << "cuts " << cuts << " corner " << v;
    }
  }
}

TEST(Normals, DoNotDependOnScale) {
  const std::vector<ControlTriangle> faces = cubeFaces(21);
  for (const float scale : {1e-18f, 1e-6f, 1.0f, 1e6f, 1e15f}) {
    std::vector<glm::vec3> corners = cubeCorners();
    for (glm::vec3& corner : corners) corner *= scale;
    const std::vector<glm::vec3> normals = vertexNormals(corners, faces);
    for (std::size_t v = 0; v < corners.size(); ++v) {
      EXPECT_LE(glm::distance(normals[v], cubeCorners()[v] / std::sqrt(3.0f)), 1e-6f) << scale;
    }
  }
}

TEST(Normals, DegenerateFacesDoNotAffectOthers) {
  const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {5, 5, 5}};
  const std::vector<ControlTriangle> faces{triangle(0, 1, 2), triangle(0, 1, 3), triangle(3, 3, 3)};
  const std::vector<glm::vec3> normals = vertexNormals(positions, faces);
  for (const std::size_t v : {0U, 1U, 2U}) EXPECT_EQ(normals[v], glm::vec3(0, 0, 1));
  EXPECT_EQ(normals[3], glm::vec3(0, 1, 0)) << "no area: +Y";
  EXPECT_EQ(normals[4], glm::vec3(0, 1, 0)) << "no face: +Y";
}

TEST(Normals, CancelingFacesGivePlusY) {
  const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0.1f, 0}, {0.3f, 1, 0.2f}};
  for (const glm::vec3& normal : vertexNormals(positions, std::vector{triangle(0, 1, 2), triangle(0, 2, 1)})) {
    EXPECT_EQ(normal, glm::vec3(0, 1, 0));
  }
}

}  // namespace
}  // namespace sinew
