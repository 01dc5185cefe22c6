// tests/surface/region_test.cpp: a detailed part of the body matches the whole surface, and fits the rest.
#include "sinew/surface/region.h"

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sinew/surface/crowd_smoother.h"
#include "sinew/surface/smoother.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/rigs/trial_scenes.h"
#include "tests/support/surface/mesh_checks.h"

namespace sinew::test {
namespace {

Region regionOf(const Character& character, const std::vector<std::string>& names) {
  std::vector<int> bones;
  for (const std::string& name : names) bones.push_back(character.skeleton.findBone(name).value());
  return regionOfBones(character, bones);
}

int count(const Region& region) { return static_cast<int>(std::ranges::count(region, 1)); }

/// Differences between a part and the whole surface.
struct PartDifference {
  int triangles = 0;      ///< Triangles of the region with any corner that differs in a bit.
  float position = 0.0f;  ///< Maximum, character units.
  float normal = 0.0f;    ///< Maximum.
};

PartDifference differenceOfPart(const Surface& part, const Surface& whole, const Region& region) {
  PartDifference found;
  for (std::size_t t = 0; t < region.size(); ++t) {
    if (region[t] == 0) continue;
    const auto triangle = static_cast<int>(t);
    const bool alike = part.refinement->refinedTriangles(triangle) == whole.refinement->refinedTriangles(triangle);
    bool allSame = alike;
    for (int i = 0; alike && i < part.refinement->refinedTriangles(triangle); ++i) {
      const auto a = static_cast<std::size_t>(part.refinement->triangleBegin[t] + i);
      const auto b = static_cast<std::size_t>(whole.refinement->triangleBegin[t] + i);
      for (std::size_t c = 0; c < 3; ++c) {
        const auto v = static_cast<std::size_t>(part.refinement->triangles[a][c]);
        const auto w = static_cast<std::size_t>(whole.refinement->triangles[b][c]);
        const glm::vec3 n = shadingNormal(part, part.refinement->drawTriangles[a][c]);
        const glm::vec3 m = shadingNormal(whole, whole.refinement->drawTriangles[b][c]);
        allSame = allSame && sameBits(part.positions[v], whole.positions[w]) && sameBits(n, m) &&
                  sameBits(part.normals[v], whole.normals[w]);
        found.position = std::max(found.position, glm::distance(part.positions[v], whole.positions[w]));
        found.normal = std::max(found.normal, glm::distance(part.normals[v], whole.normals[w]));
      }
    }
    found.triangles += allSame ? 0 : 1;
  }
  return found;
}

struct RegionCase {
  const char* scene;
  std::vector<std::string> bones;
};

class RegionOfScene : public testing::TestWithParam<RegionCase> {};

TEST_P(RegionOfScene, MatchesTheWholeSurfaceBitForBit) {
  const TrialScene scene = bundledTrialScene(GetParam().scene);
  const Region region = regionOf(*scene.character, GetParam().bones);
  for (const DetailKind detail : {DetailKind::kUniform, DetailKind::kAdaptive}) {
    Rig rig = scene.rig;
    rig.smoothing.detail = detail;
    rig.smoothing.depth = 3;
    Smoother whole(scene.character), part(scene.character);
    ASSERT_TRUE(whole.prepare(rig).ok() && part.prepare(rig, {}, region).ok());
    Surface expected, surface;
    for (const Pose& pose : spreadPoses(*scene.character, 12)) {
      whole.smooth(pose, expected);
      part.smooth(pose, surface);
      EXPECT_EQ(differenceOfPart(surface, expected, region).triangles, 0) << "of " << count(region);
    }
    EXPECT_LT(surface.positions.size(), expected.positions.size());
  }
}

INSTANTIATE_TEST_SUITE_P(Bundled, RegionOfScene,
                         testing::Values(RegionCase{"humanoid", {"hand.L", "hand.R", "head"}},
                                         RegionCase{"humanoid", {"chest"}}, RegionCase{"humanoid-wrapped", {"shin.L"}},
                                         RegionCase{"demo", {"head"}}));

/// Steep and folded muscles: their correction may reach beyond the margin, and fades there.
TEST(Region, DiffersLittleWhereFoldsCrossTheMargin) {
  std::vector<std::pair<std::shared_ptr<const Character>, Rig>> scenes;
  const auto body = makeTwoLegged();
  for (std::uint64_t seed = 0; seed < 6; ++seed) scenes.emplace_back(body, randomRig(*body, kShortReach, seed));
  for (const TrialScene& scene : trialScenes()) scenes.emplace_back(scene.character, scene.rig);
  int all = 0, different = 0;
  for (auto& [character, rig] : scenes) {
    rig.smoothing.depth = 3;
    Smoother whole(character), part(character);
    ASSERT_TRUE(whole.prepare(rig).ok());
    const std::vector<Pose> poses = spreadPoses(*character, 3);
    for (int bone = 0; bone < static_cast<int>(character->skeleton.bones.size()); bone += 3) {
      const Region region = regionOfBones(*character, {&bone, 1});
      ASSERT_TRUE(part.prepare(rig, {}, region).ok());
      Surface expected, surface;
      for (const Pose& pose : poses) {
        whole.smooth(pose, expected);
        part.smooth(pose, surface);
        const PartDifference found = differenceOfPart(surface, expected, region);
        all += count(region);
        different += found.triangles;
        EXPECT_LE(found.position, 1e-5f * character->height);
        EXPECT_LE(found.normal, 0.01f);
      }
    }
  }
  EXPECT_LT(different, all / 200) << "of " << all;
}

TEST(Region, WholeRegionIsTheWholeBody) {
  const auto limb = makeLimb();
  const Rig rig = randomRig(*limb, {}, 5);
  Smoother whole(limb), part(limb);
  const Region all(limb->mesh.triangles.size(), 1);
  ASSERT_TRUE(whole.prepare(rig).ok() && part.prepare(rig, {}, all).ok());
  const Pose pose = samplePose(limb->skeleton, limb->clips[0], 0.7f);
  Surface expected, surface;
  whole.smooth(pose, expected);
  part.smooth(pose, surface);
  EXPECT_TRUE(sameBytes(surface.positions, expected.positions));
  EXPECT_TRUE(sameBytes(surface.normals, expected.normals));
  EXPECT_EQ(surface.refinement->triangles, expected.refinement->triangles);
}

TEST(Region, RestKeepsTheControlTrianglesWithoutCracks) {
  const auto body = makeTwoLegged();
  const Region region = regionOf(*body, {"shin L"});
  Rig rig = randomRig(*body, {.primitives = 12}, 3);
  rig.smoothing.depth = 4;
  Smoother part(body);
  ASSERT_TRUE(part.prepare(rig, {}, region).ok());
  Surface surface;
  part.smooth(samplePose(body->skeleton, body->clips[0], 0.5f), surface);
  EXPECT_TRUE(isClosed(surface.refinement->triangles));
  EXPECT_TRUE(allFinite(surface.positions));
  EXPECT_TRUE(allUnit(surface.normals));
  // Found by shared vertices: 16 in the region and three rings around it, 1 if none of its edges is there.
  std::set<int> corners;
  std::vector<bool> refined(region.begin(), region.end());
  for (int ring = 0; ring < 3; ++ring) {
    for (std::size_t t = 0; t < refined.size(); ++t) {
      if (refined[t]) corners.insert(body->mesh.triangles[t].vertices.begin(), body->mesh.triangles[t].vertices.end());
    }
    for (std::size_t t = 0; t < refined.size(); ++t) {
      for (const int v : body->mesh.triangles[t].vertices) refined[t] = refined[t] || corners.contains(v);
    }
  }
  std::set<int> edges;
  for (std::size_t t = 0; t < refined.size(); ++t) {
    if (refined[t]) edges.insert(body->mesh.triangles[t].edges.begin(), body->mesh.triangles[t].edges.end());
  }
  int coarse = 0;
  for (std::size_t t = 0; t < refined.size(); ++t) {
    const auto& own = body->mesh.triangles[t].edges;
    const bool touches = std::ranges::any_of(own, [&](int e) { return edges.contains(e); });
    const int made = surface.refinement->refinedTriangles(static_cast<int>(t));
    EXPECT_TRUE(made == (refined[t] ? 16 : 1) || (touches && !refined[t])) << t << ": " << made;
    coarse += touches ? 0 : 1;
  }
  EXPECT_GT(coarse, 0);
}

TEST(Region, DoesNotDependOnEarlierPreparations) {
  const auto body = makeTwoLegged();
  const Region left = regionOf(*body, {"leg L"}), right = regionOf(*body, {"shin R"});
  Rig rig = randomRig(*body, {.primitives = 8}, 4);
  Smoother again(body);
  const Pose pose = samplePose(body->skeleton, body->clips[0], 0.3f);
  for (const Region& region : {Region{}, left, right, Region{}, right}) {
    for (const int depth : {2, 3}) {
      rig.smoothing.depth = depth;
      Smoother fresh(body);
      CrowdSmoother crowd(body);
      ASSERT_TRUE(again.prepare(rig, {}, region).ok() && fresh.prepare(rig, {}, region).ok() &&
                  crowd.prepare(rig, {}, region).ok());
      Surface expected, surface, twin, one;
      fresh.smooth(pose, expected);
      again.smooth(pose, surface);
      again.twin().smooth(pose, twin);
      crowd.smooth({&pose, 1}, {&one, 1});
      for (const Surface* made : {&surface, &twin, &one}) {
        EXPECT_EQ(made->refinement->triangles, expected.refinement->triangles);
        EXPECT_TRUE(sameBytes(made->positions, expected.positions));
        EXPECT_TRUE(sameBytes(made->normals, expected.normals));
      }
    }
  }
}

TEST(Region, BonesIncludeTheirDescendantsSkin) {
  const auto body = makeTwoLegged();
  const Region leg = regionOf(*body, {"leg L"}), shin = regionOf(*body, {"shin L"}), all = regionOf(*body, {"hips"});
  EXPECT_EQ(count(all), static_cast<int>(all.size()));
  EXPECT_EQ(count(regionOfBones(*body, {})), 0);
  EXPECT_LT(count(shin), count(leg));
  EXPECT_GT(count(shin), 0);
  for (std::size_t t = 0; t < leg.size(); ++t) {
    EXPECT_LE(shin[t], leg[t]) << "a shin hangs on its leg";
    if (leg[t] == 0) continue;
    for (const int v : body->mesh.triangles[t].vertices) {
      EXPECT_GT(body->mesh.positions[static_cast<std::size_t>(v)].x, -0.1f) << "the other leg";
    }
  }
}

TEST(Region, PartsGiveTheirTriangles) {
  Character two = *makeLimb();
  two.parts = {{"skin", 0}, {"sleeve", 0}};
  for (std::size_t t = 0; t < two.mesh.triangles.size(); t += 3) two.mesh.triangles[t].part = 1;
  const Region sleeve = regionOfParts(two, std::vector<int>{1});
  for (std::size_t t = 0; t < sleeve.size(); ++t) EXPECT_EQ(sleeve[t], t % 3 == 0 ? 1 : 0);
}

TEST(Region, RegionOfAnotherMeshIsRefused) {
  const auto limb = makeLimb();
  Smoother smoother(limb);
  const auto prepared = smoother.prepare(randomRig(*limb, {}, 1), {}, Region(3, 1));
  ASSERT_FALSE(prepared.ok());
  EXPECT_NE(prepared.error().text().find("region: expected a mark for each of"), std::string::npos);
}

}  // namespace
}  // namespace sinew::test
