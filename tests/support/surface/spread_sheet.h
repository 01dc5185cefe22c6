// tests/support/surface/spread_sheet.h: folds taken out of a lifted sheet, without the stages around.
#pragma once

#include <vector>

#include "core/surface/finish/fold_spread.h"
#include "core/surface/finish/vertex_rings.h"
#include "tests/support/surface/lifted_sheet.h"

namespace sinew::test {

struct SpreadSheet : LiftedSheet {
  using LiftedSheet::LiftedSheet;

  /// The sheet's skin after the spread.
  [[nodiscard]] std::vector<glm::vec3> spread(std::vector<glm::vec3> positions) {
    rings = vertexRings(refinement);  // A test may have changed the triangles.
    moved.find(refinement, patch, positions);
    pairs_.fill(moved.corners, patch, positions);
    region_.find(mesh, refinement, rings, moved, view(), pairs_, positions, FoldSpread::kLeastArea);
    const std::vector<std::uint8_t> isBorder = borderVertices(mesh, refinement);
    mesh_.start(region_, isBorder, patch, positions);
    spread_.apply(mesh_);
    const std::span<const FoldMove> moves = mesh_.finish(positions);
    touched.assign(moves.begin(), moves.end());
    return positions;
  }

  std::vector<FoldMove> touched;  ///< By the last call.

 private:
  VertexPairs pairs_;
  FoldRegion region_;
  FoldMesh mesh_;
  FoldSpread spread_;
};

}  // namespace sinew::test
