// tests/support/rigs/trial_scenes.cpp: bundled scenes and real characters, loaded once.

#include "tests/support/rigs/trial_scenes.h"

#include <filesystem>
#include <iostream>

#include <gtest/gtest.h>

#include "core/rig/trial_rig.h"
#include "sinew/files/gltf_import.h"
#include "sinew/files/rig_json.h"
#include "tests/support/characters/real_characters.h"

namespace sinew::test {
namespace {

constexpr int kMuscles = 12;
constexpr std::uint64_t kSeed = 1;

std::vector<TrialScene> load() {
  std::vector<TrialScene> scenes{bundledTrialScene("wrapped"), bundledTrialScene("tangle")};
  for (const char* file : {"Fox.glb", "greenman.glb", "cesium_man.gltf", "robot.glb"}) {
    if (auto character = realCharacter(file)) {
      scenes.push_back({character->name, character, trialRig(*character, kMuscles, kSeed)});
    } else {
      std::cout << "  left out: " << file << " is not at hand\n";
    }
  }
  return scenes;
}

}  // namespace

TrialScene bundledTrialScene(const std::string& name) {
  const std::filesystem::path file = std::filesystem::path(SINEW_SOURCE_DIR) / "assets" / (name + ".rig.json");
  auto rig = loadRig(file);
  if (!rig) throw std::runtime_error(rig.error().text());
  auto character = importGltf(characterPath(rig.value(), file));
  if (!character) throw std::runtime_error(character.error().text());
  return {name, character.value(), rig.value()};
}

const std::vector<TrialScene>& trialScenes() {
  static const std::vector<TrialScene> scenes = load();
  return scenes;
}

const TrialScene& trialScene(const std::string& name) {
  for (const TrialScene& scene : trialScenes()) {
    if (scene.name == name) return scene;
  }
  ADD_FAILURE() << "no scene " << name;
  return trialScenes().front();
}

Rig withMode(Rig rig, SurfaceMode mode) {
  rig.surface.mode = mode;
  return rig;
}

std::vector<Pose> spreadPoses(const Character& character, int count) {
  std::vector<Pose> poses{bindPose(character.skeleton)};
  for (int i = 0; i < count && !character.clips.empty(); ++i) {
    const AnimationClip& clip = character.clips[static_cast<std::size_t>(i) % character.clips.size()];
    const float time = clip.duration * (static_cast<float>(i) + 0.37f) / static_cast<float>(count);
    poses.push_back(samplePose(character.skeleton, clip, time));
  }
  return poses;
}

}  // namespace sinew::test
