// tests/support/characters/import_beside_oracle.cpp: compares an import's skin with the oracle's, corner by corner.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/character/skinning.h"
#include "core/geometry/at.h"
#include "sinew/character/character_pose.h"
#include "sinew/character/pose.h"
#include "sinew/files/gltf_import.h"
#include "tests/support/characters/gltf_oracle.h"

namespace sinew::test {
namespace {

/// Largest distance between a corner in the file and its vertex in the import; the corners may start elsewhere and have
/// the opposite winding (mirrored binds).
double distance(const RawTriangle& raw, const ControlTriangle& triangle, const std::vector<glm::vec3>& positions) {
  double best = 1e300;
  for (std::size_t start = 0; start < 6; ++start) {
    double worst = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t k = start < 3 ? (start + i) % 3 : (start + 3 - i) % 3;
      worst = std::max(worst, glm::length(raw[k] - glm::dvec3(at(positions, triangle.vertices[i]))));
    }
    best = std::min(best, worst);
  }
  return best;
}

/// Raw triangles that keep three corners when welded. Judged at rest: the bind pose has no smaller triangles there.
std::vector<std::size_t> keptTriangles(const std::vector<RawTriangle>& triangles, double tolerance) {
  std::vector<std::size_t> kept;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const RawTriangle& p = triangles[t];
    if (glm::length(p[0] - p[1]) > tolerance && glm::length(p[1] - p[2]) > tolerance &&
        glm::length(p[2] - p[0]) > tolerance) {
      kept.push_back(t);
    }
  }
  return kept;
}

}  // namespace

void expectSkinsLikeTheFile(const std::filesystem::path& file, double tolerance) {
  const auto imported = importGltf(file);
  ASSERT_TRUE(imported.ok()) << imported.error().text();
  const Character& character = *imported.value();
  const double height = static_cast<double>(character.height);
  const GltfOracle oracle(file);
  const std::vector<RawTriangle> resting = oracle.triangles(std::nullopt, 0.0);
  const std::vector<std::size_t> kept = keptTriangles(resting, 1e-6 * height);
  ASSERT_EQ(kept.size(), character.mesh.triangles.size());
  ASSERT_EQ(resting.size() - kept.size(), toIndex(character.mesh.trianglesDropped));

  SkinnedMesh skinned;
  const auto compare = [&](const Pose& pose, const std::vector<RawTriangle>& raw, const std::string& when) {
    skin(character, pose, skinned);
    double worst = 0.0;
    for (std::size_t t = 0; t < kept.size(); ++t) {
      worst = std::max(worst, distance(raw[kept[t]], character.mesh.triangles[t], skinned.positions));
    }
    EXPECT_LE(worst, tolerance * height) << file << " " << when;
  };
  compare(restPose(character.skeleton), resting, "at rest");
  ASSERT_EQ(oracle.clips(), character.clips.size());
  for (std::size_t clip = 0; clip < oracle.clips(); ++clip) {
    const double duration = oracle.duration(clip);
    EXPECT_NEAR(duration, static_cast<double>(character.clips[clip].duration), 1e-6 * std::max(1.0, duration));
    for (const double share : {0.0, 0.1, 0.37, 0.5, 0.81, 1.0}) {
      const auto time = static_cast<float>(share * duration);
      compare(samplePose(character, character.clips[clip], time), oracle.triangles(clip, static_cast<double>(time)),
              character.clips[clip].name + " at " + std::to_string(time));
    }
  }
}

}  // namespace sinew::test
