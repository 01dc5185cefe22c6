// app/command/render_input.h: an input of `sinew render`: its moments, and the view that holds them all.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/command/batch.h"
#include "app/command/render_plan.h"
#include "app/viewport/render/view.h"
#include "core/rig/posed_rig.h"
#include "sinew/character/animation_clip.h"
#include "sinew/character/character.h"

namespace sinew::app {

/// A picture of the job.
struct Moment {
  double time = 0.0;  ///< Seconds into the clip.
  float turn = 0.0f;  ///< Radians that the eye has gone around the character.
};

/// An input as it is to be drawn.
struct OpenedInput {
  std::shared_ptr<const Character> character;
  Rig rig;
  const AnimationClip* clip = nullptr;  ///< Null: the bind pose.
  std::vector<Moment> moments;          ///< All of the job that the clip holds, in order.
  std::vector<std::size_t> wanted;      ///< Those to be made now.
  std::string left;                     ///< As ClipFrames::left.
};

[[nodiscard]] Result<OpenedInput> openToRender(const RenderOptions& options, const RenderPlan& plan,
                                               const BatchInput& input);

/// One view for all moments, so that a clip's pictures stand still. Each turns it about the character.
struct SteadyView {
  View view;
  glm::vec3 center{0.0f};  ///< The vertical line through it is the axis.

  [[nodiscard]] View at(const Moment& moment) const;
};
[[nodiscard]] SteadyView steadyView(const OpenedInput& input, const RenderOptions& options, const RenderPlan& plan);

/// The rig with detail that follows the size on screen settled for all pictures, which is said.
[[nodiscard]] Rig settled(const OpenedInput& input, const View& view);

}  // namespace sinew::app
