// core/surface/finish/vertex_rings.cpp: lists with one entry for each triangle shared, halved where all come twice.
#include "core/surface/finish/vertex_rings.h"

#include <algorithm>
#include <array>
#include <compare>

#include "core/geometry/parallel.h"

namespace sinew {

// The ends of open control edges, and all that refinement puts between them.

std::vector<std::uint8_t> borderVertices(const ControlMesh& mesh, const Refinement& refinement) {
  std::vector<std::uint8_t> out(static_cast<std::size_t>(refinement.vertexCount), 0);
  for (int e = 0; e < static_cast<int>(mesh.edges.size()); ++e) {
    const Edge& edge = at(mesh.edges, e);
    if (edge.triangleCount > 1) continue;
    for (const int end : edge.vertices) at(out, end) = 1;
    for (int step = 1; step <= refinement.edgeVertices(e); ++step) {
      at(out, refinement.edgeVertex(e, step)) = 1;
    }
  }
  return out;
}

namespace {

/// Another vertex of a triangle, and its third one.
struct Other {
  int vertex = 0;
  int third = 0;
  friend auto operator<=>(const Other&, const Other&) = default;
};

/// Whether every vertex occurs exactly twice. @param sorted  ascending.
bool comeTwice(std::span<const Other> sorted) {
  if (sorted.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < sorted.size(); i += 2) {
    if (sorted[i].vertex != sorted[i + 1].vertex || (i > 0 && sorted[i].vertex == sorted[i - 1].vertex)) return false;
  }
  return true;
}

/// @param rings  with cornersBegin.
void findCorners(const Refinement& refinement, VertexRings& rings) {
  rings.corners.resize(toIndex(rings.cornersBegin.back()));
  rings.placeOf.reserve(rings.corners.size());
  std::vector<int> next = rings.cornersBegin;
  int corner = 0;
  for (const std::array<int, 3>& t : refinement.triangles) {
    for (const int vertex : t) {
      rings.placeOf.push_back(at(next, vertex));
      at(rings.corners, at(next, vertex)++) = corner++;
    }
  }
}

/// Other vertices of the triangles at a vertex, ascending.
void otherVertices(const Refinement& refinement, std::span<const int> corners, std::vector<Other>& out) {
  out.clear();
  for (const int corner : corners) {
    const std::array<int, 3>& t = at(refinement.triangles, corner / 3);
    const int next = at(t, (corner + 1) % 3);
    const int last = at(t, (corner + 2) % 3);
    out.push_back({next, last});
    out.push_back({last, next});
  }
  std::ranges::sort(out);
}

/// Pairs of vertices across the edges from a vertex to those with larger numbers.
void addAcross(int vertex, std::span<const Other> sorted, std::vector<std::array<int, 2>>& out) {
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    for (std::size_t k = i + 1; k < sorted.size() && sorted[k].vertex == sorted[i].vertex; ++k) {
      if (vertex < sorted[i].vertex && sorted[i].third != sorted[k].third) {
        out.push_back({sorted[i].third, sorted[k].third});
      }
    }
  }
}

constexpr std::size_t kRingBlock = 4096;  ///< Vertices whose lists one thread makes.

/// Lists of the vertices of a block, one after another.
struct RingBlock {
  std::vector<int> neighbors;              ///< As in VertexRings.
  std::vector<std::array<int, 2>> across;  ///< From addAcross().
};

/// @param rings  with corners. Fills rings.share, and rings.begin[v + 1] with the number of neighbors of v.
void listBlock(const Refinement& refinement, std::size_t begin, std::size_t end, VertexRings& rings, RingBlock& out) {
  std::vector<Other> all;
  for (std::size_t v = begin; v < end; ++v) {
    const auto vertex = static_cast<int>(v);
    const std::size_t before = out.neighbors.size();
    otherVertices(refinement, rings.cornersOf(vertex), all);
    addAcross(vertex, all, out.across);
    const std::size_t step = comeTwice(all) ? 2 : 1;
    for (std::size_t i = 0; i < all.size(); i += step) out.neighbors.push_back(all[i].vertex);
    rings.share[v] = all.empty() ? 0.0f : static_cast<float>(step) / static_cast<float>(all.size());
    while (out.neighbors.size() % VertexRings::kMultiple != 0) out.neighbors.push_back(vertex);
    rings.begin[v + 1] = static_cast<int>(out.neighbors.size() - before);
  }
}

/// Lists each vertex of every pair for the other one, padded to multiples with the vertex itself.
void listAcross(std::span<const std::array<int, 2>> pairs, int vertices, VertexRings& rings) {
  std::vector<int> next(toIndex(vertices) + 1, 0);
  for (const auto& pair : pairs) {
    for (const int v : pair) ++at(next, v);
  }
  rings.acrossBegin.reserve(next.size());
  rings.acrossBegin.push_back(0);
  for (int v = 0; v < vertices; ++v) {
    constexpr int kMultiple = static_cast<int>(VertexRings::kMultiple);
    const int room = (at(next, v) + kMultiple - 1) / kMultiple * kMultiple;
    at(next, v) = rings.acrossBegin.back();
    rings.acrossBegin.push_back(rings.acrossBegin.back() + room);
  }
  rings.across.resize(toIndex(rings.acrossBegin.back()));
  for (const auto& [a, b] : pairs) {
    at(rings.across, at(next, a)++) = b;
    at(rings.across, at(next, b)++) = a;
  }
  for (int v = 0; v < vertices; ++v) {
    while (at(next, v) < at(rings.acrossBegin, v + 1)) at(rings.across, at(next, v)++) = v;
  }
}

}  // namespace

VertexRings vertexRings(const Refinement& refinement) {
  VertexRings rings;
  rings.cornersBegin.push_back(0);
  for (const int count : refinement.trianglesAt) rings.cornersBegin.push_back(rings.cornersBegin.back() + count);
  findCorners(refinement, rings);
  const std::size_t vertices = toIndex(refinement.vertexCount);
  rings.begin.assign(vertices + 1, 0);
  rings.share.resize(vertices);
  std::vector<RingBlock> blocks((vertices + kRingBlock - 1) / kRingBlock);
  forEachIndex(blocks.size(), 1, [&](std::size_t block) {
    const std::size_t begin = block * kRingBlock;
    listBlock(refinement, begin, std::min(begin + kRingBlock, vertices), rings, blocks[block]);
  });
  std::vector<std::array<int, 2>> across;
  rings.neighbors.reserve(2 * rings.corners.size());
  across.reserve(rings.corners.size() / 2);
  for (const RingBlock& block : blocks) {
    rings.neighbors.insert(rings.neighbors.end(), block.neighbors.begin(), block.neighbors.end());
    across.insert(across.end(), block.across.begin(), block.across.end());
  }
  for (std::size_t v = 0; v < vertices; ++v) rings.begin[v + 1] += rings.begin[v];
  listAcross(across, refinement.vertexCount, rings);
  return rings;
}

}  // namespace sinew
