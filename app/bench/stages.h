// app/bench/stages.h: what each stage of smoothing takes of a frame in `swell`.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sinew/base/result.h"
#include "sinew/smoothing/smoother.h"

namespace sinew::app {

struct StageTrial {
  std::string scene;
  std::shared_ptr<const Character> character;
  Rig rig;  ///< Its mode, projection and depth do not matter.
  int frames = 8;
  int rounds = 15;
};

/// One depth of one scene.
struct StageRow {
  std::string scene;
  int depth = 1;
  double projected = 0.0;     ///< Vertices a root was sought for, mean of the frames.
  double frameSeconds = 0.0;  ///< Of the stages' least times, mean of the frames.
  StageSeconds shares;        ///< Of the sum of the least times of all frames.
};

/// `swell` by newton at depths 3 and 5. Frames are spread evenly over the first clip, or are the bind pose. Error: the
/// rig cannot be prepared.
[[nodiscard]] Result<std::vector<StageRow>> measureStages(const StageTrial& trial);

[[nodiscard]] std::string tableOf(const std::vector<StageRow>& rows);

}  // namespace sinew::app
