// core/smoothing/finish/vertex_rings.cpp: lists with one entry for each triangle shared, halved where all come twice.
#include "core/smoothing/finish/vertex_rings.h"

#include <algorithm>
#include <array>
#include <compare>

#include "core/base/at.h"

namespace sinew {
namespace {

/// Another vertex of a triangle, and its third one.
struct Other {
  int vertex = 0;
  int third = 0;
  friend auto operator<=>(const Other&, const Other&) = default;
};

/// Every vertex comes exactly twice. @param sorted  ascending.
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

/// The others of the triangles at a vertex, ascending.
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

/// Lists of both vertices of every pair, filled up to multiples with the vertex itself.
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
  rings.begin.push_back(0);
  rings.neighbors.reserve(2 * rings.corners.size());
  std::vector<Other> all;
  std::vector<std::array<int, 2>> across;
  across.reserve(rings.corners.size() / 2);
  for (int v = 0; v < refinement.vertexCount; ++v) {
    otherVertices(refinement, rings.cornersOf(v), all);
    addAcross(v, all, across);
    const std::size_t step = comeTwice(all) ? 2 : 1;
    for (std::size_t i = 0; i < all.size(); i += step) rings.neighbors.push_back(all[i].vertex);
    rings.share.push_back(all.empty() ? 0.0f : static_cast<float>(step) / static_cast<float>(all.size()));
    while (rings.neighbors.size() % VertexRings::kMultiple != 0) rings.neighbors.push_back(v);
    rings.begin.push_back(static_cast<int>(rings.neighbors.size()));
  }
  listAcross(across, refinement.vertexCount, rings);
  return rings;
}

}  // namespace sinew
