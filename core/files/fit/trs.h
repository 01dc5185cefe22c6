// core/files/fit/trs.h: translation, rotation, scale: what a joint's node and its keys hold.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace sinew::exporting {

/// p -> translation + rotation * (scale * p).
struct Trs {
  glm::dvec3 translation{0.0};
  glm::dquat rotation{1.0, 0.0, 0.0, 0.0};  ///< Unit.
  glm::dvec3 scale{1.0};

  [[nodiscard]] glm::dmat4 toMatrix() const;
};

/// The parts of a matrix whose columns are at right angles and right-handed. Any other is replaced by the nearest by
/// columns: the second keeps its direction, the others lose what they share with it. A column of zeros gives scale 0.
[[nodiscard]] Trs trsOf(const glm::dmat4& matrix);

/// As floats hold it, the rotation unit again.
[[nodiscard]] Trs roundToFloats(const Trs& exact);

}  // namespace sinew::exporting
