// app/cli/render_plan.h: what a `sinew render` command line asks for, read and checked.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/render.h"
#include "app/render/scene.h"
#include "sinew/base/result.h"

namespace sinew::app {

/// One picture to make.
struct PlannedPicture {
  double time = 0.0;  ///< Seconds into the clip.
  std::filesystem::path file;
};

struct RenderPlan {
  std::vector<PlannedPicture> pictures;
  bool animated = false;  ///< A clip is wanted; else the bind pose.
  float yaw = 0.0f;       ///< Radians, as framing.h counts them.
  float pitch = 0.0f;
  glm::ivec2 size{1280, 800};
  DisplaySettings display;
  bool anchors = false;  ///< The segments from the control vertices to the skeleton.
};

/// Error: place is the option, reason what was expected of it.
[[nodiscard]] Result<RenderPlan> planRender(const RenderOptions& options);

}  // namespace sinew::app
