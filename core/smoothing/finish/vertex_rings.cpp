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

/// The triangles at each vertex. @param rings  with trianglesBegin.
void findTriangles(const Refinement& refinement, VertexRings& rings) {
  rings.triangles.resize(toIndex(rings.trianglesBegin.back()));
  std::vector<int> next = rings.trianglesBegin;
  for (int i = 0; i < static_cast<int>(refinement.triangles.size()); ++i) {
    for (const int corner : at(refinement.triangles, i)) at(rings.triangles, at(next, corner)++) = i;
  }
}

/// The other corners of the triangles at a vertex, ascending.
void otherCorners(const Refinement& refinement, int vertex, std::span<const int> triangles, std::vector<int>& out) {
  out.clear();
  for (const int i : triangles) {
    const std::array<int, 3>& t = at(refinement.triangles, i);
    const auto place = std::ranges::find(t, vertex) - t.begin();
    for (const std::ptrdiff_t step : {1, 2}) out.push_back(t[static_cast<std::size_t>((place + step) % 3)]);
  }
  std::ranges::sort(out);
}

}  // namespace

VertexRings vertexRings(const Refinement& refinement) {
  VertexRings rings;
  rings.trianglesBegin.push_back(0);
  for (const int count : refinement.trianglesAt) rings.trianglesBegin.push_back(rings.trianglesBegin.back() + count);
  findTriangles(refinement, rings);
  rings.begin.push_back(0);
  rings.neighbours.reserve(2 * rings.triangles.size());
  std::vector<int> all;
  for (int v = 0; v < refinement.vertexCount; ++v) {
    otherCorners(refinement, v, rings.trianglesOf(v), all);
    const std::size_t step = comeTwice(all) ? 2 : 1;
    for (std::size_t i = 0; i < all.size(); i += step) rings.neighbours.push_back(all[i]);
    rings.share.push_back(all.empty() ? 0.0f : static_cast<float>(step) / static_cast<float>(all.size()));
    while (rings.neighbours.size() % VertexRings::kMultiple != 0) rings.neighbours.push_back(v);
    rings.begin.push_back(static_cast<int>(rings.neighbours.size()));
  }
  return rings;
}

}  // namespace sinew
