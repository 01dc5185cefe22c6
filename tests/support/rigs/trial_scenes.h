// tests/support/rigs/trial_scenes.h: characters with rigs for tests of whole surfaces.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sinew/character/character.h"
#include "sinew/character/pose.h"
#include "sinew/rig/rig.h"

namespace sinew::test {

struct TrialScene {
  std::string name;
  std::shared_ptr<const Character> character;
  Rig rig;  ///< Its mode is the scene's own; tests set the mode they try.
};

/// assets/wrapped and assets/tangle with their rigs, always; then those of Fox, greenman, cesium_man and robot that are
/// at hand, each with 12 muscles set by rule (core/rig/trial_rig.h). Prints which are left out, once.
[[nodiscard]] const std::vector<TrialScene>& trialScenes();

/// One of assets, with its rig as it is.
[[nodiscard]] TrialScene bundledTrialScene(const std::string& name);

/// One of them; fails the test if there is none of that name.
[[nodiscard]] const TrialScene& trialScene(const std::string& name);

[[nodiscard]] Rig withMode(Rig rig, SurfaceMode mode);

/// The bind pose, then `count` poses spread over all clips.
[[nodiscard]] std::vector<Pose> spreadPoses(const Character& character, int count);

}  // namespace sinew::test
