// app/viewport/render/ground_drawer.h: backdrop, grid and the character's soft shadow on the floor.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "app/viewport/render/frame.h"
#include "app/viewport/render/render_target.h"
#include "app/viewport/render/surface_drawer.h"

namespace sinew::app {

class GroundDrawer {
 public:
  [[nodiscard]] static Result<GroundDrawer> create();

  /// Draws the shadow into a texture of its own; changes framebuffer and viewport.
  void prepareShadow(const Frame& frame, const SurfaceDrawer& surface);
  void drawBackground(const Frame& frame) const;
  /// Over the opaque surface, tested against its depth.
  void drawGround(const Frame& frame) const;

  /// Copies background and floor into a target of one sample, drawn once for all pictures that show the same: in place
  /// of drawBackground(). With drawSunkOverKept() after it, depth cleared, and drawGroundOverKept() in place of
  /// drawGround() the picture is the same to the pixel. To be called while nothing waits to be drawn into the target:
  /// the copy would wait for that. Changes the framebuffer.
  /// @param boxes  outside of which the target holds the copy already, unless keptAnew(); 0..1, low and high corner,
  ///               from the top left. Empty: it may hold anything.
  /// @return false: they cannot be kept apart from the surface, and nothing was drawn.
  [[nodiscard]] bool copyKept(const RenderTarget& target, const Frame& frame, std::span<const glm::vec4> boxes);
  void drawSunkOverKept(const Frame& frame) const;
  void drawGroundOverKept(const Frame& frame) const;
  /// The last copyKept() has found another background or floor than before.
  [[nodiscard]] bool keptAnew() const { return keptAnew_; }
  /// On the floor: x and z of the low corner, 1 / extent on each.
  [[nodiscard]] const glm::vec4& shadowPlace() const { return area_; }

 private:
  /// All that background and floor depend on.
  struct KeptLook {
    View view;
    DisplaySettings settings;
    glm::vec3 center{0.0f};

    friend bool operator==(const KeptLook&, const KeptLook&) = default;
  };

  GroundDrawer();
  void blendQuad() const;  ///< Four corners from the vertex number: tested against depth, over what is there.
  void drawFloor(const Frame& frame) const;
  void drawShadow(const Frame& frame) const;

  GlProgram shadowProgram_, shadowAlphaProgram_, blurProgram_, groundProgram_, groundShadowProgram_, backgroundProgram_;
  GlProgram chosenGround_, chosenBackground_;  ///< Where another background was chosen.
  GlVertexArray empty_;
  int shadowSize_ = 512;
  std::array<GlTexture, 2> shadowTextures_;
  std::array<GlFramebuffer, 2> shadowTargets_;
  RenderTarget kept_;
  std::optional<KeptLook> keptLook_;
  bool keptAnew_ = false;
  glm::ivec4 sunk_{0};    ///< Pixels where the surface may lie below the floor: low corner and size, from below.
  glm::vec4 area_{0.0f};  ///< x and z of the shadow texture's low corner, 1 / extent on each.
};

/// How the floor follows the eye as it draws back or comes close.
struct GridZoom {
  float reach = 1.0f;        ///< Factor on the floor's extent, >= 1.
  float cell = 1.0f;         ///< The middle rank's, character units; a fifth of it and five times it in the others.
  float towardsNext = 0.0f;  ///< 0..1: how far the ranks have moved on; 1 looks as 0 with cells five times as large.
};
[[nodiscard]] GridZoom gridZoom(const View& view, const glm::vec3& center, float height);

/// A round length (1, 2 or 5 times a power of ten) near a quarter of the height: the grid's cell.
[[nodiscard]] float gridCell(float height);

}  // namespace sinew::app
