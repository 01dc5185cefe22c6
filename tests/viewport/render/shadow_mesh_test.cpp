// tests/viewport/render/shadow_mesh_test.cpp: the reduced mesh covers the same region as all triangles.

#include "app/viewport/render/fewer_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <set>

#include "core/character/bindings.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/dressed_humanoid.h"
#include "tests/support/characters/stand_ins.h"
#include "tests/support/characters/synthetic_characters.h"

namespace sinew::test {
namespace {

Surface posedSurface(const std::shared_ptr<const Character>& character, const Pose& pose, int depth) {
  Rig rig;
  rig.smoothing.depth = depth;
  Smoother smoother(character);
  EXPECT_TRUE(smoother.prepare(rig).ok());
  Surface surface;
  smoother.smooth(pose, surface);
  return surface;
}

std::vector<int> byMaterial(const Character& character) {
  std::vector<int> order(character.mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {},
                           [&](int t) { return character.mesh.triangles[static_cast<std::size_t>(t)].material; });
  return order;
}

app::ShadowMesh meshOf(const Character& character, const Surface& surface) {
  return app::makeShadowMesh(character, app::shadowClusters(character), *surface.refinement, byMaterial(character));
}

/// Cells of a plane along two axes whose middles are covered by triangles; a cell is 1 / kFine of the height.
class Cover {
 public:
  static constexpr float kFine = 250.0f;

  Cover(const Character& character, const Surface& surface, std::span<const std::uint32_t> indices, int axis)
      : cell_(character.height / kFine) {
    for (std::size_t i = 0; i < indices.size(); i += 3) {
      std::array<glm::vec2, 3> corners;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto vertex = static_cast<std::size_t>(surface.refinement->drawVertex[indices[i + c]]);
        const glm::vec3& at = surface.positions[vertex];
        corners[c] = glm::vec2(at[(axis + 1) % 3], at[(axis + 2) % 3]) / cell_;
      }
      add(corners);
    }
  }
  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  /// Number of these cells without any of the other's within `reach` cells.
  [[nodiscard]] std::size_t farFrom(const Cover& other, int reach) const {
    return static_cast<std::size_t>(std::ranges::count_if(cells_, [&](const std::pair<int, int>& at) {
      for (int x = -reach; x <= reach; ++x) {
        for (int y = -reach; y <= reach; ++y) {
          if (x * x + y * y <= reach * reach && other.cells_.contains({at.first + x, at.second + y})) return false;
        }
      }
      return true;
    }));
  }

 private:
  void add(const std::array<glm::vec2, 3>& t) {
    const glm::ivec2 low(glm::floor(glm::min(t[0], glm::min(t[1], t[2]))));
    const glm::ivec2 high(glm::ceil(glm::max(t[0], glm::max(t[1], t[2]))));
    const auto side = [](const glm::vec2& a, const glm::vec2& b, const glm::vec2& p) {
      return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    };
    for (int x = low.x; x <= high.x; ++x) {
      for (int y = low.y; y <= high.y; ++y) {
        const glm::vec2 p(static_cast<float>(x), static_cast<float>(y));
        const float a = side(t[0], t[1], p), b = side(t[1], t[2], p), c = side(t[2], t[0], p);
        if ((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0)) cells_.emplace(x, y);
      }
    }
  }

  float cell_;
  std::set<std::pair<int, int>> cells_;
};

std::vector<std::uint32_t> allOf(const Surface& surface) {
  std::vector<std::uint32_t> indices;
  for (const auto& triangle : surface.refinement->drawTriangles) {
    indices.insert(indices.end(), triangle.begin(), triangle.end());
  }
  return indices;
}

TEST(ShadowMeshes, SmallMeshUsesItsControlTriangles) {
  const auto limb = makeLimb();
  ASSERT_TRUE(app::shadowClusters(*limb).empty());
  for (const int depth : {1, 4}) {
    const Surface surface = posedSurface(limb, bindPose(limb->skeleton), depth);
    const app::ShadowMesh mesh = meshOf(*limb, surface);
    const std::vector<int> order = byMaterial(*limb);
    ASSERT_EQ(mesh.indices.size(), 3 * order.size());
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
      const auto& triangle = limb->mesh.triangles[static_cast<std::size_t>(order[i / 3])];
      EXPECT_EQ(surface.refinement->drawVertex[mesh.indices[i]], triangle.vertices[i % 3]);
    }
  }
}

TEST(ShadowMeshes, ClusterLiesInOneCellOfOneBone) {
  const auto body = fineHumanoid();
  const std::vector<int> stands = app::shadowClusters(*body);
  ASSERT_EQ(stands.size(), body->mesh.positions.size());
  const float most = app::kShadowCell * body->height * std::sqrt(3.0f);
  for (std::size_t v = 0; v < stands.size(); ++v) {
    const auto stand = static_cast<std::size_t>(stands[v]);
    EXPECT_EQ(stands[stand], stands[v]) << "who stands for another stands for itself";
    EXPECT_LE(glm::distance(body->mesh.positions[v], body->mesh.positions[stand]), most);
    EXPECT_EQ(strongestBone(*body, static_cast<int>(v)), strongestBone(*body, stands[v]));
  }
}

TEST(ShadowMeshes, MatchesTheFullShadow) {
  const auto body = fineHumanoid();
  const int reach = static_cast<int>(std::ceil(app::kShadowCell * std::sqrt(3.0f) * Cover::kFine));
  const std::vector<Pose> poses = posesOfClips(*body, 2);
  for (const Pose& pose : poses) {
    const Surface surface = posedSurface(body, pose, 1);
    const app::ShadowMesh mesh = meshOf(*body, surface);
    if (pose.boneInWorld == poses.front().boneInWorld) {
      std::printf("  %zu triangles of %zu\n", mesh.indices.size() / 3, allOf(surface).size() / 3);
    }
    EXPECT_LT(mesh.indices.size(), allOf(surface).size() / 4);
    for (const int axis : {0, 1, 2}) {
      const Cover all(*body, surface, allOf(surface), axis), few(*body, surface, mesh.indices, axis);
      EXPECT_EQ(all.farFrom(few, reach), 0u);
      EXPECT_EQ(few.farFrom(all, reach), 0u);
      EXPECT_LT(static_cast<double>(all.farFrom(few, 0) + few.farFrom(all, 0)), 0.05 * static_cast<double>(all.size()));
    }
  }
}

TEST(ShadowMeshes, MaskedTrianglesAreKept) {
  auto body = std::make_shared<Character>(*fineHumanoid());
  std::size_t masked = 0;
  for (std::size_t t = 0; t < body->mesh.triangles.size(); t += 2) {
    body->mesh.triangles[t].material = static_cast<int>(body->materials.size());
    ++masked;
  }
  body->materials.emplace_back().alphaMode = AlphaMode::kMask;
  const Surface surface = posedSurface(body, bindPose(body->skeleton), 1);
  const app::ShadowMesh mesh = meshOf(*body, surface);
  ASSERT_GE(mesh.ranges.size(), 2u);
  EXPECT_EQ(static_cast<std::size_t>(mesh.ranges.back().triangles), masked);
  EXPECT_LT(mesh.indices.size() / 3, body->mesh.triangles.size() * 3 / 4);
  int next = 0;
  for (const app::ShadowMesh::Range& range : mesh.ranges) {
    EXPECT_EQ(range.firstTriangle, next);
    next += range.triangles;
  }
  EXPECT_EQ(static_cast<std::size_t>(next), mesh.indices.size() / 3);
}

}  // namespace
}  // namespace sinew::test
