// tests/viewport/gpu/card_surface_test.cpp: surfaces computed on the GPU match the CPU's.
#include "app/viewport/gpu/card_surface.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/bodies/fit_preset.h"
#include "core/files/preset_json.h"
#include "core/rig/twins.h"
#include "sinew/character/character_pose.h"
#include "sinew/files/gltf_import.h"
#include "tests/support/characters/morphing_post.h"
#include "tests/support/characters/synthetic_characters.h"
#include "tests/support/rigs/keyed_links.h"
#include "tests/support/rigs/random_animation.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewport/gpu/on_card.h"

namespace sinew::test {
namespace {

using app::CardSurface;

/// SINEW_SAMPLE_TIMES in the environment: number of sample times, spread over the clips.
int moments(int few) {
  const char* const more = std::getenv("SINEW_SAMPLE_TIMES");
  return more != nullptr ? std::max(std::atoi(more), 1) : few;
}

class GpuSurface : public OnCard {
 protected:
  /// Compares a scene in all poses. @return the combined difference
  app::CardDifference compare(const TrialScene& scene, const std::vector<Pose>& poses) {
    const auto preparation = prepared(scene.character, scene.rig);
    CardSurface card = surfaceFor(preparation);
    app::CardDifference all;
    for (const Pose& pose : poses) {
      const auto difference = app::compareWithProcessor(preparation, pose, card);
      if (!difference) throw std::runtime_error(difference.error().text());
      expectClose(difference.value(), scene.name);
      EXPECT_TRUE(!preparation->swells() || card.readSlopesRest()) << scene.name;
      all.add(difference.value());
    }
    std::printf(
        "  %s: roots %.1e H, surface %.1e H, normals %.2f degrees; %d of %d left to double precision; %d triangles "
        "turned over, %d on the processor\n",
        scene.name.c_str(), all.roots, all.surface, all.normals, all.unsure, all.vertices, all.turned,
        all.turnedOnProcessor);
    return all;
  }
};

template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

TEST_F(GpuSurface, MatchesTheProcessorOnBundledRigs) {
  for (const char* name : {"humanoid", "horse", "demo", "tangle", "humanoid-flex", "horse-flex"}) {
    const TrialScene scene = bundledTrialScene(name);
    const app::CardDifference seen = compare(scene, spreadPoses(*scene.character, moments(2)));
    EXPECT_GT(seen.vertices, 5000) << name;
  }
}

TEST_F(GpuSurface, MatchesTheProcessorOnBundledReplaceRigs) {
  for (const char* name : {"wrapped", "humanoid-wrapped", "horse-wrapped"}) {
    const TrialScene scene = bundledTrialScene(name);
    (void)compare(scene, spreadPoses(*scene.character, moments(2)));
  }
  // Muscles that do not wrap the body: `replace` with limits, slopes, folds and normals.
  TrialScene horse = bundledTrialScene("demo");
  horse.rig = withMode(horse.rig, SurfaceMode::kReplace);
  horse.name = "demo, replace";
  (void)compare(horse, spreadPoses(*horse.character, 1));
}

// As the tool lays them: a group for each muscle, shaped bellies, lines.
TEST_F(GpuSurface, MatchesTheProcessorOnMuscleSets) {
  for (const auto& [name, set] : {std::pair{"humanoid", "athlete"}, std::pair{"horse", "animal"}}) {
    TrialScene scene = bundledTrialScene(name);
    const auto file = std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "presets" / (std::string(set) + ".json");
    const Preset preset = loadPreset(file).value();
    scene.rig = fitPreset({}, preset, {}, *scene.character, makeMirrorPlan(*scene.character)).value().rig;
    scene.rig.smoothing.detail = DetailKind::kAdaptive;
    EXPECT_GT(scene.rig.groups.size(), 25u) << name;
    (void)compare(scene, spreadPoses(*scene.character, moments(1)));
  }
}

// Carves, groups that do not blend, steep rims, every patch kind, adaptive and uniform detail, muscles of any shape.
TEST_F(GpuSurface, MatchesTheProcessorOnRandomRigs) {
  const auto character = makeTwoLegged();
  for (const float shapedChance : {0.0f, 1.0f}) {
    int unsure = 0;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      RigRecipe recipe = seed % 2 == 0 ? RigRecipe{} : kShortReach;
      recipe.groups = 1 + static_cast<int>(seed % 4);
      recipe.carveChance = 0.3f;
      recipe.primitives = 16;
      recipe.shapedChance = shapedChance;
      Rig rig = randomRig(*character, recipe, seed);
      rig.smoothing.detail = seed % 3 == 0 ? DetailKind::kAdaptive : DetailKind::kUniform;
      rig.smoothing.depth = 4;
      rig.smoothing.patch = static_cast<PatchKind>(seed % 4);
      rig.surface.mode = SurfaceMode::kSwell;
      const std::string name = (shapedChance > 0.0f ? "shapes, seed " : "seed ") + std::to_string(seed);
      unsure += compare({name, character, rig}, {randomPose(character->skeleton, 0.6f, 0.3f, seed)}).unsure;
    }
    EXPECT_GT(unsure, 0) << "the path in double precision is not tried";
  }
}

/// Grooves of new documents, and wide ones.
constexpr std::array kGrooves{0.015f, 0.05f};

std::string softName(const std::string& name, float grooves) {
  return name + ", grooves " + std::to_string(grooves).substr(0, 5);
}

TEST_F(GpuSurface, MatchesTheProcessorWithSoftGrooves) {
  for (const float grooves : kGrooves) {
    for (const char* name : {"humanoid", "tangle", "horse-flex"}) {
      TrialScene scene = bundledTrialScene(name);
      scene.rig.surface.grooves = grooves;
      scene.name = softName(name, grooves);
      (void)compare(scene, spreadPoses(*scene.character, moments(1)));
    }
  }
}

// Groups none of which or some of which are linked, carves, muscles of any shape.
TEST_F(GpuSurface, MatchesTheProcessorOnRandomRigsWithSoftGrooves) {
  const auto character = makeTwoLegged();
  for (const float grooves : kGrooves) {
    int unsure = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      RigRecipe recipe = seed % 2 == 0 ? RigRecipe{} : kShortReach;
      recipe.groups = 2 + static_cast<int>(seed % 7);
      recipe.linkChance = seed % 4 == 0 ? 0.0f : 0.4f;
      recipe.carveChance = 0.2f;
      recipe.primitives = 24;
      const bool shaped = seed % 3 == 1;
      recipe.shapedChance = shaped ? 1.0f : 0.0f;
      Rig rig = randomRig(*character, recipe, seed);
      rig.smoothing.depth = 4;
      rig.smoothing.detail = DetailKind::kUniform;
      rig.surface.mode = SurfaceMode::kSwell;
      rig.surface.grooves = grooves;
      const char* const kind = shaped ? "shapes, seed " : "seed ";
      unsure += compare({softName(kind + std::to_string(seed), grooves), character, rig},
                        {randomPose(character->skeleton, 0.6f, 0.3f, seed)})
                    .unsure;
    }
    EXPECT_GT(unsure, 0) << "the path in double precision is not tried";
  }
}

// Bundled and random rigs, carves, muscles of any shape, crisp and soft grooves.
TEST_F(GpuSurface, MatchesTheProcessorWithLinksInPart) {
  for (const float grooves : {0.0f, kGrooves[0]}) {
    for (const char* name : {"humanoid", "tangle"}) {
      TrialScene scene = bundledTrialScene(name);
      scene.rig.surface.grooves = grooves;
      for (std::size_t i = 0; i < scene.rig.links.size(); ++i) scene.rig.links[i].amount = i % 2 ? 0.7f : 0.4f;
      scene.name = softName(std::string(name) + ", links in part", grooves);
      (void)compare(scene, spreadPoses(*scene.character, moments(1)));
    }
    const auto character = makeTwoLegged();
    int unsure = 0;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      RigRecipe recipe = seed % 2 == 0 ? RigRecipe{} : kShortReach;
      recipe.groups = 3 + static_cast<int>(seed % 4);
      recipe.linkChance = 0.7f;
      recipe.partChance = 0.7f;
      recipe.carveChance = 0.2f;
      recipe.primitives = 20;
      recipe.shapedChance = seed % 3 == 1 ? 1.0f : 0.0f;
      Rig rig = randomRig(*character, recipe, seed + 300);
      rig.smoothing.depth = 4;
      rig.smoothing.detail = DetailKind::kUniform;
      rig.surface.mode = SurfaceMode::kSwell;
      rig.surface.grooves = grooves;
      const std::string name = "links in part, seed " + std::to_string(seed);
      unsure += compare({softName(name, grooves), character, rig}, {randomPose(character->skeleton, 0.6f, 0.3f, seed)})
                    .unsure;
    }
    EXPECT_GT(unsure, 0) << "the path in double precision is not tried";
  }
}

TEST_F(GpuSurface, MatchesTheProcessorWhereAmountsOfLinksChange) {
  TrialScene scene = bundledTrialScene("humanoid");
  const AnimationClip& clip = scene.character->clips.front();
  scene.rig = withKeyedLinks(scene.rig, clip, 4);
  scene.name = "keyed links";
  std::vector<Pose> poses;
  for (const float part : {0.1f, 0.8f}) {
    poses.push_back(samplePose(scene.character->skeleton, clip, part * clip.duration));
  }
  (void)compare(scene, poses);
}

// Muscle parameters that follow the pose, and morph targets.
TEST_F(GpuSurface, MatchesTheProcessorWithDriversAndMorphTargets) {
  const auto limb = makeLimb();
  const TrialScene driven{"keys and drivers", limb, withMode(animatedLimbRig(*limb, 3), SurfaceMode::kSwell)};
  (void)compare(driven, spreadPoses(*limb, 3));

  const TemporaryFolder folder;
  const auto post = importGltf(folder.write("post.glb", makeMorphingPost(3, 6).file.glb())).value();
  RigRecipe recipe;
  recipe.radiusHigh = 0.3f;
  TrialScene morphing{"morph targets", post, withMode(randomRig(*post, recipe, 2), SurfaceMode::kSwell)};
  std::vector<Pose> poses;
  for (const float time : {0.1f, 0.3f, 0.0f}) poses.push_back(samplePose(*post, post->clips.front(), time));
  (void)compare(morphing, poses);
}

TEST_F(GpuSurface, MatchesTheProcessorOnRealCharacters) {
  int tried = 0;
  for (const TrialScene& scene : trialScenes()) {
    if (scene.name == "wrapped" || scene.name == "tangle") continue;
    TrialScene swelling = scene;
    swelling.rig = withMode(scene.rig, SurfaceMode::kSwell);
    const std::vector<Pose> poses = spreadPoses(*scene.character, moments(1));
    (void)compare(swelling, {poses.begin() + (poses.size() > 1 ? 1 : 0), poses.end()});
    ++tried;
  }
  if (tried == 0) GTEST_SKIP() << "left out: no real character is at hand";
}

TEST_F(GpuSurface, DoesNotDependOnWorkGroupsOrCrowd) {
  const TrialScene scene = bundledTrialScene("tangle");
  const auto preparation = prepared(scene.character, scene.rig);
  const std::vector<Pose> poses = spreadPoses(*scene.character, 2);
  std::vector<std::vector<app::card::Drawn>> alone;
  CardSurface one = surfaceFor(preparation);
  for (const Pose& pose : poses) {
    ASSERT_FALSE(one.setPose(pose).has_value());
    one.make();
    alone.push_back(readDrawn(one));
  }
  // Earlier poses leave nothing behind.
  ASSERT_FALSE(one.setPose(poses.front()).has_value());
  one.make();
  EXPECT_TRUE(sameBytes(readDrawn(one), alone.front()));

  // Five groups along an axis, for many rows and a partial last row.
  CardSurface narrow = surfaceFor(preparation, {1, 5});
  ASSERT_FALSE(narrow.setPose(poses.back()).has_value());
  narrow.make();
  EXPECT_TRUE(sameBytes(readDrawn(narrow), alone.back()));

  const auto bodies = static_cast<int>(poses.size());
  CardSurface crowd = surfaceFor(preparation, {bodies, app::kMostGroupsAlong});
  for (int b = 0; b < bodies; ++b) ASSERT_FALSE(crowd.setPose(poses[static_cast<std::size_t>(b)], b).has_value());
  crowd.make();
  const std::vector<app::card::Drawn> all = readDrawn(crowd, poses.size());
  std::vector<app::card::Drawn> expected;
  for (const auto& body : alone) expected.insert(expected.end(), body.begin(), body.end());
  EXPECT_TRUE(sameBytes(all, expected));
}

TEST_F(GpuSurface, DrawnVerticesMatchTheSurface) {
  const TrialScene scene = bundledTrialScene("demo");
  const auto preparation = prepared(scene.character, scene.rig);
  CardSurface card = surfaceFor(preparation);
  ASSERT_FALSE(card.setPose(spreadPoses(*scene.character, 1).back()).has_value());
  card.make();
  const std::vector<app::card::Vertex> surface = card.readSurface();
  const std::vector<app::card::Drawn> drawn = readDrawn(card);
  ASSERT_EQ(drawn.size(), preparation->refinement().drawVertex.size());
  forEachDrawVertex(preparation->refinement(), [&](std::size_t d, std::size_t v) {
    const app::card::Drawn& at = drawn[d];
    EXPECT_EQ(glm::vec4(at.position[0], at.position[1], at.position[2], at.displacement), surface[v].position);
    EXPECT_EQ(glm::vec3(at.normal[0], at.normal[1], at.normal[2]), glm::vec3(surface[v].normal));
  });
}

}  // namespace
}  // namespace sinew::test
