// tests/files/same_triangles.h: comparison of a compressed post with the plain one by an independent reader.
#pragma once

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/character/skinning.h"
#include "core/geometry/at.h"
#include "sinew/character/character_pose.h"
#include "sinew/files/gltf_import.h"
#include "tests/support/characters/gltf_oracle.h"

namespace sinew::test {

/// Whether two triangles have the same corners and winding, starting anywhere.
inline bool isSameTriangle(const RawTriangle& a, const RawTriangle& b, double tolerance) {
  for (std::size_t start = 0; start < 3; ++start) {
    bool same = true;
    for (std::size_t i = 0; i < 3; ++i) same = same && glm::distance(a[i], b[(start + i) % 3]) <= tolerance;
    if (same) return true;
  }
  return false;
}

/// The compressed file has the plain one's triangles at every time of its clip, in any order.
inline void expectShowsWhatThePlainFileShows(const std::filesystem::path& compressed,
                                             const std::filesystem::path& plain, double tolerance) {
  const auto imported = importGltf(compressed);
  ASSERT_TRUE(imported.ok()) << imported.error().text();
  const Character& character = *imported.value();
  EXPECT_TRUE(character.ignored.empty()) << character.ignored.front();
  const GltfOracle oracle(plain);
  ASSERT_EQ(character.clips.size(), oracle.clips());
  SkinnedMesh skinned;
  for (const float time : {0.0f, 0.3f, 1.0f}) {
    skin(character, samplePose(character, character.clips.at(0), time), skinned);
    std::vector<RawTriangle> left = oracle.triangles(0, static_cast<double>(time));
    ASSERT_EQ(left.size(), character.mesh.triangles.size());
    for (const ControlTriangle& triangle : character.mesh.triangles) {
      RawTriangle own;
      for (std::size_t i = 0; i < 3; ++i) own[i] = glm::dvec3(at(skinned.positions, triangle.vertices[i]));
      const auto found =
          std::ranges::find_if(left, [&](const RawTriangle& raw) { return isSameTriangle(raw, own, tolerance); });
      ASSERT_NE(found, left.end()) << "at " << time;
      left.erase(found);
    }
  }
}

}  // namespace sinew::test
