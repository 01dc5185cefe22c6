// core/surface/patches/sample_points.h: refined vertices without the triangles between them.
#pragma once

#include <cstddef>

#include "core/geometry/at.h"
#include "sinew/geometry/control_mesh.h"
#include "sinew/surface/refinement.h"

namespace sinew {

/// Calls visit(j, k, vertex) for the samples of a triangle at barycentric (n-j-k, j, k) / n, row j = 0 first, k
/// ascending. @param points  samplePoints() with n inside the triangle and multiples of n along its sides
template <class Visit>
void forEachSample(const ControlMesh& mesh, const Refinement& points, int t, int n, Visit visit) {
  const ControlTriangle& triangle = at(mesh.triangles, t);
  const auto onSide = [&](std::size_t side, int step) {
    const int edge = triangle.edges[side];
    const int stride = points.edgeLevel(edge) / n;
    const bool forward = at(mesh.edges, edge).vertices[0] == triangle.vertices[side];
    return points.edgeVertex(edge, (forward ? step : n - step) * stride);
  };
  int inside = at(points.insideBegin, t);
  for (int j = 0; j <= n; ++j) {
    for (int k = 0; k <= n - j; ++k) {
      if (j + k == 0) visit(j, k, triangle.vertices[0]);
      else if (j == n) visit(j, k, triangle.vertices[1]);
      else if (k == n) visit(j, k, triangle.vertices[2]);
      else if (k == 0) visit(j, k, onSide(0, j));
      else if (j + k == n) visit(j, k, onSide(1, k));
      else if (j == 0) visit(j, k, onSide(2, n - k));
      else visit(j, k, inside++);
    }
  }
}

/// Vertices along edges and inside triangles, spaced evenly as in an n^2 split, with an n for each edge and triangle.
/// The result has no triangles and draws nothing.  @param samples  0 and 1: no vertices
[[nodiscard]] Refinement samplePoints(const ControlMesh& mesh, const RefinementLevels& samples);

}  // namespace sinew
