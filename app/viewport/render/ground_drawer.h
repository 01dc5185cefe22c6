// app/viewport/render/ground_drawer.h: backdrop, grid and the character's shadow on the floor.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "app/viewport/render/frame.h"
#include "app/viewport/render/gl_objects.h"
#include "app/viewport/render/surface_drawer.h"

namespace sinew::app {

class GroundDrawer {
 public:
  [[nodiscard]] static Result<GroundDrawer> create();

  /// Draws the shadow into its own texture. Changes framebuffer and viewport.
  void prepareShadow(const Frame& frame, const SurfaceDrawer& surface);
  void drawBackground(const Frame& frame) const;
  void drawGround(const Frame& frame) const;  ///< Over the opaque surface, with depth test.

  /// Copies the kept background and floor, redrawn when they change, into a target of one sample, in place of
  /// drawBackground(). With drawSunkOverKept() after clearing the depth and drawGroundOverKept() in place of
  /// drawGround() the picture is the same to the pixel. Call it while no drawing into the target is pending: the copy
  /// would wait. Changes the framebuffer.
  /// @param boxes  the target holds the copy outside of these, unless keptAnew(); 0..1, low and high corner from the
  /// top left; empty: copies all  @return false: the surface may be anywhere below the floor; nothing was drawn
  [[nodiscard]] bool copyKept(const RenderTarget& target, const Frame& frame, std::span<const glm::vec4> boxes);
  void drawSunkOverKept(const Frame& frame) const;
  void drawGroundOverKept(const Frame& frame) const;
  /// Whether the last copyKept() redrew background and floor.
  [[nodiscard]] bool keptAnew() const { return keptAnew_; }
  /// x and z of the shadow texture's low corner, 1 / extent on each.
  [[nodiscard]] const glm::vec4& shadowPlace() const { return area_; }

 private:
  /// Everything that background and floor depend on.
  struct KeptLook {
    View view;
    DisplaySettings settings;
    glm::vec3 center{0.0f};

    friend bool operator==(const KeptLook&, const KeptLook&) = default;
  };

  GroundDrawer();
  void blendQuad() const;  ///< With depth test.
  void drawFloor(const Frame& frame) const;
  void drawShadow(const Frame& frame) const;

  GlProgram shadowProgram_, shadowAlphaProgram_, blurProgram_, groundProgram_, groundShadowProgram_, backgroundProgram_;
  GlProgram chosenGround_, chosenBackground_;  ///< For other backgrounds than the studio.
  GlVertexArray empty_;
  int shadowSize_ = 512;
  std::array<GlTexture, 2> shadowTextures_;
  std::array<GlFramebuffer, 2> shadowTargets_;
  RenderTarget kept_;
  std::optional<KeptLook> keptLook_;
  bool keptAnew_ = false;
  glm::ivec4 sunk_{0};    ///< Pixels where the surface may lie below the floor: low corner and size, from below.
  glm::vec4 area_{0.0f};  ///< shadowPlace().
};

/// Scale of the grid for a distance of the eye.
struct GridZoom {
  float reach = 1.0f;        ///< Factor on the floor's extent, >= 1.
  float cell = 1.0f;         ///< Middle rank, character units; the others have a fifth and five times it.
  float towardsNext = 0.0f;  ///< 0..1: blend to the next rank; 1 looks like 0 with five times the cells.
};
[[nodiscard]] GridZoom gridZoom(const View& view, const glm::vec3& center, float height);

[[nodiscard]] float gridCell(float height);  ///< Cell near a quarter of the height: 1, 2 or 5 times a power of ten.

}  // namespace sinew::app
