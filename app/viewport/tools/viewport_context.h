// app/viewport/tools/viewport_context.h: the frame as viewport tools see it.
#pragma once

#include <vector>

#include "app/document/document.h"
#include "app/document/playback.h"
#include "app/viewport/render/scene.h"
#include "app/viewport/render/view.h"
#include "core/character/pose_override.h"
#include "sinew/surface/surface.h"

namespace sinew::app {

/// The shown surface. Where the graphics card draws, computed when a tool first needs it (LiveSurface::surface).
class SeenSurface {
 public:
  SeenSurface(const Surface* made = nullptr) : made_(made) {}  // NOLINT
  SeenSurface(const LiveSurface& live) : live_(&live) {}       // NOLINT
  explicit operator bool() const { return made_ != nullptr || live_ != nullptr; }
  const Surface& operator*() const { return live_ != nullptr ? live_->surface() : *made_; }
  const Surface* operator->() const { return &**this; }

 private:
  const Surface* made_ = nullptr;
  const LiveSurface* live_ = nullptr;
};

/// Valid for the call. Tools change only the document's commands and selection, and `overrides`.
struct ViewportContext {
  Document& document;
  const Pose& pose;                    ///< On the screen.
  SeenSurface surface{};               ///< Null before the first smoothing: the skin cannot be picked.
  DisplaySettings display;             ///< Shown primitives can be picked, hidden ones not.
  glm::ivec2 size{1, 1};               ///< Viewport, pixels.
  float uiScale = 1.0f;                ///< Pixels per design pixel.
  PoseOverrides* overrides = nullptr;  ///< Changed by the pose tool, if not null.
  std::vector<bool> hiddenBones{};     ///< [bones]; empty: none.
  bool playing = false;                ///< A clip moves the pose from frame to frame.
};

}  // namespace sinew::app
