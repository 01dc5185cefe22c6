// app/viewport/render/shape_colors.h: what ellipsoids and bones are drawn in. Linear.
#pragma once

#include <glm/common.hpp>

#include "app/document/group_colors.h"
#include "app/viewport/render/scene.h"

namespace sinew::app {

/// The outline of one ellipsoid, by what it is at the moment.
struct OutlineLook {
  glm::vec3 color{1.0f};
  float opacity = 1.0f;
  float width = 0.0f;   ///< Design pixels; 0: none.
  float dashes = 0.0f;  ///< Around the ellipsoid; 0: unbroken.
};

/// Its group's color; a selected one a little lighter.
[[nodiscard]] inline glm::vec3 shapeColor(const PrimitiveShape& shape) {
  return shape.selected ? glm::mix(shape.color, glm::vec3(1.0f), 0.12f) : shape.color;
}

/// Amber: selected, the active one brightest. Broken amber: its twin. White: hovered.
[[nodiscard]] inline OutlineLook outlineLook(const PrimitiveShape& shape) {
  if (shape.active) return {{1.00f, 0.66f, 0.10f}, 1.0f, 3.0f, 0.0f};
  if (shape.selected) return {{0.95f, 0.32f, 0.04f}, 1.0f, 2.2f, 0.0f};
  if (shape.hovered) return {{1.00f, 1.00f, 1.00f}, 0.72f, 1.8f, 0.0f};
  if (shape.twin) return {{1.00f, 0.60f, 0.12f}, 0.85f, 2.2f, 20.0f};
  return {};
}

}  // namespace sinew::app
