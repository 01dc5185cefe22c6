// core/smoothing/finish/vertex_rings.cpp: lists with one entry for each triangle shared, halved where all come twice.
#include "core/smoothing/finish/vertex_rings.h"

#include <algorithm>

#include "core/base/at.h"

namespace sinew {
namespace {

/// Every number comes exactly twice. @param sorted  ascending.
bool comeTwice(std::span<const int> sorted) {
  if (sorted.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < sorted.size(); i += 2) {
    if (sorted[i] != sorted[i + 1] || (i > 0 && sorted[i] == sorted[i - 1])) return false;
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
void otherVertices(const Refinement& refinement, std::span<const int> corners, std::vector<int>& out) {
  out.clear();
  for (const int corner : corners) {
    const std::array<int, 3>& t = at(refinement.triangles, corner / 3);
    for (const int step : {1, 2}) out.push_back(at(t, (corner + step) % 3));
  }
  std::ranges::sort(out);
}

}  // namespace

VertexRings vertexRings(const Refinement& refinement) {
  VertexRings rings;
  rings.cornersBegin.push_back(0);
  for (const int count : refinement.trianglesAt) rings.cornersBegin.push_back(rings.cornersBegin.back() + count);
  findCorners(refinement, rings);
  rings.begin.push_back(0);
  rings.neighbors.reserve(2 * rings.corners.size());
  std::vector<int> all;
  for (int v = 0; v < refinement.vertexCount; ++v) {
    otherVertices(refinement, rings.cornersOf(v), all);
    const std::size_t step = comeTwice(all) ? 2 : 1;
    for (std::size_t i = 0; i < all.size(); i += step) rings.neighbors.push_back(all[i]);
    rings.share.push_back(all.empty() ? 0.0f : static_cast<float>(step) / static_cast<float>(all.size()));
    while (rings.neighbors.size() % VertexRings::kMultiple != 0) rings.neighbors.push_back(v);
    rings.begin.push_back(static_cast<int>(rings.neighbors.size()));
  }
  return rings;
}

}  // namespace sinew
