// app/viewport/render/occlusion.h: ambient occlusion: of the picture, and baked for each vertex.
#pragma once

#include <span>
#include <vector>

#include "app/viewport/render/frame.h"
#include "app/viewport/render/muscle_drawer.h"
#include "app/viewport/render/surface_drawer.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew::app {

/// A texture with the light that the surroundings leave to each pixel of the opaque surface or, instead, the muscles.
class ScreenOcclusion {
 public:
  [[nodiscard]] static Result<ScreenOcclusion> create();

  /// Draws and binds it for surface.frag. Changes framebuffer and viewport.
  /// @param sample  number in a mean, selects the directions; below 0: a single picture, blurred more
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

/// Cosine-weighted openness of each control vertex in the bind pose, 0 (enclosed) to 1, for distances up to a third of
/// the body. Coarse (voxels of 1/56 of the body): it shades arm pits, not pores. Deterministic; about 20 ms for 10,000
/// vertices. @return [V]
[[nodiscard]] std::vector<float> bakeOpenness(const ControlMesh& mesh);

/// Barycentric interpolation of values [V] to [V'] of a refinement of this mesh.
[[nodiscard]] std::vector<float> spreadOverRefinement(std::span<const float> values, const ControlMesh& mesh,
                                                      const Refinement& refinement);

}  // namespace sinew::app
