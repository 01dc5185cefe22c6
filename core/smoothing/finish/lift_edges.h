// core/smoothing/finish/lift_edges.h: heights against the edges that carry them: what bounds and filters look at.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/at.h"
#include "core/smoothing/finish/lift_kernel.h"
#include "core/smoothing/finish/moved_triangles.h"
#include "core/smoothing/finish/vertex_rings.h"

namespace sinew {

/// A vertex with a height, and its edges.
struct LiftedVertex {
  int vertex = 0;
  std::size_t firstEdges = 0;  ///< Of its ring, in edges().
};

/// Heights of moved vertices with the lengths of their edges in the patch. Kept from pose to pose for its memory.
class LiftEdges {
 public:
  /// @param rings  must outlive the use.  @param moved  of these positions.  @param patch, positions [V'] world.
  /// @param heights [V'] signed, world units: how far each vertex has moved.
  /// @param slope  what steep is measured against.
  void measure(const VertexRings& rings, const MovedTriangles& moved, std::span<const glm::vec3> patch,
               std::span<const glm::vec3> positions, std::span<const float> heights, float slope);

  /// Sums anew around vertices whose heights have changed (setHeight).
  void sumAround(std::span<const int> vertices);

  [[nodiscard]] std::span<const LiftedVertex> lifted() const { return lifted_; }
  [[nodiscard]] std::span<const LiftSums> sums() const { return sums_; }  ///< [lifted]
  [[nodiscard]] const SixEdges* edges() const { return edges_.data(); }
  [[nodiscard]] std::span<const int> around(int vertex) const { return rings_->at(vertex); }
  [[nodiscard]] const VertexRings& rings() const { return *rings_; }

  // Of lifted vertices and their neighbors.
  [[nodiscard]] float height(int vertex) const { return at(places_, vertex).of[3]; }
  void setHeight(int vertex, float height) { at(places_, vertex).of[3] = height; }
  [[nodiscard]] float length(int a, int b) const;

 private:
  const VertexRings* rings_ = nullptr;
  std::vector<LiftedVertex> lifted_;
  std::vector<int> moved_;         ///< Vertices of lifted_.
  std::vector<int> indexOf_;       ///< [V'] in lifted_; -1: has no height. Of vertices in places_.
  std::vector<LiftPlace> places_;  ///< [V'] of moved vertices and their neighbors.
  std::vector<SixEdges> edges_;
  std::vector<LiftSums> sums_;
  std::vector<std::uint8_t> isSummed_;  ///< [lifted] scratch.
};

/// Sum over a ring of height differences per length. @param heights  (vertex) -> float
template <class Heights>
[[nodiscard]] float differenceOf(std::span<const int> ring, const SixEdges* edges, float own, const Heights& heights) {
  float difference = 0.0f;
  for (std::size_t i = 0; i < ring.size(); i += VertexRings::kMultiple, ++edges) {
    for (std::size_t k = 0; k < VertexRings::kMultiple; ++k) {
      difference += edges->perLength[SixEdges::kAt[k]] * (heights(ring[i + k]) - own);
    }
  }
  return difference;
}

}  // namespace sinew
