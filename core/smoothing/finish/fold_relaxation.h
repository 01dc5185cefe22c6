// core/smoothing/finish/fold_relaxation.h: folds of lifted skin are smoothed out. docs/design.md, Folds.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/smoothing/finish/fold.h"
#include "core/smoothing/finish/fold_watch.h"

namespace sinew {

/// A vertex that was moved, and where it was.
struct Relaxed {
  int vertex = 0;
  glm::vec3 from{0.0f};  ///< World.
};

/// Smooths lifted skin where refined triangles fold over.
///
/// The corners of a triangle with q below 0.4 (fold.h) are moved towards the mean of their neighbours, by all of the
/// way from q = 0 on, weighted by how far q can be trusted: neighbours come back into their order, and the skin stays
/// on the muscle. A weight that is no longer asked for falls by 1/4 a round. Up to 32 rounds, each of which reads the
/// one before alone: the order of triangles does not matter. A vertex goes no further than muscles have moved it, so
/// those that have not moved stay, and the result is continuous in time. Borders stay.
class FoldRelaxation {
 public:
  /// @param control  ascending: all control triangles that hold a moved vertex.
  /// @param isBorder [V'] borderVertices.  @param positions [V'] world, in and out.
  /// @return the vertices it moved, each once. Valid until the next call.
  std::span<const Relaxed> apply(const ControlMesh& mesh, const Refinement& refinement, std::span<const int> control,
                                 const PatchView& patch, std::span<const std::uint8_t> isBorder,
                                 std::span<glm::vec3> positions);

  /// Control triangles in and around which the last call found folds: beyond them none is left. Empty if it found none.
  [[nodiscard]] std::span<const int> watched() const { return watched_; }

 private:
  void weigh(const ControlMesh& mesh, const Refinement& refinement, std::span<const int> control, bool onlyRelaxed,
             const PatchView& patch, std::span<const std::uint8_t> isBorder, std::span<const glm::vec3> positions);
  void sumNeighbours(const Refinement& refinement, std::span<const int> control, std::span<const glm::vec3> positions);
  void move(const Refinement& refinement, const PatchView& patch, std::span<glm::vec3> positions);

  FoldWatch watch_;
  std::span<const int> watched_;
  std::vector<float> weights_;           ///< [V'] 0 but for folding_.
  std::vector<glm::vec3> sums_;          ///< [V'] over the neighbours, each twice; read only at folding_.
  std::vector<int> folding_;             ///< Vertices with a weight in this round.
  std::vector<glm::vec3> from_;          ///< [V'] read only where relaxed.
  std::vector<std::uint8_t> isRelaxed_;  ///< [V']
  std::vector<Relaxed> relaxed_;
};

/// [V'] 1: on an edge that has not two triangles.
[[nodiscard]] std::vector<std::uint8_t> borderVertices(const ControlMesh& mesh, const Refinement& refinement);

}  // namespace sinew
