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

/// The other corners of the triangles at each vertex. @param first [V' + 1] of each vertex's.
std::vector<int> otherCorners(const Refinement& refinement, const std::vector<std::size_t>& first) {
  std::vector<int> others(first.back());
  std::vector<std::size_t> next = first;
  for (const std::array<int, 3>& t : refinement.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      std::size_t& place = at(next, t[i]);
      others[place++] = t[(i + 1) % 3];
      others[place++] = t[(i + 2) % 3];
    }
  }
  return others;
}

}  // namespace

VertexRings vertexRings(const Refinement& refinement) {
  std::vector<std::size_t> first{0};
  for (const int triangles : refinement.trianglesAt) first.push_back(first.back() + 2 * toIndex(triangles));
  std::vector<int> others = otherCorners(refinement, first);
  VertexRings rings;
  rings.begin.push_back(0);
  rings.neighbours.reserve(others.size());
  for (int v = 0; v < refinement.vertexCount; ++v) {
    const std::size_t begin = at(first, v);
    const std::span<int> all = std::span(others).subspan(begin, at(first, v + 1) - begin);
    std::ranges::sort(all);
    const std::size_t step = comeTwice(all) ? 2 : 1;
    for (std::size_t i = 0; i < all.size(); i += step) rings.neighbours.push_back(all[i]);
    rings.share.push_back(all.empty() ? 0.0f : static_cast<float>(step) / static_cast<float>(all.size()));
    while (rings.neighbours.size() % VertexRings::kMultiple != 0) rings.neighbours.push_back(v);
    rings.begin.push_back(static_cast<int>(rings.neighbours.size()));
  }
  return rings;
}

}  // namespace sinew
