// app/viewport/render/view.h: how the world meets the picture: matrices of one viewport at one moment.
#pragma once

#include "sinew/geometry/geometry.h"

namespace sinew::app {

/// Half line, world space; direction unit.
struct Ray {
  glm::vec3 origin{0.0f};
  glm::vec3 direction{0.0f, 0.0f, -1.0f};
};

/// A camera's matrices for a picture of `size` pixels. Pixels: x right, y down, (0, 0) the top left corner.
struct View {
  glm::mat4 viewFromWorld{1.0f};
  glm::mat4 clipFromView{1.0f};  ///< OpenGL clip space, depth -1..1.
  glm::vec3 eyeInWorld{0.0f};    ///< Perspective: the eye. Orthographic: a point behind everything along the view axis.
  bool orthographic = false;
  glm::ivec2 size{1, 1};

  [[nodiscard]] glm::mat4 clipFromWorld() const { return clipFromView * viewFromWorld; }
  /// Pixel of a point; z = depth in -1..1. w <= 0 (behind the eye) gives z > 1.
  [[nodiscard]] glm::vec3 toPixel(const glm::vec3& pointInWorld) const;
  /// Ray through a pixel, from the near plane's side.
  [[nodiscard]] Ray rayThrough(const glm::vec2& pixel) const;
  /// World length of one pixel at a point: what keeps a gizmo's size constant on screen.
  [[nodiscard]] float unitsPerPixelAt(const glm::vec3& pointInWorld) const;
  [[nodiscard]] glm::vec3 forwardInWorld() const;
  /// The point from which a surface turns the same sides to it as to the picture: the eye; without perspective, so far
  /// behind it that all its rays are parallel to a float.
  [[nodiscard]] glm::vec3 facingPoint() const;

  friend bool operator==(const View&, const View&) = default;
};

}  // namespace sinew::app
