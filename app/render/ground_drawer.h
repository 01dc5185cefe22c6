// app/render/ground_drawer.h: backdrop, grid and the character's soft shadow on the floor.
#pragma once

#include <array>

#include "app/render/frame.h"
#include "app/render/surface_drawer.h"

namespace sinew::app {

class GroundDrawer {
 public:
  [[nodiscard]] static Result<GroundDrawer> create();

  /// Draws the shadow into a texture of its own; changes framebuffer and viewport.
  void prepareShadow(const Frame& frame, const SurfaceDrawer& surface);
  void drawBackground(const Frame& frame) const;
  /// Over the opaque surface, tested against its depth.
  void drawGround(const Frame& frame) const;

 private:
  GroundDrawer();

  GlProgram shadowProgram_, shadowAlphaProgram_, blurProgram_, groundProgram_, groundShadowProgram_, backgroundProgram_;
  GlProgram chosenGround_, chosenBackground_;  ///< Where another background was chosen.
  GlVertexArray empty_;
  int shadowSize_ = 512;
  std::array<GlTexture, 2> shadowTextures_;
  std::array<GlFramebuffer, 2> shadowTargets_;
  glm::vec4 area_{0.0f};  ///< x and z of the shadow texture's low corner, 1 / extent on each.
};

/// How the floor follows the eye as it draws back or comes close.
struct GridZoom {
  float reach = 1.0f;        ///< Factor on the floor's extent, >= 1.
  float cell = 1.0f;         ///< Of the middle rank of lines, character units; the others a fifth and five times.
  float towardsNext = 0.0f;  ///< 0..1: how far the ranks have moved on; 1 looks as 0 with cells five times as large.
};
[[nodiscard]] GridZoom gridZoom(const View& view, const glm::vec3& centre, float height);

/// A round length (1, 2 or 5 times a power of ten) near a quarter of the height: the grid's cell.
[[nodiscard]] float gridCell(float height);

}  // namespace sinew::app
