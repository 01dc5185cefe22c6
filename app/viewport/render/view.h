// app/viewport/render/view.h: camera matrices of one picture, and views that frame something.
#pragma once

#include <array>
#include <span>
#include <vector>

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
  [[nodiscard]] Ray rayThrough(const glm::vec2& pixel) const;  ///< Ray through a pixel, from the near plane's side.
  [[nodiscard]] float unitsPerPixelAt(const glm::vec3& pointInWorld) const;  ///< World length of one pixel at a point.
  [[nodiscard]] glm::vec3 forwardInWorld() const;
  /// Point to which surfaces face as they do to the picture: the eye, or, without perspective, a point so far behind
  /// it that all rays are parallel in floats.
  [[nodiscard]] glm::vec3 facingPoint() const;

  friend bool operator==(const View&, const View&) = default;
};

[[nodiscard]] std::array<glm::vec3, 8> cornersOf(const Bounds& box);  ///< Bit i of the index: high in axis i.
[[nodiscard]] std::vector<glm::vec3> evenDirections(int count);       ///< Unit vectors spread evenly over the sphere.

inline constexpr float kFieldOfView = 0.55f;    ///< Radians, along the picture's height.
inline constexpr float kDefaultMargin = 0.08f;  ///< Fraction of the picture left free on each side.

/// Camera axes for angles in radians. yaw 0 looks at the front (from +Z towards -Z), positive yaw moves the eye to +X;
/// positive pitch lifts the eye. Columns: right, up, backward (towards the eye).
[[nodiscard]] glm::mat3 cameraAxes(float yaw, float pitch);

/// The nearest eye for which all points lie inside the picture less its margin. Near and far planes leave room for a
/// ground. No points: the unit box. @param margin  0..0.45, fraction of width and height left free on each side
[[nodiscard]] View framedView(std::span<const glm::vec3> points, float yaw, float pitch, const glm::ivec2& size,
                              bool orthographic, float margin = kDefaultMargin);
[[nodiscard]] View framedView(const Bounds& bounds, float yaw, float pitch, const glm::ivec2& size, bool orthographic,
                              float margin = kDefaultMargin);

/// Eye at target + backward * distance. Orthographic: the picture that a perspective eye at that distance would show
/// of the target. Near and far planes suit a scene of about `reach` around the target.
[[nodiscard]] View orbitView(const glm::vec3& target, float yaw, float pitch, float distance, const glm::ivec2& size,
                             bool orthographic, float reach);

/// Points furthest along evenDirections: few points that frame nearly as all of them do.
[[nodiscard]] std::vector<glm::vec3> extremePoints(std::span<const glm::vec3> points);

}  // namespace sinew::app
