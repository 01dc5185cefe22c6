// app/viewport/tools/viewport_context.h: what every viewport tool knows about the frame.
#pragma once

#include <vector>

#include "app/document/document.h"
#include "app/document/playback.h"
#include "app/viewport/render/scene.h"
#include "app/viewport/render/view.h"
#include "core/character/pose_override.h"
#include "sinew/surface/surface.h"

namespace sinew::app {

/// The surface as it is seen. Made when a tool first looks at it, where the graphics card draws (LiveSurface::surface).
class SeenSurface {
 public:
  SeenSurface(const Surface* made = nullptr) : made_(made) {}  // NOLINT: a surface is one that is seen.
  SeenSurface(const LiveSurface& live) : live_(&live) {}       // NOLINT
  explicit operator bool() const { return made_ != nullptr || live_ != nullptr; }
  const Surface& operator*() const { return live_ != nullptr ? live_->surface() : *made_; }
  const Surface* operator->() const { return &**this; }

 private:
  const Surface* made_ = nullptr;
  const LiveSurface* live_ = nullptr;
};

/// References and pointers are valid for the call. Tools change the document's commands and selection, nothing else.
struct ViewportContext {
  Document& document;
  const Pose& pose;                    ///< The frame's on the screen.
  SeenSurface surface{};               ///< None before the first smoothing: nothing can be picked on the skin.
  DisplaySettings display;             ///< Shown primitives can be picked, hidden ones not.
  glm::ivec2 size{1, 1};               ///< Viewport, pixels.
  float uiScale = 1.0f;                ///< Pixels per design pixel.
  PoseOverrides* overrides = nullptr;  ///< What `pose` was turned with: the pose tool changes it. Null: it cannot.
  std::vector<bool> hiddenBones{};     ///< [bones] neither drawn nor picked; empty: none is left out.
  bool playing = false;                ///< A clip moves the pose from frame to frame.
};

}  // namespace sinew::app
