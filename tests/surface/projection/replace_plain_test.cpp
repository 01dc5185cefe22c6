// tests/surface/projection/replace_plain_test.cpp: `replace` on a body without wrapping muscles lifts the skin within
// their reach.

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/oracle/oracle.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/surface/mesh_checks.h"
#include "tests/support/surface/projected.h"

namespace sinew::test {
namespace {

using CharacterPtr = std::shared_ptr<const Character>;

/// One muscle half in the skin of the capsule.
Rig halfInTheSkin(const Character& limb, PatchKind patch) {
  Rig rig;
  rig.surface.mode = SurfaceMode::kReplace;
  rig.smoothing.patch = patch;
  rig.smoothing.depth = 6;
  rig.groups.push_back({"a", {}});
  rig.primitives.push_back(ellipsoidAt(limb, "ball", "middle", "a", {0.3f, 1.0f, 0.0f}, {0.15f, 0.25f, 0.2f}));
  return rig;
}

struct Smoothed {
  Surface surface;
  Surface patch;
};

Smoothed smoothed(const CharacterPtr& character, const Rig& rig) {
  Rig bare = rig;
  bare.primitives.clear();
  Smoother smoother(character);
  Smoother without(character);
  EXPECT_TRUE(smoother.prepare(rig).ok() && without.prepare(bare).ok());
  Smoothed out;
  smoother.smooth(bindPose(character->skeleton), out.surface);
  without.smooth(bindPose(character->skeleton), out.patch);
  return out;
}

TEST(ReplacePlain, NeverPullsSkinInwards) {
  const CharacterPtr limb = makeLimb();
  for (const PatchKind patch : {PatchKind::kPn, PatchKind::kPhong, PatchKind::kFlat}) {
    const auto [surface, bare] = smoothed(limb, halfInTheSkin(*limb, patch));
    EXPECT_GT(surface.report.unwrapped, 0);
    int moved = 0;
    float deepest = 0.0f;
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
      const glm::vec3 away = surface.positions[v] - bare.positions[v];
      moved += sameBits(surface.positions[v], bare.positions[v]) ? 0 : 1;
      deepest = std::min(deepest, glm::dot(away, bare.normals[v]));
    }
    EXPECT_GT(moved, 50) << nameOf(patch);
    EXPECT_GE(deepest, -1e-4f * limb->height) << nameOf(patch);
  }
}

TEST(ReplacePlain, HeldSkinLiesOnTheImplicitSurface) {
  const CharacterPtr limb = makeLimb();
  const Rig rig = halfInTheSkin(*limb, PatchKind::kPn);
  const auto [surface, bare] = smoothed(limb, rig);
  const oracle::Oracle oracle(*limb, rig);
  Projected projected(*limb, rig);
  const Surface& raw = projected.at(bindPose(limb->skeleton));
  int held = 0;
  int still = 0;
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const oracle::Answer answer = oracle.evaluate(oracle::siteOf(limb->mesh, *surface.refinement, static_cast<int>(v)));
    const bool guarded = !sameBits(surface.positions[v], raw.positions[v]);
    // Full weight: all three control vertices are in reach, and the muscle protrudes enough to determine the vertex.
    if (answer.weight == 1.0 && answer.resolved && !answer.limited && !guarded) {
      ++held;
      const double field = oracle.field().value(oracle::vec(surface.positions[v]), answer.fieldWeights);
      EXPECT_NEAR(field, oracle.field().iso(), 1e-3) << v;
    }
    if (answer.weight == 0.0) {
      ++still;
      EXPECT_TRUE(sameBits(surface.positions[v], bare.positions[v])) << v;
    }
  }
  EXPECT_GT(held, 20);
  EXPECT_GT(still, 500);
}

// Without limits, one leg's skin would follow a muscle in the gap to its far side, through the other leg's skin.
TEST(ReplacePlain, SkinStaysOnItsSideOfAGap) {
  const auto body = std::make_shared<Character>(*makeTwoLegged());
  for (glm::vec3& p : body->mesh.positions) p.x *= 0.5f;  // Legs so close that limits fully apply.
  for (glm::vec3& n : body->mesh.normals) n = glm::normalize(n * glm::vec3(2.0f, 1.0f, 1.0f));
  Rig rig;
  rig.surface.mode = SurfaceMode::kReplace;
  rig.groups.push_back({"a", {}});
  rig.primitives = {ellipsoidAt(*body, "thigh", "leg L", "a", {0.06f, 0.7f, 0.0f}, {0.2f, 0.2f, 0.2f})};
  const auto [surface, bare] = smoothed(body, rig);
  float risen = 0.0f;
  float least = 1.0f;
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    if (surface.displacement[v] == 0.0f || bare.positions[v].x < 0.02f * body->height) continue;
    least = std::min(least, surface.positions[v].x);
    risen = std::max(risen, bare.positions[v].x - surface.positions[v].x);
  }
  std::printf("  risen by %.3f H, over the middle by %.3f H\n", double{risen / body->height},
              double{-least / body->height});
  EXPECT_GT(risen, 0.04f * body->height);
  // Limits apply along the rise directions, while the skin moves along its normals. Without limits it is 0.084 H.
  EXPECT_GT(least, -0.03f * body->height);
}

}  // namespace
}  // namespace sinew::test
