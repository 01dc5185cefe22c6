// app/render/render_target.h: the picture's framebuffer: sRGB colour and depth, multisampled and resolved.
#pragma once

#include "app/render/gl_objects.h"

namespace sinew::app {

class RenderTarget {
 public:
  /// Makes or remakes what does not fit. Size >= 1x1; samples >= 1, clamped to what the driver offers.
  void resize(const glm::ivec2& size, int samples);
  /// Binds it for drawing, viewport included; values are encoded to sRGB on writing and blended linearly.
  void begin() const;
  /// Averages the samples into the texture.
  void end() const;

  [[nodiscard]] const glm::ivec2& size() const { return size_; }
  /// The finished picture read as it is stored (sRGB values, not decoded).
  [[nodiscard]] GLuint texture() const { return shown_.id(); }
  [[nodiscard]] GLuint framebuffer() const { return resolved_.id(); }

 private:
  glm::ivec2 size_{0};
  int samples_ = 0;
  GlTexture color_;
  GlTexture shown_;  ///< The same memory under a type that is not decoded.
  GlRenderbuffer depth_;
  GlRenderbuffer manyColor_;
  GlRenderbuffer manyDepth_;
  GlFramebuffer resolved_;
  GlFramebuffer many_;
};

}  // namespace sinew::app
