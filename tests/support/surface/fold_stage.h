// tests/support/surface/fold_stage.h: a stage that takes folds out of a lifted sheet, alone.
#pragma once

#include <vector>

#include "core/smoothing/finish/fold_relaxation.h"
#include "core/smoothing/finish/fold_spread.h"
#include "tests/support/surface/lifted_sheet.h"

namespace sinew::test {

/// @tparam Stage  FoldRelaxation or FoldSpread
template <class Stage>
struct FoldStage : LiftedSheet {
  using LiftedSheet::LiftedSheet;

  /// The sheet's skin after the stage.
  [[nodiscard]] std::vector<glm::vec3> applied(std::vector<glm::vec3> positions) {
    rings = vertexRings(refinement);  // A test may have changed the triangles.
    moved.find(mesh, refinement, rings, patch, positions);
    pairs_.fill(moved.corners, patch, positions);
    region_.find(mesh, refinement, rings, moved, view(), pairs_, positions, FoldRelaxation::kWholeArea);
    const std::vector<std::uint8_t> isBorder = borderVertices(mesh, refinement);
    mesh_.start(region_, isBorder, patch, positions);
    run(stage_);
    const std::span<const FoldMove> moves = mesh_.finish(positions);
    touched.assign(moves.begin(), moves.end());
    return positions;
  }

  std::vector<FoldMove> touched;  ///< By the last call.

 private:
  void run(FoldRelaxation& stage) { stage.apply(rings, mesh_); }
  void run(FoldSpread& stage) { stage.apply(mesh_); }

  VertexPairs pairs_;
  FoldRegion region_;
  FoldMesh mesh_;
  Stage stage_;
};

}  // namespace sinew::test
