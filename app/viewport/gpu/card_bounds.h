// app/viewport/gpu/card_bounds.h: a box around a surface whose vertices nobody reads back.
#pragma once

#include <span>
#include <vector>

#include "core/surface/posed_field.h"
#include "sinew/geometry/geometry.h"

namespace sinew::app {

/// What each binding carries of the control mesh: a skinned vertex lies between the places that its bindings give it.
class CarriedBounds {
 public:
  explicit CarriedBounds(const Character& character);

  /// Holds the surface of a pose: the skin, the bulge of its patches, and what muscles add.
  /// @param matrices [bindings] from the bind pose to the pose
  [[nodiscard]] Bounds at(std::span<const glm::mat4> matrices, std::span<const PosedPrimitive> muscles) const;

 private:
  std::vector<Bounds> boxes_;  ///< [bindings] bind pose.
  float bulge_ = 0.0f;         ///< World.
};

}  // namespace sinew::app
