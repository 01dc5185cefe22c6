// app/render/shape_colors.h: what ellipsoids and bones are drawn in. Linear.
#pragma once

#include "app/render/scene.h"

namespace sinew::app {

inline constexpr glm::vec3 kTerritoryColor{0.40f, 0.20f, 0.92f};

/// Muscles are warm, carves cold; selected ones glow.
[[nodiscard]] inline glm::vec3 shapeColor(const PrimitiveShape& shape) {
  if (shape.sign < 0) return shape.selected ? glm::vec3(0.10f, 0.62f, 1.00f) : glm::vec3(0.06f, 0.34f, 0.80f);
  return shape.selected ? glm::vec3(1.00f, 0.46f, 0.05f) : glm::vec3(0.85f, 0.20f, 0.11f);
}

}  // namespace sinew::app
