// tests/support/characters/motion.h: motion of vertices between frames relative to the skin that carries them.
#pragma once

#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "sinew/surface/surface.h"

namespace sinew::test {

/// Axes that move with the patch at one vertex: the normal, the direction to a neighbor orthogonal to it, and the
/// third.
struct PatchFrame {
  glm::vec3 origin{0.0f};
  glm::mat3 axes{1.0f};  ///< Columns.

  [[nodiscard]] glm::vec3 seen(const glm::vec3& point) const { return (point - origin) * axes; }
};

/// Displacements p' - patch of all vertices in these frames, so that a body that only rotates and bends changes
/// nothing.
class CarriedOffsets {
 public:
  explicit CarriedOffsets(const Refinement& refinement);

  /// @param patch the surface of the same character and pose without primitives.
  [[nodiscard]] std::vector<glm::vec3> of(const Surface& surface, const Surface& patch) const;
  [[nodiscard]] PatchFrame frame(const Surface& patch, int vertex) const;

 private:
  std::vector<int> neighbor_;  ///< [V'] a vertex that shares a small triangle.
};

}  // namespace sinew::test
