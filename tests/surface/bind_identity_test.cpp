// tests/surface/bind_identity_test.cpp: bind pose: vertices beyond every muscle's reach lie on the patch, for every
// kind and depth.

#include <algorithm>
#include <array>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/rig/attachment.h"
#include "sinew/surface/smoother.h"
#include "tests/support/rigs/trial_scenes.h"
#include "tests/support/surface/every_kind.h"
#include "tests/support/surface/mesh_checks.h"

namespace sinew::test {
namespace {

Surface inBindPose(const TrialScene& scene, const Rig& rig) {
  Smoother smoother(scene.character);
  const auto prepared = smoother.prepare(rig);
  EXPECT_TRUE(prepared.ok()) << prepared.error().text();
  Surface out;
  smoother.smooth(bindPose(scene.character->skeleton), out);
  return out;
}

/// Whether a point lies clearly outside every influence ellipsoid.
class Outside {
 public:
  Outside(const TrialScene& scene, const Rig& rig) {
    const Attachment attachment = attach(rig, *scene.character).value();
    poseField(attachment.primitives, bindPose(scene.character->skeleton).boneInWorld, 0.0f, posed_);
  }
  bool operator()(const glm::vec3& point) const {
    for (const PosedPrimitive& primitive : posed_) {
      if (glm::length(primitive.influence.toUnit * (point - primitive.influence.center)) < 1.0f + 1e-5f) return false;
    }
    return true;
  }

 private:
  std::vector<PosedPrimitive> posed_;
};

/// `replace` only guarantees this for normal triangles: on straddling ones a vertex outside may be projected too.
std::vector<bool> ofNormalTriangles(const Surface& surface) {
  std::vector<bool> out(surface.positions.size(), true);
  for (std::size_t i = 0; i < surface.refinement->triangles.size(); ++i) {
    if (surface.classes[static_cast<std::size_t>(surface.refinement->controlOf[i])] == TriangleClass::kNormal) continue;
    for (const int v : surface.refinement->triangles[i]) out[static_cast<std::size_t>(v)] = false;
  }
  return out;
}

void expectIdentity(const TrialScene& scene, SurfaceMode mode) {
  int kept = 0;
  int moved = 0;
  int untouched = 0;
  for (const PatchKind patch : kEveryPatch) {
    for (const int depth : {1, 2, 3, 5, kMaxDepth}) {
      Rig rig = withMode(scene.rig, mode);
      rig.primitives.resize(std::min<std::size_t>(rig.primitives.size(), 6));  // Leaves some of the body out of reach.
      for (Primitive& primitive : rig.primitives) primitive.mirror.clear();
      rig.smoothing.patch = patch;
      rig.smoothing.detail = DetailKind::kUniform;
      rig.smoothing.depth = depth;
      Rig empty = rig;
      empty.primitives.clear();
      const Surface with = inBindPose(scene, rig);
      const Surface without = inBindPose(scene, empty);
      const Outside outside(scene, rig);
      const std::vector<bool> normal = ofNormalTriangles(with);
      // Normals change up to one edge away from a moved vertex.
      const std::vector<bool> reshaded =
          grown(with.refinement->triangles, movedBetween(with.positions, without.positions), 1);
      for (std::size_t v = 0; v < with.positions.size(); ++v) {
        const bool same = sameBits(with.positions[v], without.positions[v]) &&
                          (reshaded[v] || sameBits(with.normals[v], without.normals[v]));
        moved += sameBits(with.positions[v], without.positions[v]) ? 0 : 1;
        untouched += reshaded[v] ? 0 : 1;
        if (mode == SurfaceMode::kSwell ? !outside(without.positions[v]) : !normal[v]) continue;
        ++kept;
        ASSERT_TRUE(same) << scene.name << ", " << nameOf(mode) << ", " << nameOf(patch) << ", depth " << depth
                          << ", vertex " << v;
        ASSERT_EQ(with.displacement[v], 0.0f);
      }
    }
  }
  EXPECT_GT(kept, 1000) << scene.name;
  EXPECT_GT(untouched, 1000) << scene.name;
  EXPECT_GT(moved, 1000) << scene.name << ": nothing moved, so nothing was shown";
}

TEST(BindIdentity, SkinOutOfReachIsThePatchForEveryKindAndDepth) {
  for (const char* name : {"wrapped", "tangle"}) {
    for (const SurfaceMode mode : {SurfaceMode::kSwell, SurfaceMode::kReplace}) expectIdentity(trialScene(name), mode);
  }
}

TEST(BindIdentity, ControlVerticesKeepTheirMeshPositions) {
  for (const char* name : {"wrapped", "tangle"}) {
    const TrialScene& scene = trialScene(name);
    for (const PatchKind patch : kEveryPatch) {
      for (int depth = 1; depth <= kMaxDepth; ++depth) {
        Rig rig;
        rig.smoothing.patch = patch;
        rig.smoothing.detail = DetailKind::kUniform;
        rig.smoothing.depth = depth;
        const Surface surface = inBindPose(scene, rig);
        for (std::size_t v = 0; v < scene.character->mesh.positions.size(); ++v) {
          ASSERT_LT(glm::distance(surface.positions[v], scene.character->mesh.positions[v]),
                    1e-5f * scene.character->height)
              << name << ", " << nameOf(patch) << ", depth " << depth << ", vertex " << v;
        }
      }
    }
  }
}

}  // namespace
}  // namespace sinew::test
