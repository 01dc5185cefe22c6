// core/smoothing/finish/lift_filter.h: heights that the refined mesh is too coarse for. docs/design.md, Sampling.
#pragma once

#include <span>
#include <vector>

#include "core/smoothing/finish/lift_edges.h"

namespace sinew {

/// Low-pass filter for the heights of moved vertices, where they bend more than edges can follow.
///
/// A rim that is narrower than an edge is sampled high at one vertex and low at the next one, as the triangulation has
/// it: saw teeth. With M the mean over a vertex's neighbors, weighted by 1/length (0 for heights that grow evenly,
/// whatever the lengths), c = |(M - 1) s| over the edges' length says how far the mesh is from following s. The filter
/// is s += w (M - 1) s / 2, four times, w from 0 at c = 0.15 to 1 at 0.5, and at least that of each neighbor that has
/// itself risen. Where levels were chosen so that flat triangles follow the surface, heights may bend and still be met:
/// there w is 0 where (M - 1) s is no more than that.
///
/// Heights keep their sign and never grow, so that a vertex that has not moved stays, and grooves between muscles stay
/// deep. Continuous in time and independent of the order of triangles.
class LiftFilter {
 public:
  static constexpr int kRounds = 4;

  /// @param edges  of these heights.  @param followed  world units: |(M - 1) s| up to which heights stay, from twice
  /// that on w is whole; 0: only c counts.  @param patch [V'] world.  @param positions [V'] world, in and out.
  /// @param heights [V'] signed, world units, in and out: how far each vertex has moved.
  /// @return [V'] w; empty if it is 0 everywhere. Valid until the next call.
  std::span<const float> apply(const LiftEdges& edges, float followed, std::span<const glm::vec3> patch,
                               std::span<glm::vec3> positions, std::span<float> heights);

 private:
  /// A vertex with a height and w > 0.
  struct Active {
    int vertex = 0;
    const SixEdges* edges = nullptr;
    LiftSums sums{};
  };
  [[nodiscard]] bool weigh(const LiftEdges& edges, float followed, std::size_t vertices);
  void raise(int vertex, float weight);
  void findActive(const LiftEdges& edges);
  void evenOut(const LiftEdges& edges, std::span<const float> heights);

  std::vector<float> weights_;  ///< [V'] w.
  std::vector<int> weighted_;   ///< Vertices with w > 0.
  std::vector<Active> active_;
  std::vector<float> filtered_;  ///< [V'] heights.
};

}  // namespace sinew
