// core/surface/finish/lift_filter.h: heights that the refined mesh is too coarse for. docs/design.md, Sampling.
#pragma once

#include <span>
#include <vector>

#include "core/surface/finish/lifted_heights.h"

namespace sinew {

/// Low-pass filter for the heights of moved vertices, where they bend more than edges can follow.
///
/// A rim that is narrower than an edge is sampled high at one vertex and low at the next one, as the triangulation has
/// it: saw teeth. With M the mean over a vertex's neighbors, weighted by 1/length (0 for heights that grow evenly,
/// whatever the lengths), c = |(M - 1) s| over the edges' length says how far the mesh is from following s. The filter
/// is s += w (M - 1) s / 2, four times, w from 0 at c = 0.15 to 1 at 0.5, and at least that of each neighbor that has
/// itself risen. Adaptive detail has chosen edges that can follow, and needs no filter.
///
/// Heights keep their sign and never grow, so that a vertex that has not moved stays, and grooves between muscles stay
/// deep. Continuous in time and independent of the order of triangles.
class LiftFilter {
 public:
  static constexpr int kRounds = 4;

  /// @param lifted  these heights.  @param patch [V'] world.  @param positions [V'] world, in and out.
  /// @param heights [V'] signed, world units, in and out: how far each vertex has moved.
  /// @return [V'] w; empty if it is 0 everywhere. Valid until the next call.
  std::span<const float> apply(const LiftedHeights& lifted, std::span<const glm::vec3> patch,
                               std::span<glm::vec3> positions, std::span<float> heights);

 private:
  /// A vertex with a height and w > 0.
  struct Active {
    int vertex = 0;
    const SixEdges* edges = nullptr;
    LiftSums sums{};
  };
  void measure(const LiftedHeights& lifted);
  [[nodiscard]] bool weigh(const LiftedHeights& lifted, std::size_t vertices);
  void raise(int vertex, float weight);
  void findActive(const LiftedHeights& lifted);
  void evenOut(const VertexRings& rings, std::span<const float> heights);

  std::vector<SixEdges> edges_;  ///< Of the rings of all lifted vertices, in order.
  std::vector<LiftSums> sums_;   ///< [lifted]
  std::vector<float> weights_;   ///< [V'] w.
  std::vector<int> weighted_;    ///< Vertices with w > 0.
  std::vector<Active> active_;
  std::vector<float> filtered_;  ///< [V'] heights.
};

}  // namespace sinew
