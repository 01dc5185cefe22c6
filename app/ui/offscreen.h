// app/ui/offscreen.h: an OpenGL context without window or display.
#pragma once

#include <memory>

#include "sinew/geometry/result.h"

namespace sinew::app {

/// OpenGL 4.5 core, made by EGL: surfaceless, else on a device, else on the default display. Current on the thread that
/// made it until destroyed; there is no framebuffer 0 to draw into, use your own (Viewport has one).
class OffscreenContext {
 public:
  /// Error: no EGL, or no driver that offers OpenGL 4.5.
  [[nodiscard]] static Result<std::unique_ptr<OffscreenContext>> create();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

 private:
  OffscreenContext() = default;
  void* display_ = nullptr;
  void* context_ = nullptr;
  void* surface_ = nullptr;
};

}  // namespace sinew::app
