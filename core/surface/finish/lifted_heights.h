// core/surface/finish/lifted_heights.h: the heights of moved vertices with the patch that carries them: what bounds
// and filters look at.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/at.h"
#include "core/surface/finish/lift_kernel.h"
#include "core/surface/finish/moved_triangles.h"
#include "core/surface/finish/vertex_rings.h"

namespace sinew {

/// Heights over places of the patch. Kept from pose to pose for its memory.
class LiftedHeights {
 public:
  /// @param rings  must outlive the use.  @param moved  of these positions.  @param patch, positions [V'] world.
  /// @param heights [V'] signed, world units: how far each vertex has moved.
  void start(const VertexRings& rings, const MovedTriangles& moved, std::span<const glm::vec3> patch,
             std::span<const glm::vec3> positions, std::span<const float> heights);

  [[nodiscard]] std::span<const int> lifted() const { return lifted_; }  ///< Vertices with a height. Ascending.
  [[nodiscard]] const VertexRings& rings() const { return *rings_; }
  [[nodiscard]] const LiftPlace* places() const { return places_.data(); }  ///< [V'] as height() can be asked for.

  // Of lifted vertices, their neighbors and those across.
  [[nodiscard]] float height(int vertex) const { return at(places_, vertex).of[3]; }
  void setHeight(int vertex, float height) { at(places_, vertex).of[3] = height; }
  [[nodiscard]] float distance(int a, int b) const;  ///< On the patch.

 private:
  const VertexRings* rings_ = nullptr;
  std::vector<int> lifted_;
  std::vector<LiftPlace> places_;
};

}  // namespace sinew
