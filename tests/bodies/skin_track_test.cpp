// tests/bodies/skin_track_test.cpp: nearest skin that faces outwards, compared with a search of all triangles.

#include "core/bodies/motions.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include <glm/geometric.hpp>

#include "core/geometry/triangle_tree.h"
#include "tests/bodies/drawn_muscles.h"
#include "tests/support/characters/synthetic_characters.h"

namespace sinew::test {
namespace {

TriangleCorners cornersOf(const ControlMesh& mesh, int triangle) {
  const auto& vertices = at(mesh.triangles, triangle).vertices;
  return {at(mesh.positions, vertices[0]), at(mesh.positions, vertices[1]), at(mesh.positions, vertices[2])};
}

/// Distance of the nearest triangle that faces outwards, or of any.
float distanceBySearch(const ControlMesh& mesh, const glm::vec3& point, const glm::vec3& outwards) {
  float facing = std::numeric_limits<float>::max();
  float any = facing;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const TriangleCorners c = cornersOf(mesh, t);
    const glm::vec3 face = glm::cross(c[1] - c[0], c[2] - c[0]);
    if (!(glm::length(face) > 0.0f)) continue;
    const float off = glm::distance(point, mixed(c, nearestOnTriangle(point, c)));
    any = std::min(any, off);
    if (glm::dot(glm::normalize(face), outwards) > 0.2f) facing = std::min(facing, off);
  }
  return facing < std::numeric_limits<float>::max() ? facing : any;
}

TEST(SkinTrack, NearestOutwardPointMatchesASearch) {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> anywhere(-1.2f, 1.2f);
  for (const auto& character :
       {bundledCharacter("humanoid.glb"), bundledCharacter("horse.glb"), makeLimb(), makeStrip(), makeCube()}) {
    const SkinRuns skin(character->mesh);
    for (int i = 0; i < 200; ++i) {
      const glm::vec3 point = character->height * glm::vec3(anywhere(random), anywhere(random), anywhere(random));
      const glm::vec3 outwards =
          glm::normalize(glm::vec3(anywhere(random), anywhere(random), 0.1f + std::abs(anywhere(random))));
      const auto spot = spotOver(skin, point, outwards);
      ASSERT_TRUE(spot.has_value());
      const float found = glm::distance(point, mixed(cornersOf(character->mesh, spot->triangle), spot->shares));
      EXPECT_NEAR(found, distanceBySearch(character->mesh, point, outwards), 1e-5f * character->height);
    }
  }
}

TEST(SkinTrack, RunsContainEveryTriangleOnceInsideTheirBoxes) {
  const auto character = bundledCharacter("horse.glb");
  const SkinRuns skin(character->mesh);
  int next = 0;
  for (const SkinRuns::Run& run : skin.runs()) {
    EXPECT_EQ(run.begin, next);
    for (int t = run.begin; t < run.end; ++t) {
      for (const glm::vec3& corner : cornersOf(character->mesh, t)) {
        EXPECT_TRUE(glm::all(glm::lessThanEqual(run.low, corner)) && glm::all(glm::lessThanEqual(corner, run.high)));
      }
    }
    next = run.end;
  }
  EXPECT_EQ(next, static_cast<int>(character->mesh.triangles.size()));
}

}  // namespace
}  // namespace sinew::test
