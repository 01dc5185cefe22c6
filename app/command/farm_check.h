// app/command/farm_check.h: whether a job that a farm is to run can be run, and what a task of it takes.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "app/command/batch.h"
#include "app/command/clip_frames.h"
#include "app/document/farm_job.h"
#include "sinew/geometry/result.h"

namespace sinew::app {

struct FarmCheck {
  std::size_t files = 0;  ///< That the job makes.
  TaskNeeds needs;
};

/// What one input of a job comes to.
struct InputCheck {
  std::shared_ptr<const Character> character;
  Rig rig;  ///< With what the command line changes.
  ClipFrames frames;
  double heldFrames = 0.0;  ///< As taskNeeds().
};

/// Opens every input as the verb would. Error: there is none, a file is missing or cannot be read, a clip does not
/// exist or has none of the frames, or a folder to write to does not exist.
[[nodiscard]] Result<FarmCheck> checkForFarm(const std::string& verb, const Batch& batch, const BatchOptions& options,
                                             const std::function<Result<InputCheck>(const BatchInput&)>& open);

}  // namespace sinew::app
