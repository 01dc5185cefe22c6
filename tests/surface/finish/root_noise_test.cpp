// tests/surface/finish/root_noise_test.cpp: roots that differ by no more than search methods do give the same surface.

#include <algorithm>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/surface/stages.h"
#include "tests/support/long_run.h"
#include "tests/support/rigs/random_rigs.h"
#include "tests/support/rigs/trial_scenes.h"

namespace sinew::test {
namespace {

constexpr float kNoise = 1e-7f;  ///< Fractions of H.
constexpr float kMostNoise = 1e-5f;

/// Runs a rig's stages after projection twice for each pose: with the roots as they are and with perturbed ones.
class Noisy {
 public:
  Noisy(const TrialScene& scene, const Rig& rig) : character_(*scene.character) {
    BlendingGraphMemo graphs;
    preparation_ = prepare(characterTables(scene.character), rig, {}, nullptr, graphs).value();
  }

  /// Largest distance of a vertex between the two surfaces, fraction of H.
  float amplified(const Pose& pose) {
    preparation_->poser->pose(pose, rig_);
    poseFieldAndSkin(preparation_, rig_, pose, posed_);
    Surface first;
    layPatch(*preparation_, posed_, workspace_, first);
    project(*preparation_, posed_, pose, std::nullopt, workspace_, first);
    Surface second = first;
    disturb(second);
    finish(first);
    finish(second);
    float most = 0.0f;
    for (std::size_t v = 0; v < first.positions.size(); ++v) {
      most = std::max(most, glm::distance(first.positions[v], second.positions[v]));
    }
    return most / character_.height;
  }

 private:
  /// Each height is perturbed by up to kNoise, but keeps its sign.
  void disturb(Surface& surface) {
    const float noise = kNoise * character_.height;
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
      float& height = surface.displacement[v];
      if (std::abs(height) < 2.0f * noise) continue;
      const glm::vec3 way = surface.positions[v] - workspace_.patchPositions[v];
      const float off = random_.uniform(-noise, noise);
      surface.positions[v] += (off / height) * way;
      height += off;
    }
  }

  void finish(Surface& surface) {
    if (findMoved(*preparation_, posed_, workspace_, surface)) unfold(*preparation_, posed_, workspace_, surface);
  }

  const Character& character_;
  std::shared_ptr<const Preparation> preparation_;
  PosedRig rig_;
  PosedField posed_;
  Workspace workspace_;
  Random random_{17};
};

float worstOf(const TrialScene& scene, const Rig& rig) {
  Noisy noisy(scene, rig);
  float worst = 0.0f;
  for (const Pose& pose : spreadPoses(*scene.character, longRun() ? 8 : 4))
    worst = std::max(worst, noisy.amplified(pose));
  for (std::uint64_t seed = 1; seed <= (longRun() ? 6u : 3u); ++seed) {  // Joints bent further than in any clip.
    worst = std::max(worst, noisy.amplified(randomPose(scene.character->skeleton, 1.5f, 0.0f, seed)));
  }
  return worst;
}

TEST(RootNoise, IsNotAmplified) {
  for (const char* name : {"humanoid", "humanoid-flex", "horse", "horse-flex", "tangle"}) {
    TrialScene scene = bundledTrialScene(name);
    Rig random = randomRig(*scene.character, kShortReach, 4);
    for (const int depth : {3, 5, 0}) {  // 0: adaptive.
      for (Rig* rig : {&scene.rig, &random}) {
        rig->smoothing.detail = depth > 0 ? DetailKind::kUniform : DetailKind::kAdaptive;
        rig->smoothing.depth = std::max(depth, 1);
      }
      const float own = worstOf(scene, withMode(scene.rig, SurfaceMode::kSwell));
      const float atRandom = worstOf(scene, random);
      std::printf("  %-14s depth %d: roots off by 1e-7 H move skin by up to %.2g H, with random muscles %.2g H\n", name,
                  depth, double{own}, double{atRandom});
      EXPECT_LE(own, kMostNoise) << name << ", depth " << depth;
      EXPECT_LE(atRandom, kMostNoise) << name << ", depth " << depth;
    }
  }
}

}  // namespace
}  // namespace sinew::test
