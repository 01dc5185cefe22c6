// core/geometry/edges.cpp: a table of edges by their ends.
#include "core/geometry/edges.h"

#include <algorithm>

#include "core/geometry/at.h"
#include "core/geometry/index_table.h"

namespace sinew {

void findEdges(ControlMesh& mesh) {
  mesh.edges.clear();
  IndexTable table(3 * mesh.triangles.size());
  for (ControlTriangle& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = triangle.vertices[i];
      const int b = triangle.vertices[(i + 1) % 3];
      const std::array<int, 2> ends{std::min(a, b), std::max(a, b)};
      const std::uint64_t hash = hashCombine(static_cast<std::uint64_t>(ends[0]), static_cast<std::uint64_t>(ends[1]));
      const int next = static_cast<int>(mesh.edges.size());
      const int found = table.findOrInsert(hash, next, [&](int e) { return at(mesh.edges, e).vertices == ends; });
      if (found == next) mesh.edges.push_back({.vertices = ends});
      ++at(mesh.edges, found).triangleCount;
      triangle.edges[i] = found;
    }
  }
}

}  // namespace sinew
