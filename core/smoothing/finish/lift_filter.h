// core/smoothing/finish/lift_filter.h: heights that the refined mesh is too coarse for. docs/design.md, Sampling.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/smoothing/finish/moved_triangles.h"

namespace sinew {

/// Low-pass filter for the heights of moved vertices, where they bend more than edges can follow.
///
/// A rim that is narrower than an edge is sampled high at one vertex and low at the next one, as the triangulation has
/// it: saw teeth. With M the mean over a vertex's neighbours, weighted by 1/length (0 for heights that grow evenly,
/// whatever the lengths), c = |(M - 1) s| over the edges' length says how far the mesh is from following s. The filter
/// is s += w (M - 1) s / 2, four times, w from 0 at c = 0.15 to 1 at 0.5, and at least that of each neighbour.
///
/// Heights keep their sign and never grow, so that a vertex that has not moved stays, and grooves between muscles stay
/// deep. Continuous in time and independent of the order of triangles.
class LiftFilter {
 public:
  /// @param moved  of these positions.  @param patch [V'] world.  @param positions [V'] world, in and out.
  /// @param heights [V'] signed, world units, in and out: how far each vertex has moved.
  /// @return [V'] w; empty if it is 0 everywhere. Valid until the next call.
  std::span<const float> apply(const Refinement& refinement, const MovedTriangles& moved,
                               std::span<const glm::vec3> patch, std::span<glm::vec3> positions,
                               std::span<float> heights);

 private:
  /// A refined triangle with 1/length of its edges; perLength[i] is opposite its corner i.
  struct Link {
    std::array<int, 3> corners{};
    std::array<float, 3> perLength{};
  };
  void measureEdges(const Refinement& refinement, const MovedTriangles& moved, std::span<const glm::vec3> patch,
                    std::span<const float> heights);
  [[nodiscard]] bool weigh(std::span<const float> heights);
  void sumDifferences(std::span<const float> values);
  void evenOut(std::span<const float> heights);

  std::vector<Link> links_;        ///< First all triangles that hold a height, then those at vertices with w > 0.
  std::vector<float> sum_;         ///< [V'] of perLength at a vertex.
  std::vector<float> edges_;       ///< [V'] how many there are, inside of the mesh each twice.
  std::vector<float> difference_;  ///< [V'] sum_ times (M - 1) s.
  std::vector<float> own_;         ///< [V'] w, of the vertex alone.
  std::vector<float> weights_;     ///< [V'] w.
  std::vector<float> filtered_;    ///< [V'] heights.
  std::vector<int> active_;        ///< Vertices with w > 0 and a height.
};

}  // namespace sinew
