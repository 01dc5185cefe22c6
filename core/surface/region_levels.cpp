// core/surface/region_levels.cpp: what belongs to a region, and the levels in and around it.
#include "core/surface/region_levels.h"

#include <algorithm>

#include "core/geometry/at.h"

namespace sinew {
namespace {

/// Adds triangles that share a vertex with the region.
void growRegion(const ControlMesh& mesh, Region& region) {
  std::vector<bool> isCorner(mesh.positions.size(), false);
  for (std::size_t t = 0; t < region.size(); ++t) {
    if (region[t] == 0) continue;
    for (const int v : mesh.triangles[t].vertices) isCorner[toIndex(v)] = true;
  }
  for (std::size_t t = 0; t < region.size(); ++t) {
    if (std::ranges::any_of(mesh.triangles[t].vertices, [&](int v) { return isCorner[toIndex(v)]; })) region[t] = 1;
  }
}

template <class Holds>
Region regionWhere(const ControlMesh& mesh, Holds holds) {
  Region region;
  for (const ControlTriangle& triangle : mesh.triangles) region.push_back(holds(triangle) ? 1 : 0);
  return region;
}

}  // namespace

Region regionOfBones(const Character& character, std::span<const int> bones) {
  const Skeleton& skeleton = character.skeleton;
  const ControlMesh& mesh = character.mesh;
  std::vector<bool> chosen(skeleton.bones.size(), false);
  for (const int bone : bones) chosen[toIndex(bone)] = true;
  for (std::size_t b = 0; b < chosen.size(); ++b) {  // Parents come first.
    const int parent = skeleton.bones[b].parent;
    if (parent >= 0 && chosen[toIndex(parent)]) chosen[b] = true;
  }
  std::vector<bool> follows;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    float share = 0.0f;
    for (const Influence& influence : mesh.influencesOf(static_cast<int>(v))) {
      if (chosen[toIndex(at(skeleton.bindings, influence.binding).bone)]) share += influence.weight;
    }
    follows.push_back(share >= 0.5f);
  }
  return regionWhere(mesh, [&](const ControlTriangle& triangle) {
    return std::ranges::any_of(triangle.vertices, [&](int v) { return follows[toIndex(v)]; });
  });
}

Region regionOfParts(const Character& character, std::span<const int> parts) {
  return regionWhere(character.mesh, [&](const ControlTriangle& triangle) {
    return std::ranges::find(parts, triangle.part) != parts.end();
  });
}

RefinementLevels inRegion(const ControlMesh& mesh, RefinementLevels levels, const Region& region) {
  Region refined = region;
  for (int ring = 0; ring < kRegionMargin; ++ring) growRegion(mesh, refined);
  std::vector<bool> keeps(mesh.edges.size(), false);
  for (std::size_t t = 0; t < refined.size(); ++t) {
    if (refined[t] == 0) levels.triangles[t] = 1;
    else
      for (const int e : mesh.triangles[t].edges) keeps[toIndex(e)] = true;
  }
  for (std::size_t e = 0; e < keeps.size(); ++e) {
    if (!keeps[e]) levels.edges[e] = 1;
  }
  return levels;
}

}  // namespace sinew
