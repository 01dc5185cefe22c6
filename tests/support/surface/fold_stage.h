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
    moves_.start(positions.size());
    region_.find(mesh, refinement, rings, moved, view(), pairs_, positions, FoldRelaxation::kWholeArea);
    run(stage_, borderVertices(mesh, refinement), positions);
    touched.assign(moves_.list().begin(), moves_.list().end());
    return positions;
  }

  std::vector<FoldMove> touched;  ///< By the last call.

 private:
  void run(FoldRelaxation& stage, const std::vector<std::uint8_t>& isBorder, std::vector<glm::vec3>& positions) {
    stage.apply(rings, isBorder, patch, region_, moves_, positions);
  }
  void run(FoldSpread& stage, const std::vector<std::uint8_t>& isBorder, std::vector<glm::vec3>& positions) {
    stage.apply(isBorder, patch, region_, moves_, positions);
  }

  VertexPairs pairs_;
  FoldRegion region_;
  FoldMoves moves_;
  Stage stage_;
};

}  // namespace sinew::test
