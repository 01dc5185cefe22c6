// app/viewport/render/screen_occlusion.h: ambient occlusion from what the picture shows: crevices and folds that
// muscles make.
#pragma once

#include "app/viewport/render/frame.h"
#include "app/viewport/render/muscle_drawer.h"
#include "app/viewport/render/surface_drawer.h"

namespace sinew::app {

/// A texture of the picture's size that says of every pixel of the opaque surface, or of the muscles where those are
/// shown in its place, how much light its surroundings leave.
class ScreenOcclusion {
 public:
  [[nodiscard]] static Result<ScreenOcclusion> create();

  /// Draws it, and binds it where surface.frag looks for it. Changes framebuffer and viewport.
  /// @param sample  one of many that are averaged, each with other directions; below 0: a single one, blurred more.
  void prepare(const Frame& frame, const SurfaceDrawer& surface, const MuscleDrawer& muscles, int sample);

 private:
  ScreenOcclusion();
  void resize(const glm::ivec2& size);
  void drawSurface(const Frame& frame, const SurfaceDrawer& surface, const MuscleDrawer& muscles) const;

  GlProgram surfaceProgram_, occlusionProgram_, blurProgram_;
  GlVertexArray empty_;
  glm::ivec2 size_{0};
  GlTexture surface_;
  GlRenderbuffer depth_;
  GlFramebuffer surfaceTarget_;
  GlTexture open_, blurred_;
  GlFramebuffer openTarget_, blurredTarget_;
};

}  // namespace sinew::app
