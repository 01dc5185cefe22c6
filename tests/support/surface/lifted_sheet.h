// tests/support/surface/lifted_sheet.h: a small patch with skin lifted off it, for the stages that remove folds.
#pragma once

#include <functional>
#include <vector>

#include "core/surface/finish/fold.h"
#include "core/surface/finish/moved_triangles.h"
#include "core/surface/finish/vertex_rings.h"
#include "tests/support/surface/sheets.h"

namespace sinew::test {

struct LiftedSheet {
  ControlMesh mesh;
  Refinement refinement;  ///< Depth 1.
  VertexRings rings;
  std::vector<glm::vec3> patch;  ///< Positions; as the mesh unless a test poses it.
  std::vector<float> bindFronts;
  MovedTriangles moved;

  explicit LiftedSheet(const Sheet& sheet);
  [[nodiscard]] PatchView view() const { return {patch, mesh.normals, bindFronts}; }
  /// Least area of a triangle over its patch's, signed along the patch.
  [[nodiscard]] float leastArea(const std::vector<glm::vec3>& positions) const;
  /// Triangles whose area is below 0.
  [[nodiscard]] int turned(const std::vector<glm::vec3>& positions) const;
};

/// 20 by 20 cells.
[[nodiscard]] Sheet flatSheet();

/// A bump of vertices lifted by up to `lift` along directions that lean towards x = 0 from both sides.
[[nodiscard]] std::vector<glm::vec3> converging(const std::vector<glm::vec3>& patch, float lift);

/// Largest step of a vertex while the patch is lifted to `most` in this many steps, relative to the lift's step. For a
/// continuous function it does not grow with the number of steps. Prints it. @param finish  (lifted positions) ->
/// positions
[[nodiscard]] float steepestStep(const std::vector<glm::vec3>& patch, float most, int steps,
                                 const std::function<std::vector<glm::vec3>(std::vector<glm::vec3>)>& finish);

[[nodiscard]] float largestStep(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b);

}  // namespace sinew::test
