// app/ui/offscreen.h: an OpenGL context without window or display.
#pragma once

#include <memory>

#include "sinew/geometry/result.h"

namespace sinew::app {

/// OpenGL 4.5 core by EGL: surfaceless, else on a device, else on the default display. Current on its thread until
/// destroyed. It has no framebuffer 0.
class OffscreenContext {
 public:
  [[nodiscard]] static Result<std::unique_ptr<OffscreenContext>> create();  ///< Error: no OpenGL 4.5 through EGL.
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
