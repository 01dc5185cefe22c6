// core/smoothing/finish/fold_relaxation.h: folds of lifted skin are smoothed out. docs/design.md, Folds.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/smoothing/finish/fold_mesh.h"
#include "core/smoothing/finish/vertex_rings.h"
#include "sinew/mesh/control_mesh.h"

namespace sinew {

/// Smooths lifted skin where refined triangles fold over.
///
/// The corners of a triangle with q below 0.4 (fold.h) are moved towards the mean of their neighbors, by a fifth of the
/// way from q = 0 on, weighted by how far q can be trusted: neighbors come back towards their order, and the skin stays
/// on the muscle. A weight that is no longer asked for falls by 1/4 a round. Up to 6 rounds, each of which reads the
/// one before alone: the order of triangles does not matter.
///
/// The q of a sliver changes as fast as the sliver is thin, and the mean of a corner's neighbors may be many times its
/// altitude away. So no corner is moved by more, a round, than a fifth of twice the length that one of its triangles
/// has lacked. The result is continuous in time, and no faster around slivers than elsewhere.
class FoldRelaxation {
 public:
  /// q below which a triangle is relaxed.
  static constexpr float kWholeArea = 0.4f;
  static constexpr int kMostRounds = 6;

  /// @param rings  of the refinement.  @param mesh  its region found with kWholeArea.
  void apply(const VertexRings& rings, FoldMesh& mesh);

 private:
  void askOf(int triangle, FoldMesh& mesh);
  void mergeWeights(FoldMesh& mesh);
  void findMeans(const VertexRings& rings, FoldMesh& mesh);
  void moveToMeans(FoldMesh& mesh);

  std::vector<int> asking_;       ///< Of the mesh's vertices: asked for in this round.
  std::vector<int> folding_;      ///< Those with a weight.
  std::vector<glm::vec3> means_;  ///< [folding_] of the neighbors.
};

/// [V'] 1: on an edge with a single triangle. (Where more than two meet they share their vertices: nothing can open.)
[[nodiscard]] std::vector<std::uint8_t> borderVertices(const ControlMesh& mesh, const Refinement& refinement);

}  // namespace sinew
