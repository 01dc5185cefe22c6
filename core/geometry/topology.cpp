// core/geometry/topology.cpp: counts of vertices and edges, borders, non-manifold edges.
#include "core/geometry/topology.h"

#include <algorithm>

#include "core/geometry/at.h"
#include "core/geometry/index_table.h"

namespace sinew {

// A table of edges by their ends.

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

namespace {

std::array<int, 2> sortedEdge(int a, int b) { return a < b ? std::array{a, b} : std::array{b, a}; }

}  // namespace

Topology topologyOf(std::span<const std::array<int, 3>> triangles) {
  std::vector<std::array<int, 2>> edges;
  std::vector<int> vertices;
  edges.reserve(3 * triangles.size());
  vertices.reserve(3 * triangles.size());
  for (const std::array<int, 3>& triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      edges.push_back(sortedEdge(triangle[i], triangle[(i + 1) % 3]));
      vertices.push_back(triangle[i]);
    }
  }
  std::ranges::sort(edges);
  std::ranges::sort(vertices);

  Topology result;
  result.triangles = static_cast<int>(triangles.size());
  result.vertices = static_cast<int>(std::unique(vertices.begin(), vertices.end()) - vertices.begin());
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end] == edges[i]) ++end;
    ++result.edges;
    if (end - i == 1) result.borderEdges.push_back(edges[i]);
    if (end - i > 2) result.nonManifoldEdges.push_back(edges[i]);
    i = end;
  }
  return result;
}

Topology topologyOf(const ControlMesh& mesh) {
  std::vector<std::array<int, 3>> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const ControlTriangle& triangle : mesh.triangles) triangles.push_back(triangle.vertices);
  return topologyOf(triangles);
}

}  // namespace sinew
