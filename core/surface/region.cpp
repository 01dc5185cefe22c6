// core/surface/region.cpp: regions from bones and from parts.
#include "sinew/surface/region.h"

#include <algorithm>

#include "core/geometry/at.h"

namespace sinew {
namespace {

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

}  // namespace sinew
