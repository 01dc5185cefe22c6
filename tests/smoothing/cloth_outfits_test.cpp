// tests/smoothing/cloth_outfits_test.cpp: clothes of any cut stay above the skin of a muscular body, in folds too.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "core/base/at.h"
#include "core/body/fit_preset.h"
#include "core/check/cloth_check.h"
#include "core/io/preset_json.h"
#include "core/symmetry/mirror.h"
#include "sinew/smoothing/smoother.h"
#include "tests/support/characters/dressed_humanoid.h"

namespace sinew {
namespace {

/// The shipped set of muscles, uniformly fine.
Rig athleteOn(const Character& character) {
  const std::filesystem::path presets = std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / "presets";
  const Preset preset = loadPreset(presets / "athlete.json").value();
  Rig rig = fitPreset({}, preset, {}, character, makeMirrorPlan(character)).value().rig;
  rig.smoothing.detail = DetailKind::kUniform;
  rig.smoothing.depth = 3;
  return rig;
}

std::vector<Pose> posesOfClips(const Character& character, int each) {
  std::vector<Pose> poses;
  for (const AnimationClip& clip : character.clips) {
    for (int i = 0; i < each; ++i) {
      const float time = clip.duration * static_cast<float>(i) / static_cast<float>(each);
      poses.push_back(samplePose(character.skeleton, clip, time));
    }
  }
  return poses;
}

class ClothesOf : public ::testing::TestWithParam<test::Outfit> {};

TEST_P(ClothesOf, StayAboveTheSkinInFoldsToo) {
  const auto character = test::dressedHumanoid(GetParam());
  const std::vector<Pose> poses = posesOfClips(*character, 12);
  const ClothCount count = countClothBelow(character, athleteOn(*character), poses).value();
  EXPECT_GT(count.vertices, 3000);
  EXPECT_LE(count.below, count.bare);
  // Of ten thousand, those that no way out was found for: two walls of a fold that lie in each other.
  const double all = static_cast<double>(count.vertices) * static_cast<double>(poses.size());
  const double most = GetParam() == test::Outfit::kLoose ? 3e-4 : 1e-4;
  EXPECT_LE(static_cast<double>(count.more), most * all) << "deepest " << count.deepest << " H in pose " << count.worst;
}

INSTANTIATE_TEST_SUITE_P(Outfits, ClothesOf, ::testing::ValuesIn(test::kOutfits), [](const auto& outfit) {
  std::string name = test::nameOf(outfit.param);
  std::erase(name, ' ');
  return name;
});

}  // namespace
}  // namespace sinew
