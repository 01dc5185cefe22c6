// core/geometry/edge_sides.h: which triangles meet at an edge.
#pragma once

#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "core/geometry/at.h"
#include "sinew/geometry/control_mesh.h"

namespace sinew {

/// One triangle at one of its three edges.
struct EdgeSide {
  int triangle = 0;
  int side = 0;
};

/// The sides at every edge of a mesh, in triangle order.
class EdgeSides {
 public:
  explicit EdgeSides(const ControlMesh& mesh) : begin_(mesh.edges.size() + 1, 0), sides_(3 * mesh.triangles.size()) {
    for (const ControlTriangle& triangle : mesh.triangles) {
      for (const int edge : triangle.edges) ++at(begin_, edge + 1);
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (int i = 0; i < 3; ++i) sides_[at(next, at(mesh.triangles[t].edges, i))++] = {static_cast<int>(t), i};
    }
  }

  [[nodiscard]] std::span<const EdgeSide> of(int edge) const {
    return std::span(sides_).subspan(at(begin_, edge), at(begin_, edge + 1) - at(begin_, edge));
  }

 private:
  std::vector<std::size_t> begin_;  ///< [E + 1]
  std::vector<EdgeSide> sides_;     ///< [3 T]
};

}  // namespace sinew
